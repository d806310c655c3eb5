// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays/RowCoordinates.h"

#include "Arrays/ExtractionArrays.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkRectilinearGrid.h"

namespace interlume
{

namespace
{
std::array<int, 3> GetDimensions(vtkDataSet* input)
{
  std::array<int, 3> dimensions{};
  ExtractionArrays::GetRowDimensions(input, dimensions.data());
  return dimensions;
}
}

RowCoordinates::RowCoordinates(vtkDataSet* input)
  : Rows(GetDimensions(input).data())
{
  const std::array<int, 3> dimensions = GetDimensions(input);
  if (vtkImageData* image = vtkImageData::SafeDownCast(input))
  {
    const int* extent = image->GetExtent();
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < dimensions[axis]; ++i)
      {
        this->Axes[axis].push_back(
          image->GetOrigin()[axis] + (extent[2 * axis] + i) * image->GetSpacing()[axis]);
      }
    }
    this->Rotated = image->GetDirectionMatrix()->IsIdentity() ? nullptr : image;
    return;
  }
  vtkRectilinearGrid* grid = vtkRectilinearGrid::SafeDownCast(input);
  vtkDataArray* axes[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < dimensions[axis]; ++i)
    {
      this->Axes[axis].push_back(axes[axis]->GetComponent(i, 0));
    }
  }
}

void RowCoordinates::GetRotatedPoint(const ExtractionPoint& point, double x[3]) const
{
  this->Rotated->GetPoint(point.Near, x);
  if (point.Near != point.Far)
  {
    double end[3];
    this->Rotated->GetPoint(point.Far, end);
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = Interpolation::Between<double>(x[axis], end[axis], point.Weight);
    }
  }
}

}
