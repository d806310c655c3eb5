// SPDX-License-Identifier: BSD-3-Clause
#include "Offscreen/CroppingRegions.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace interlume
{

namespace
{
constexpr int NumberOfRegions = 27;
constexpr double Infinity = std::numeric_limits<double>::infinity();

using Range = std::array<int, 2>;

/// Returns the index of a region along an axis, 0 to 2.
int GetIndex(int region, int axis)
{
  constexpr int steps[3] = { 1, 3, 9 };
  return region / steps[axis] % 3;
}

bool IsAmong(int flags, int region)
{
  return (flags >> region & 1) != 0;
}

/// Returns the indices of the first and last visible region along an axis.
Range FindRange(int flags, int axis)
{
  Range range{ { 2, 0 } };
  for (int region = 0; region < NumberOfRegions; ++region)
  {
    if (IsAmong(flags, region))
    {
      const int index = GetIndex(region, axis);
      range = { { std::min(range[0], index), std::max(range[1], index) } };
    }
  }
  return range;
}

bool IsWithin(int region, const std::array<Range, 3>& ranges)
{
  bool isWithin = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int index = GetIndex(region, axis);
    isWithin = isWithin && index >= ranges[axis][0] && index <= ranges[axis][1];
  }
  return isWithin;
}
}

CroppingRegions::CroppingRegions(
  const std::array<double, 6>& planes, int flags, const Matrix& linesToVolume)
  : Flags(flags & All)
{
  std::array<Range, 3> retained{};
  for (int axis = 0; axis < 3; ++axis)
  {
    // A region's index is the number of thresholds below it, so the mapper's planes may be in any
    // order.
    const auto [lower, upper] = std::minmax(planes[2 * axis], planes[2 * axis + 1]);
    const double* row = linesToVolume.data() + 4 * axis;
    const double length = std::hypot(row[0], row[1], row[2]);
    this->Axes[axis] = { { row[0] / length, row[1] / length, row[2] / length } };
    const auto toLines = [row, length](double bound) { return (bound - row[3]) / length; };
    this->Thresholds[axis] = { { toLines(lower), toLines(upper) } };
    // If no region is visible, no bounds are needed, because the flags remove everything.
    retained[axis] = this->Flags == 0 ? Range{ { 0, 2 } } : FindRange(this->Flags, axis);
    const std::array<double, 4> borders{ { -Infinity, lower, upper, Infinity } };
    this->VolumeBounds[axis] = { { borders[retained[axis][0]], borders[retained[axis][1] + 1] } };
    this->Bounds[axis] = { { toLines(this->VolumeBounds[axis][0]),
      toLines(this->VolumeBounds[axis][1]) } };
  }
  for (int region = 0; region < NumberOfRegions; ++region)
  {
    this->IsGapped =
      this->IsGapped || (!IsAmong(this->Flags, region) && IsWithin(region, retained));
  }
}

void CroppingRegions::Cut(const Matrix& boxToVolume, Box& box, Planes& planes) const
{
  const auto isZero = [](double value) { return value == 0.0; };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* row = boxToVolume.data() + 4 * axis;
    const bool isAligned = std::count_if(row, row + 3, isZero) == 2;
    const std::ptrdiff_t along = std::find_if_not(row, row + 3, isZero) - row;
    for (int side = 0; side < 2; ++side)
    {
      const double sign = side == 0 ? 1.0 : -1.0;
      if (sign * this->VolumeBounds[axis][side] == -Infinity)
      {
        continue;
      }
      if (isAligned)
      {
        const double bound = (this->VolumeBounds[axis][side] - row[3]) / row[along];
        std::array<double, 2>& range = box[along];
        const bool isLower = sign * row[along] > 0.0;
        range[0] = isLower ? std::max(range[0], bound) : range[0];
        range[1] = isLower ? range[1] : std::min(range[1], bound);
      }
      else
      {
        const std::array<double, 3>& normal = this->Axes[axis];
        planes.push_back({ { sign * normal[0], sign * normal[1], sign * normal[2],
          -sign * this->Bounds[axis][side] } });
      }
    }
  }
}

bool CroppingRegions::IsRetained(const std::array<double, 3>& position) const
{
  int region = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const std::array<double, 3>& normal = this->Axes[axis];
    const double height = std::inner_product(normal.begin(), normal.end(), position.begin(), 0.0);
    region = 3 * region + (height >= this->Thresholds[axis][0] ? 1 : 0) +
      (height > this->Thresholds[axis][1] ? 1 : 0);
  }
  return IsAmong(this->Flags, region);
}

std::vector<double> CroppingRegions::GetKey() const
{
  std::vector<double> key{ static_cast<double>(this->Flags) };
  for (int axis = 0; axis < 3; ++axis)
  {
    key.insert(key.end(), this->Axes[axis].begin(), this->Axes[axis].end());
    key.insert(key.end(), this->Thresholds[axis].begin(), this->Thresholds[axis].end());
  }
  return key;
}

void CroppingRegions::SetUniforms(vtkShaderProgram* program) const
{
  float axes[9];
  float lower[3];
  float upper[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    std::copy_n(this->Axes[axis].begin(), 3, axes + 3 * axis);
    lower[axis] = static_cast<float>(this->Thresholds[axis][0]);
    upper[axis] = static_cast<float>(this->Thresholds[axis][1]);
  }
  program->SetUniformMatrix3x3("croppingAxes", axes);
  program->SetUniform3f("croppingLower", lower);
  program->SetUniform3f("croppingUpper", upper);
  program->SetUniformi("croppingFlags", this->Flags);
}

}
