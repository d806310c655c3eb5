// SPDX-License-Identifier: BSD-3-Clause
#ifndef TrilinearRegion_h
#define TrilinearRegion_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

/**
 * @class   TrilinearRegion
 * @brief   the exact region { lower <= g <= upper } of the trilinear interpolant g of an image
 *
 * A reference for tests of accuracy, which shares no code with the filters. It is computed in
 * double precision from the values at the eight corners of each cell.
 */
class TrilinearRegion
{
public:
  explicit TrilinearRegion(vtkImageData* image);

  /**
   * Returns the volume of { lower <= g <= upper }. In each cell, g is linear along z, so a line
   * along z has a closed-form length inside the region. A Gauss rule with 3 x 3 points integrates
   * this length over x and y. The length has kinks where an isosurface crosses the bottom or top
   * face of the cell; squares that may contain a kink are subdivided up to \a depth times.
   */
  double GetVolume(double lower, double upper, int depth = 4) const;

  /**
   * Returns the distance of \a point from the isosurface g = \a value, measured along the gradient
   * of g.
   */
  double GetDistance(const double point[3], double value) const;

  /**
   * Returns whether all three points are on the same face of the image's bounding box.
   */
  bool AreOnSameBoxFace(const double a[3], const double b[3], const double c[3]) const;

private:
  using Corners = std::array<double, 8>;

  Corners GetCorners(int i, int j, int k) const;
  double Evaluate(const double point[3], double gradient[3]) const;

  std::array<int, 3> Dimensions;
  std::array<double, 3> Origin;
  std::array<double, 3> Spacing;
  std::vector<double> Values;
};

#endif
