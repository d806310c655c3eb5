// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowCoordinates_h
#define interlume_RowCoordinates_h

#include "Grid/RowIndex.h"
#include "Output/ExtractionPoint.h"
#include "Output/Interpolation.h"

#include <algorithm>
#include <array>
#include <vector>

class vtkDataSet;
class vtkImageData;

namespace interlume
{

/**
 * @class   RowCoordinates
 * @brief   point coordinates of image data and rectilinear grids, computed from indices
 *
 * The coordinates are rounded as in the grid's GetPoint().
 */
class RowCoordinates
{
public:
  /// \a input is a vtkImageData or vtkRectilinearGrid.
  explicit RowCoordinates(vtkDataSet* input);

  /// Writes the coordinates of \a number points. This is fast if the edges of successive points
  /// start in the same row.
  template <typename Out>
  void Fill(const ExtractionPoint* points, vtkIdType number, Out* out) const
  {
    // First point and number of points of the row where the previous edge starts.
    vtkIdType first = 0;
    vtkIdType length = 0;
    std::array<int, 3> at{};
    for (vtkIdType p = 0; p < number; ++p, out += 3)
    {
      const ExtractionPoint& point = points[p];
      if (this->Rotated)
      {
        double x[3];
        this->GetRotatedPoint(point, x);
        std::transform(x, x + 3, out, [](double value) { return static_cast<Out>(value); });
        continue;
      }
      const vtkIdType lower = std::min(point.Near, point.Far);
      if (lower < first || lower >= first + length)
      {
        at = this->Rows.GetIjk(lower);
        first = lower - at[0];
        length = static_cast<vtkIdType>(this->Axes[0].size());
      }
      at[0] = static_cast<int>(lower - first);
      for (int axis = 0; axis < 3; ++axis)
      {
        out[axis] = static_cast<Out>(this->Axes[axis][at[axis]]);
      }
      if (point.Near != point.Far)
      {
        const int axis = this->Rows.GetAxis(point.Near, point.Far);
        const double* const ends = this->Axes[axis].data() + at[axis];
        const int near = point.Near > lower;
        out[axis] = static_cast<Out>(
          Interpolation::Between<double>(ends[near], ends[1 - near], point.Weight));
      }
    }
  }

private:
  void GetRotatedPoint(const ExtractionPoint& point, double x[3]) const;

  RowIndex Rows;
  std::array<std::vector<double>, 3> Axes;
  // The image if its direction matrix is not the identity, otherwise null.
  vtkImageData* Rotated = nullptr;
};

}

#endif
