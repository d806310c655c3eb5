// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/VolumeMedium.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <stdexcept>

namespace reference
{

namespace
{

constexpr int NumberOfColumns = 4096;
/// Edge length of a block in image cells. Each block has one extinction range.
constexpr int BlockSize = 4;
/// exp(-OpticalDepthOfOpaque) is negligible.
constexpr double OpticalDepthOfOpaque = 700.0;

}

VolumeMedium::VolumeMedium(
  vtkImageData* image, vtkVolumeProperty* property, vtkColorTransferFunction* albedo)
  : Spacing(glm::make_vec3(image->GetSpacing()))
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("the image has no one-component point scalars");
  }
  image->GetDimensions(this->Points.data());
  double range[2];
  scalars->GetRange(range);
  const double column = (range[1] > range[0] ? range[1] - range[0] : 1.0) / (NumberOfColumns - 1);
  for (vtkIdType point = 0; point < scalars->GetNumberOfTuples(); ++point)
  {
    this->Columns.push_back(static_cast<float>((scalars->GetTuple1(point) - range[0]) / column));
  }
  vtkPiecewiseFunction* opacity = property->GetScalarOpacity();
  for (int i = 0; i < NumberOfColumns; ++i)
  {
    const double value = range[0] + i * column;
    const double depth = -std::log1p(-std::min(opacity->GetValue(value), 1.0));
    this->Extinction.push_back(
      std::min(depth, OpticalDepthOfOpaque) / property->GetScalarOpacityUnitDistance());
    glm::dvec3 color;
    if (albedo || property->GetColorChannels() == 3)
    {
      (albedo ? albedo : property->GetRGBTransferFunction())
        ->GetColor(value, glm::value_ptr(color));
    }
    else
    {
      color = glm::dvec3(property->GetGrayTransferFunction()->GetValue(value));
    }
    this->Albedo.push_back(color);
  }
  std::array<int, 3> blocks;
  glm::dvec3 end;
  int extent[6];
  image->GetExtent(extent);
  glm::dvec3 lower;
  for (int axis = 0; axis < 3; ++axis)
  {
    blocks[axis] = std::max((this->Points[axis] - 2) / BlockSize + 1, 1);
    lower[axis] = image->GetOrigin()[axis] + extent[2 * axis] * this->Spacing[axis];
    end[axis] = lower[axis] + blocks[axis] * BlockSize * this->Spacing[axis];
  }
  this->SetCells(lower, end, blocks, this->GetBlockRanges(blocks));
}

std::vector<ExtinctionRange> VolumeMedium::GetBlockRanges(const std::array<int, 3>& blocks) const
{
  std::vector<ExtinctionRange> ranges;
  for (int block = 0; block < blocks[0] * blocks[1] * blocks[2]; ++block)
  {
    const std::array<int, 3> first = { { BlockSize * (block % blocks[0]),
      BlockSize * (block / blocks[0] % blocks[1]), BlockSize * (block / blocks[0] / blocks[1]) } };
    float low = NumberOfColumns;
    float high = 0.0F;
    bool isInside = true;
    for (int corner = 0; corner < (BlockSize + 1) * (BlockSize + 1) * (BlockSize + 1); ++corner)
    {
      const int i = first[0] + corner % (BlockSize + 1);
      const int j = first[1] + corner / (BlockSize + 1) % (BlockSize + 1);
      const int k = first[2] + corner / (BlockSize + 1) / (BlockSize + 1);
      if (i < this->Points[0] && j < this->Points[1] && k < this->Points[2])
      {
        const float value = this->Columns[static_cast<std::size_t>(
          i + this->Points[0] * (j + this->Points[1] * static_cast<vtkIdType>(k)))];
        low = std::min(low, value);
        high = std::max(high, value);
      }
      else
      {
        isInside = false;
      }
    }
    const auto begin = this->Extinction.begin() + static_cast<int>(low);
    const auto end =
      this->Extinction.begin() + std::min(static_cast<int>(high) + 2, NumberOfColumns);
    // A block at the upper boundary of the image may extend beyond it, where the extinction is 0.
    ranges.push_back(
      { isInside ? *std::min_element(begin, end) : 0.0, *std::max_element(begin, end) });
  }
  return ranges;
}

double VolumeMedium::GetColumn(const glm::dvec3& position) const
{
  std::array<vtkIdType, 3> cell;
  glm::dvec3 fraction;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double at = (position[axis] - this->GetLower()[axis]) / this->Spacing[axis];
    if (!(at >= 0.0 && at <= this->Points[axis] - 1))
    {
      return -1.0;
    }
    cell[axis] = std::min(static_cast<int>(at), std::max(this->Points[axis] - 2, 0));
    fraction[axis] = at - static_cast<double>(cell[axis]);
  }
  const vtkIdType row = this->Points[0];
  const vtkIdType layer = row * this->Points[1];
  const float* values = this->Columns.data() + cell[0] + row * cell[1] + layer * cell[2];
  const auto along = [&](const float* at)
  { return at[0] + fraction[0] * (static_cast<double>(at[1]) - at[0]); };
  const auto across = [&](const float* at)
  {
    const double first = along(at);
    return first + fraction[1] * (along(at + row) - first);
  };
  const double first = across(values);
  return first + fraction[2] * (across(values + layer) - first);
}

double VolumeMedium::GetExtinction(const glm::dvec3& position) const
{
  const double column = this->GetColumn(position);
  if (column < 0.0)
  {
    return 0.0;
  }
  const std::size_t i =
    std::min(static_cast<std::size_t>(column), std::size_t(NumberOfColumns - 2));
  const double fraction = column - static_cast<double>(i);
  return (1.0 - fraction) * this->Extinction[i] + fraction * this->Extinction[i + 1];
}

glm::dvec3 VolumeMedium::GetAlbedo(const glm::dvec3& position) const
{
  const double column = std::max(this->GetColumn(position), 0.0);
  const std::size_t i =
    std::min(static_cast<std::size_t>(column), std::size_t(NumberOfColumns - 2));
  const double fraction = column - static_cast<double>(i);
  return (1.0 - fraction) * this->Albedo[i] + fraction * this->Albedo[i + 1];
}

}
