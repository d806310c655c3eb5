// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtentRows_h
#define interlume_ExtentRows_h

#include "Common/Batches.h"

#include "vtkImageData.h"

namespace interlume
{

/**
 * Processes the rows of an extent (lines of points along i) in parallel.
 */
namespace ExtentRows
{
/// Calls \a makeRow(j, k, point) for all rows. \a point is the id of the row's first point. See
/// Batches::Run for progress and abort.
template <typename MakeRow>
bool Run(const int extent[6], vtkAlgorithm* owner, double start, double end, const MakeRow& makeRow)
{
  const vtkIdType length = extent[1] - extent[0] + 1;
  const vtkIdType rowsOfLayer = extent[3] - extent[2] + 1;
  const vtkIdType rows = rowsOfLayer * (extent[5] - extent[4] + 1);
  const auto makeRows = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType row = first; row < last; ++row)
    {
      makeRow(static_cast<int>(extent[2] + row % rowsOfLayer),
        static_cast<int>(extent[4] + row / rowsOfLayer), row * length);
    }
  };
  return Batches::Run(rows, owner, start, end, makeRows);
}

/// Calls \a makePoint(x, point) for the position and id of each point of an image.
template <typename MakePoint>
bool RunPoints(vtkImageData* image, vtkAlgorithm* owner, const MakePoint& makePoint)
{
  const int* extent = image->GetExtent();
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  const auto makeRow = [&](int j, int k, vtkIdType point)
  {
    double x[3] = { 0.0, origin[1] + j * spacing[1], origin[2] + k * spacing[2] };
    for (int i = extent[0]; i <= extent[1]; ++i, ++point)
    {
      x[0] = origin[0] + i * spacing[0];
      makePoint(x, point);
    }
  };
  return Run(extent, owner, 0.0, 1.0, makeRow);
}
}

}

#endif
