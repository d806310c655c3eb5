// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ImageInterpolator.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <stdexcept>

namespace reference
{

namespace
{

std::array<double, 16> ToRows(vtkMatrix4x4* matrix)
{
  std::array<double, 16> rows;
  std::copy(matrix->GetData(), matrix->GetData() + 16, rows.begin());
  return rows;
}

Double3 Multiply(const std::array<double, 16>& rows, const Double3& vector, double w)
{
  Double3 result;
  for (std::size_t row = 0; row < 3; ++row)
  {
    result[row] = rows[4 * row] * vector[0] + rows[4 * row + 1] * vector[1] +
      rows[4 * row + 2] * vector[2] + rows[4 * row + 3] * w;
  }
  return result;
}

}

ImageInterpolator::ImageInterpolator(
  vtkImageData* image, const ImageArray& array, vtkMatrix4x4* worldFromVolume)
{
  vtkDataSetAttributes* data = image->GetPointData();
  if (array.OfCells)
  {
    data = image->GetCellData();
  }
  vtkDataArray* scalars =
    array.Name.empty() ? data->GetScalars() : data->GetArray(array.Name.c_str());
  if (!scalars || scalars->GetNumberOfComponents() > 4)
  {
    throw std::invalid_argument(
      "the image does not have the array, or the array has more than four components: '" +
      array.Name + "'");
  }
  this->Components = scalars->GetNumberOfComponents();
  this->ColorScale = scalars->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Spacing[axis] = std::abs(image->GetSpacing()[axis]);
  }
  const int* extent = image->GetExtent();
  vtkNew<vtkMatrix4x4> volumeFromIndex;
  volumeFromIndex->DeepCopy(image->GetIndexToPhysicalMatrix());
  double first[4] = { 0.0, 0.0, 0.0, 1.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Size[axis] = extent[2 * axis + 1] - extent[2 * axis] + (array.OfCells ? 0 : 1);
    first[axis] = extent[2 * axis] + (array.OfCells ? 0.5 : 0.0);
  }
  volumeFromIndex->MultiplyPoint(first, first);
  for (int axis = 0; axis < 3; ++axis)
  {
    volumeFromIndex->SetElement(axis, 3, first[axis]);
  }
  this->VolumeFromIndex = ToRows(volumeFromIndex);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(volumeFromIndex);
  if (worldFromVolume)
  {
    vtkMatrix4x4::Multiply4x4(worldFromVolume, volumeFromIndex, matrix);
  }
  matrix->Invert();
  this->IndexFromWorld = ToRows(matrix);

  const vtkIdType tuples = scalars->GetNumberOfTuples();
  bool isFinite = true;
  for (vtkIdType tuple = 0; tuple < tuples; ++tuple)
  {
    bool isTupleFinite = true;
    for (int k = 0; k < this->Components; ++k)
    {
      this->Values.push_back(scalars->GetComponent(tuple, k));
      isTupleFinite = isTupleFinite && std::isfinite(this->Values.back());
    }
    this->Finite.push_back(isTupleFinite ? 1 : 0);
    isFinite = isFinite && isTupleFinite;
  }
  if (isFinite)
  {
    this->Finite.clear();
  }
  for (int k = 0; k < this->Components; ++k)
  {
    double range[2];
    scalars->GetFiniteRange(range, k);
    this->Range[k] = range[1] - range[0];
  }
}

IndexLine ImageInterpolator::ToIndex(const Double3& world, const Double3& direction) const
{
  return { Multiply(this->IndexFromWorld, world, 1.0),
    Multiply(this->IndexFromWorld, direction, 0.0) };
}

Double3 ImageInterpolator::ToVolume(const Double3& index) const
{
  return Multiply(this->VolumeFromIndex, index, 1.0);
}

