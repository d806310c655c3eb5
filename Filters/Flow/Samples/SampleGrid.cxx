// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SampleGrid.h"

#include "Cells/MultilinearCell.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace interlume
{

namespace
{
using Size = std::array<vtkIdType, 3>;

vtkIdType GetNumber(const Size& size)
{
  return size[0] * size[1] * size[2];
}

Size GetSize(const int extent[6])
{
  return { { extent[1] - extent[0] + 1, extent[3] - extent[2] + 1, extent[5] - extent[4] + 1 } };
}

/// Returns the stride of the samples along each direction of a grid with the given numbers of
/// points.
Size GetStrides(const Size& points)
{
  Size strides{ { 1, 1, 1 } };
  const auto left = [&](int axis)
  { return points[axis] > 1 ? (points[axis] - 2) / strides[axis] + 2 : points[axis]; };
  while (GetNumber({ { left(0), left(1), left(2) } }) > SampleGrid::MaximumPoints)
  {
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      longest = left(axis) > left(longest) ? axis : longest;
    }
    ++strides[longest];
  }
  return strides;
}

/// Returns the indices of the samples along a direction with \a points points.
std::vector<vtkIdType> GetRow(vtkIdType points, vtkIdType stride)
{
  std::vector<vtkIdType> indices;
  for (vtkIdType index = 0; index < points - 1; index += stride)
  {
    indices.push_back(index);
  }
  indices.push_back(points - 1);
  return indices;
}

vtkSmartPointer<vtkDataSet> SubsampleImage(vtkImageData* field, const int extent[6])
{
  const vtkSmartPointer<vtkImageData> image = vtkSmartPointer<vtkImageData>::New();
  int before[6];
  field->GetExtent(before);
  const int first[3] = { before[0], before[2], before[4] };
  double origin[3];
  field->TransformIndexToPhysicalPoint(first, origin);
  double spacing[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int intervals = extent[2 * axis + 1];
    spacing[axis] = field->GetSpacing()[axis] *
      (intervals > 0 ? double(before[2 * axis + 1] - before[2 * axis]) / intervals : 1.0);
  }
  image->SetOrigin(origin);
  image->SetSpacing(spacing);
  image->SetDirectionMatrix(field->GetDirectionMatrix());
  image->SetExtent(const_cast<int*>(extent));
  return image;
}

/// Returns the ids of the field's points that are samples.
vtkSmartPointer<vtkIdList> GetIds(
  const Size& points, const std::array<std::vector<vtkIdType>, 3>& indices)
{
  vtkSmartPointer<vtkIdList> ids = vtkSmartPointer<vtkIdList>::New();
  for (const vtkIdType k : indices[2])
  {
    for (const vtkIdType j : indices[1])
    {
      for (const vtkIdType i : indices[0])
      {
        ids->InsertNextId(i + points[0] * (j + points[1] * k));
      }
    }
  }
  return ids;
}

void CopyPointData(vtkDataSet* field, vtkIdList* ids, vtkDataSet* samples)
{
  vtkPointData* data = samples->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(field->GetPointData(), ids->GetNumberOfIds());
  vtkNew<vtkIdList> rows;
  rows->SetNumberOfIds(ids->GetNumberOfIds());
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    rows->SetId(i, i);
  }
  data->CopyData(field->GetPointData(), ids, rows);
}

vtkSmartPointer<vtkDataArray> Choose(
  vtkDataArray* coordinates, const std::vector<vtkIdType>& indices)
{
  auto chosen = vtk::TakeSmartPointer(coordinates->NewInstance());
  chosen->SetNumberOfTuples(static_cast<vtkIdType>(indices.size()));
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    chosen->SetTuple(static_cast<vtkIdType>(i), indices[i], coordinates);
  }
  return chosen;
}

vtkSmartPointer<vtkDataSet> SubsampleGrid(
  vtkDataSet* field, const int before[6], const int extent[6])
{
  const std::array<std::vector<vtkIdType>, 3> indices = SampleGrid::GetIndices(before);
  const vtkSmartPointer<vtkIdList> ids = GetIds(GetSize(before), indices);
  int sampleExtent[6];
  std::copy_n(extent, 6, sampleExtent);
  vtkSmartPointer<vtkDataSet> samples;
  if (vtkRectilinearGrid* rectilinear = vtkRectilinearGrid::SafeDownCast(field))
  {
    const vtkSmartPointer<vtkRectilinearGrid> grid = vtkSmartPointer<vtkRectilinearGrid>::New();
    grid->SetExtent(sampleExtent);
    grid->SetXCoordinates(Choose(rectilinear->GetXCoordinates(), indices[0]));
    grid->SetYCoordinates(Choose(rectilinear->GetYCoordinates(), indices[1]));
    grid->SetZCoordinates(Choose(rectilinear->GetZCoordinates(), indices[2]));
    samples = grid;
  }
  else
  {
    const vtkSmartPointer<vtkStructuredGrid> grid = vtkSmartPointer<vtkStructuredGrid>::New();
    vtkPoints* all = vtkStructuredGrid::SafeDownCast(field)->GetPoints();
    vtkNew<vtkPoints> chosen;
    chosen->SetDataType(all->GetDataType());
    all->GetPoints(ids, chosen);
    grid->SetExtent(sampleExtent);
    grid->SetPoints(chosen);
    samples = grid;
  }
  CopyPointData(field, ids, samples);
  return samples;
}
}

