// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/VolumeSamples.h"

#include "Common/ParallelFor.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayAccessor.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkSOADataArrayTemplate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>

namespace interlume
{

namespace
{
constexpr vtkIdType Grain = 1 << 16;
constexpr int LargestComponents = 4;
constexpr double Infinity = std::numeric_limits<double>::infinity();

using StructuresOfArrays = vtkTypeList::Create<vtkSOADataArrayTemplate<char>,
  vtkSOADataArrayTemplate<signed char>, vtkSOADataArrayTemplate<unsigned char>,
  vtkSOADataArrayTemplate<short>, vtkSOADataArrayTemplate<unsigned short>,
  vtkSOADataArrayTemplate<int>, vtkSOADataArrayTemplate<unsigned int>,
  vtkSOADataArrayTemplate<long>, vtkSOADataArrayTemplate<unsigned long>,
  vtkSOADataArrayTemplate<long long>, vtkSOADataArrayTemplate<unsigned long long>,
  vtkSOADataArrayTemplate<float>, vtkSOADataArrayTemplate<double>>;

/// Calls \a function with the array's concrete type, or with vtkDataArray for unknown types.
template <typename Function>
void Dispatch(vtkDataArray* array, Function&& function)
{
  if (!vtkArrayDispatch::Dispatch::Execute(array, function) &&
    !vtkArrayDispatch::DispatchByArray<StructuresOfArrays>::Execute(array, function))
  {
    function(array);
  }
}

/// Reads the components of a voxel. Returns true if all are finite.
template <typename Array>
bool GetVoxel(const vtkDataArrayAccessor<Array>& values, vtkIdType voxel, int components,
  std::array<double, LargestComponents>& value)
{
  bool finite = true;
  for (int c = 0; c < components; ++c)
  {
    value[c] = static_cast<double>(values.Get(voxel, c));
    finite = finite && std::isfinite(value[c]);
  }
  return finite;
}

struct Extent
{
  std::array<std::array<double, 2>, LargestComponents> Range;
  vtkIdType NonFinite = 0;

  Extent() { this->Range.fill({ { Infinity, -Infinity } }); }