ImageInterpolator::Sample ImageInterpolator::At(const Double3& index) const
{
  std::array<std::size_t, 3> lower;
  std::array<std::size_t, 3> stride;
  Double3 fraction;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int last = this->Size[axis] - 1;
    const double at = std::min(std::max(index[axis], 0.0), static_cast<double>(last));
    const int floor = std::min(static_cast<int>(at), std::max(last - 1, 0));
    lower[axis] = static_cast<std::size_t>(floor);
    fraction[axis] = at - floor;
    stride[axis] = last > 0 ? 1 : 0;
  }
  const std::size_t width = this->Size[0];
  const std::size_t area = width * this->Size[1];
  const std::size_t first = lower[0] + width * lower[1] + area * lower[2];
  std::array<std::size_t, 8> corners;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    corners[corner] = first + (corner & 1) * stride[0] + (corner >> 1 & 1) * stride[1] * width +
      (corner >> 2) * stride[2] * area;
  }
  return this->Finite.empty() ? this->Interpolate(corners, fraction)
                              : this->InterpolateFinite(corners, fraction);
}

ImageInterpolator::Sample ImageInterpolator::Interpolate(
  const std::array<std::size_t, 8>& corners, const Double3& fraction) const
{
  Sample sample;
  for (int k = 0; k < this->Components; ++k)
  {
    std::array<double, 8> values;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      values[corner] = this->Values[corners[corner] * this->Components + k];
    }
    // This order of operations interpolates equal values exactly.
    std::size_t count = 8;
    for (double t : fraction)
    {
      count /= 2;
      for (std::size_t pair = 0; pair < count; ++pair)
      {
        const double value = values[2 * pair];
        values[pair] = value + t * (values[2 * pair + 1] - value);
      }
    }
    sample.Values[k] = values[0];
  }
  return sample;
}

ImageInterpolator::Sample ImageInterpolator::InterpolateFinite(
  const std::array<std::size_t, 8>& corners, const Double3& fraction) const
{
  Sample sample;
  sample.Finite = 0.0;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const std::size_t tuple = corners[corner];
    double weight = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      weight *= (corner >> axis & 1) != 0 ? fraction[axis] : 1.0 - fraction[axis];
    }
    if (weight > 0.0 && this->Finite[tuple] != 0)
    {
      sample.Finite += weight;
      for (int k = 0; k < this->Components; ++k)
      {
        sample.Values[k] += weight * this->Values[tuple * this->Components + k];
      }
    }
  }
  for (double& value : sample.Values)
  {
    value /= sample.Finite > 0.0 ? sample.Finite : 1.0;
  }
  return sample;
}

double ImageInterpolator::GetSlope(const Double3& index, int component, int axis) const
{
  Double3 before = index;
  Double3 after = index;
  before[axis] -= 1.0;
  after[axis] += 1.0;
  return 0.5 * (this->At(after).Values[component] - this->At(before).Values[component]);
}

double ImageInterpolator::GetMagnitude(const Double3& index, int component) const
{
  const double mean = (this->Spacing[0] + this->Spacing[1] + this->Spacing[2]) / 3.0;
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double change = this->GetSlope(index, component, axis) * mean / this->Spacing[axis];
    sum += change * change;
  }
  return std::min(std::sqrt(sum), 0.25 * this->Range[component]);
}

Double3 ImageInterpolator::GetGradient(const Double3& index, int component) const
{
  Double3 gradient{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const double slope = this->GetSlope(index, component, axis);
    // Gradients transform with the inverse transpose of the matrix that transforms points.
    for (int k = 0; k < 3; ++k)
    {
      gradient[k] += slope * this->IndexFromWorld[4 * axis + k];
    }
  }
  return gradient;
}

bool ImageInterpolator::Cut(const IndexLine& line, double& begin, double& end) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double last = this->Size[axis] - 1;
    if (line.Step[axis] == 0.0)
    {
      if (line.Begin[axis] < 0.0 || line.Begin[axis] > last)
      {
        return false;
      }
      continue;
    }
    const double a = -line.Begin[axis] / line.Step[axis];
    const double b = (last - line.Begin[axis]) / line.Step[axis];
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin < end;
}

}
