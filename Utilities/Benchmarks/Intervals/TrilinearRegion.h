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
 * A reference that shares no code with the filters: everything is computed in double from the
 * values at the eight corners of a cell.
 */
class TrilinearRegion
{
public:
  explicit TrilinearRegion(vtkImageData* image);

  /**
   * The volume of { lower <= g <= upper }. Along z the interpolant is linear, so the length inside
   * is known in closed form; across x and y it is integrated by Gauss' rule of 3 x 3 points on a
   * square that is halved \a depth times where the length has a kink (a face or an edge of the cell
   * is crossed).
   */
  double GetVolume(double lower, double upper, int depth = 4) const;

  /**
   * How far \a point is from { g = value }, along the gradient of g.
   */
  double GetDistance(const double point[3], double value) const;

  /**
   * Whether all three points lie in one face of the image's box.
   */
  bool IsOnBox(const double a[3], const double b[3], const double c[3]) const;

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