  void Add(double value, int component)
  {
    if (std::isfinite(value))
    {
      this->Range[component][0] = std::min(this->Range[component][0], value);
      this->Range[component][1] = std::max(this->Range[component][1], value);
    }
  }
};

template <typename Array>
void AddExtent(Array* array, vtkIdType begin, vtkIdType end, Extent& extent)
{
  const vtkDataArrayAccessor<Array> values(array);
  const int components = array->GetNumberOfComponents();
  std::array<double, LargestComponents> value{};
  for (vtkIdType voxel = begin; voxel < end; ++voxel)
  {
    extent.NonFinite += GetVoxel(values, voxel, components, value) ? 0 : 1;
    for (int c = 0; c < components; ++c)
    {
      extent.Add(value[c], c);
    }
  }
}

Extent FindExtent(vtkDataArray* array, vtkIdType voxels)
{
  vtkSMPThreadLocal<Extent> parts;
  vtkSMPTools::For(0, voxels, Grain,
    [&](vtkIdType begin, vtkIdType end)
    { Dispatch(array, [&](auto* values) { AddExtent(values, begin, end, parts.Local()); }); });
  Extent total;
  for (const Extent& part : parts)
  {
    total.NonFinite += part.NonFinite;
    for (int c = 0; c < LargestComponents; ++c)
    {
      total.Add(part.Range[c][0], c);
      total.Add(part.Range[c][1], c);
    }
  }
  return total;
}

/// Writes the texels, which are (value - Offset) * \a factors for each component, and the mask if
/// it is not empty.
template <typename Texel, typename Array>
void WriteTexels(Array* array, vtkIdType begin, vtkIdType end,
  const std::array<double, LargestComponents>& factors, VolumeSamples& samples)
{
  const vtkDataArrayAccessor<Array> values(array);
  const int components = samples.Components;
  auto* texels = reinterpret_cast<Texel*>(samples.Texels.data());
  std::array<double, LargestComponents> value{};
  for (vtkIdType voxel = begin; voxel < end; ++voxel)
  {
    const bool finite = GetVoxel(values, voxel, components, value);
    for (int c = 0; c < components; ++c)
    {
      texels[voxel * components + c] =
        finite ? static_cast<Texel>((value[c] - samples.Offset[c]) * factors[c]) : Texel(0);
    }
    if (!samples.Mask.empty())
    {
      samples.Mask[static_cast<std::size_t>(voxel)] = finite ? 65535 : 0;
    }
  }
}

/// Returns 0 if the smallest magnitude in the range is at most the range's width, otherwise the
/// center of the range. The difference between a float in the range and this center is exactly
/// representable as a float.
double FindOffset(const std::array<double, 2>& range)
{
  const double smallest = std::max({ range[0], -range[1], 0.0 });
  if (smallest == 0.0 || smallest <= range[1] - range[0])
  {
    return 0.0;
  }
  return range[0] + 0.5 * (range[1] - range[0]);
}

/// Returns the largest power of two that does not exceed the largest difference from the offset.
double FindScale(const std::array<double, 2>& range, double offset)
{
  // With smaller exponents, ratios of scales and ranges would overflow double precision.
  constexpr int minimumExponent = -1000;
  double largest = std::max(std::abs(range[0] - offset), std::abs(range[1] - offset));
  largest = largest > 0.0 ? largest : std::abs(offset);
  return largest > 0.0 ? std::ldexp(1.0, std::max(std::ilogb(largest), minimumExponent)) : 1.0;
}
}

Error VolumeSamples::Build(vtkDataArray* array, const std::array<int, 3>& size, bool widens)
{
  *this = VolumeSamples();
  if (!array || size[0] < 1 || size[1] < 1 || size[2] < 1)
  {
    return "The volume has no scalar values.";
  }
  const std::string name = array->GetName() ? array->GetName() : "(unnamed)";
  const int components = array->GetNumberOfComponents();
  if (components < 1 || components > LargestComponents)
  {
    return "The array '" + name + "' has " + std::to_string(components) +
      " components. One to four are supported.";
  }
  const vtkIdType voxels = static_cast<vtkIdType>(size[0]) * size[1] * size[2];
  if (array->GetNumberOfTuples() < voxels)
  {
    return "The array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) +
      " values for " + std::to_string(voxels) + " voxels.";
  }

  const Extent extent = FindExtent(array, voxels);
  // All types of up to 16 bits are integers. VTK reports a size of 0 for VTK_BIT.
  const int typeBytes = std::max(vtkDataArray::GetDataTypeSize(array->GetDataType()), 1);
  const double lowest = vtkDataArray::GetDataTypeMin(array->GetDataType());
  this->Format = typeBytes > 2 ? FLOAT32 : typeBytes == 1 && !widens ? UNORM8 : UNORM16;
  for (int c = 0; c < components; ++c)
  {
    const bool any = extent.Range[c][0] <= extent.Range[c][1];
    // Adding 0 turns -0 into 0. Which of the two is found depends on the order of the values.
    this->Range[c] = any
      ? std::array<double, 2>{ { extent.Range[c][0] + 0.0, extent.Range[c][1] + 0.0 } }
      : std::array<double, 2>{ { 0.0, 0.0 } };
    this->Offset[c] = this->Format == FLOAT32 ? FindOffset(this->Range[c]) : lowest;
    this->Scale[c] = this->Format == FLOAT32 ? FindScale(this->Range[c], this->Offset[c])
                                             : (1 << (8 * typeBytes)) - 1;
  }

  const std::size_t bytes = this->Format == UNORM8 ? 1 : this->Format == UNORM16 ? 2 : 4;
  try
  {
    this->Texels.resize(static_cast<std::size_t>(voxels * components) * bytes);
    this->Mask.resize(extent.NonFinite > 0 ? static_cast<std::size_t>(voxels) : 0);
  }
  catch (const std::bad_alloc&)
  {
    *this = VolumeSamples();
    return Error(
      "There is not enough memory for a copy of the array '" + name + "'.", ErrorCode::OutOfMemory);
  }
  this->Size = size;
  this->Components = components;
  this->NonFinite = extent.NonFinite;

  // 257 * byte is the same fraction of 65535 as byte is of 255.
  const double integerFactor = typeBytes == 1 && this->Format == UNORM16 ? 257.0 : 1.0;
  std::array<double, LargestComponents> factors{};
  for (int c = 0; c < components; ++c)
  {
    factors[c] = this->Format == FLOAT32 ? 1.0 / this->Scale[c] : integerFactor;
  }
  vtkSMPTools::For(0, voxels, Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      Dispatch(array,
        [&](auto* values)
        {
          switch (this->Format)
          {
            case UNORM8:
              WriteTexels<std::uint8_t>(values, begin, end, factors, *this);
              break;
            case UNORM16:
              WriteTexels<std::uint16_t>(values, begin, end, factors, *this);
              break;
            case FLOAT32:
              WriteTexels<float>(values, begin, end, factors, *this);
              break;
          }
        });
    });
  return {};
}

std::vector<float> VolumeSamples::FindDifferences() const
{
  const auto rows = static_cast<vtkIdType>(this->Size[1]) * this->Size[2];
  const std::array<vtkIdType, 3> steps{ { 1, this->Size[0],
    static_cast<vtkIdType>(this->Size[0]) * this->Size[1] } };
  std::vector<float> differences(static_cast<std::size_t>(3 * rows * this->Size[0]));
  const auto find = [&](const auto* texels, float scale)
  {
    ParallelFor(0, rows,
      [&](vtkIdType row)
      {
        std::array<int, 3> position{ { 0, static_cast<int>(row % this->Size[1]),
          static_cast<int>(row / this->Size[1]) } };
        for (vtkIdType voxel = row * this->Size[0]; position[0] < this->Size[0]; ++voxel)
        {
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            const bool isFirst = position[axis] == 0;
            const bool isLast = position[axis] + 1 == this->Size[axis];
            differences[static_cast<std::size_t>(3 * voxel) + axis] = scale *
              (static_cast<float>(texels[voxel + (isLast ? 0 : steps[axis])]) -
                static_cast<float>(texels[voxel - (isFirst ? 0 : steps[axis])]));
          }
          ++position[0];
        }
      });
  };
  if (this->Format == FLOAT32)
  {
    find(reinterpret_cast<const float*>(this->Texels.data()), 1.0F);
  }
  else
  {
    find(reinterpret_cast<const std::uint16_t*>(this->Texels.data()), 1.0F / 65535.0F);
  }
  return differences;
}

}