void SampleGrid::GetExtent(const int field[6], int samples[6])
{
  std::copy_n(field, 6, samples);
  const Size points = GetSize(field);
  if (GetNumber(points) <= MaximumPoints)
  {
    return;
  }
  const Size strides = GetStrides(points);
  for (int axis = 0; axis < 3; ++axis)
  {
    samples[2 * axis] = 0;
    samples[2 * axis + 1] = static_cast<int>(GetRow(points[axis], strides[axis]).size()) - 1;
  }
}

std::array<std::vector<vtkIdType>, 3> SampleGrid::GetIndices(const int field[6])
{
  const Size points = GetSize(field);
  const Size strides = GetStrides(points);
  std::array<std::vector<vtkIdType>, 3> indices;
  for (int axis = 0; axis < 3; ++axis)
  {
    indices[axis] = GetRow(points[axis], strides[axis]);
  }
  return indices;
}

vtkSmartPointer<vtkDataSet> SampleGrid::MakeVoxels(const double bounds[6])
{
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, bounds[2 * axis + 1] - bounds[2 * axis]);
  }
  // The voxels are nearly cubic. If the bounds have no extent along a direction, there is one layer
  // of voxels.
  double lengths[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    lengths[axis] = std::max(bounds[2 * axis + 1] - bounds[2 * axis], 1e-3 * longest);
  }
  double volume = lengths[0] * lengths[1] * lengths[2];
  if (!std::isnormal(volume))
  {
    const double scale = MultilinearCell::GetScale(longest);
    volume = 1.0;
    for (double& length : lengths)
    {
      length *= scale;
      volume *= length;
    }
  }
  const double edge = std::cbrt(volume / static_cast<double>(MaximumPoints));
  Size size{ { 2, 2, 2 } };
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = std::max<vtkIdType>(2, static_cast<vtkIdType>(lengths[axis] / edge));
  }
  const vtkSmartPointer<vtkUnstructuredGrid> grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(GetNumber(size));
  vtkNew<vtkCellArray> cells;
  for (vtkIdType k = 0; k < size[2]; ++k)
  {
    for (vtkIdType j = 0; j < size[1]; ++j)
    {
      for (vtkIdType i = 0; i < size[0]; ++i)
      {
        const vtkIdType index[3] = { i, j, k };
        const vtkIdType id = i + size[0] * (j + size[1] * k);
        double x[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          const double fraction = static_cast<double>(index[axis]) / (size[axis] - 1);
          x[axis] = bounds[2 * axis] + fraction * (bounds[2 * axis + 1] - bounds[2 * axis]);
        }
        points->SetPoint(id, x);
        if (i + 1 < size[0] && j + 1 < size[1] && k + 1 < size[2])
        {
          const vtkIdType row = size[0];
          const vtkIdType layer = size[0] * size[1];
          cells->InsertNextCell({ id, id + 1, id + row, id + row + 1, id + layer, id + layer + 1,
            id + layer + row, id + layer + row + 1 });
        }
      }
    }
  }
  grid->SetPoints(points);
  grid->SetCells(VTK_VOXEL, cells);
  return grid;
}

vtkSmartPointer<vtkDataSet> SampleGrid::Make(vtkDataSet* field)
{
  if (field->GetNumberOfPoints() <= MaximumPoints)
  {
    return field;
  }
  int before[6] = { 0, -1, 0, -1, 0, -1 };
  if (vtkImageData* image = vtkImageData::SafeDownCast(field))
  {
    image->GetExtent(before);
  }
  else if (vtkRectilinearGrid* rectilinear = vtkRectilinearGrid::SafeDownCast(field))
  {
    rectilinear->GetExtent(before);
  }
  else if (vtkStructuredGrid* structured = vtkStructuredGrid::SafeDownCast(field))
  {
    structured->GetExtent(before);
  }
  else
  {
    return MakeVoxels(field->GetBounds());
  }
  int extent[6];
  GetExtent(before, extent);
  vtkImageData* image = vtkImageData::SafeDownCast(field);
  return image ? SubsampleImage(image, extent) : SubsampleGrid(field, before, extent);
}

}
