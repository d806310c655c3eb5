// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/ExtinctionSampler.h"

#include "Plan/ClipRegion.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"
#include "Volume/MaterialTable.h"
#include "Volume/VolumeBlocks.h"
#include "Volume/VolumeSamples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace interlume
{

namespace
{
// Position of a value in a table: the column before it, and the fraction of the distance to the
// next column.
struct Column
{
  Column(double value, const std::array<double, 2>& range)
  {
    constexpr double last = MaterialTable::Columns - 1;
    const double position =
      std::clamp((value - range[0]) / (range[1] - range[0]) * last, 0.0, last);
    this->First = std::min(static_cast<std::size_t>(position), static_cast<std::size_t>(last) - 1);
    this->Fraction = position - static_cast<double>(this->First);
  }

  double Interpolate(
    const std::vector<float>& table, int row, std::size_t stride, std::size_t channel) const
  {
    const std::size_t at = (static_cast<std::size_t>(row) * MaterialTable::Columns + this->First);
    const double a = table[at * stride + channel];
    return a + this->Fraction * (table[(at + 1) * stride + channel] - a);
  }

  std::size_t First;
  double Fraction;
};
}

ExtinctionSampler::ExtinctionSampler(const ExtinctionGrid::Volume& volume)
  : Volume(volume)
{
}

template <typename Texel>
glm::dvec4 ExtinctionSampler::Interpolate(const glm::dvec3& inTexture, double& validFraction) const
{
  const VolumeSamples& samples = this->Volume.Samples;
  const auto* texels = reinterpret_cast<const Texel*>(samples.Texels.data());
  std::array<std::array<std::size_t, 2>, 3> index;
  glm::dvec3 part;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int size = samples.Size[axis];
    const double position = std::clamp(inTexture[axis] * size - 0.5, 0.0, size - 1.0);
    const int first = std::min(static_cast<int>(position), std::max(size - 2, 0));
    part[axis] = position - first;
    index[axis] = { { static_cast<std::size_t>(first),
      static_cast<std::size_t>(std::min(first + 1, size - 1)) } };
  }
  glm::dvec4 sum(0.0);
  validFraction = samples.Mask.empty() ? 1.0 : 0.0;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::array<std::size_t, 3> at{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isUpper = (corner >> axis & 1u) != 0;
      weight *= isUpper ? part[axis] : 1.0 - part[axis];
      at[axis] = index[axis][isUpper];
    }
    const std::size_t voxel = at[0] +
      static_cast<std::size_t>(samples.Size[0]) *
        (at[1] + static_cast<std::size_t>(samples.Size[1]) * at[2]);
    for (int c = 0; c < samples.Components; ++c)
    {
      sum[c] += weight *
        texels[voxel * static_cast<std::size_t>(samples.Components) + static_cast<std::size_t>(c)];
    }
    validFraction += samples.Mask.empty() || samples.Mask[voxel] == 0 ? 0.0 : weight;
  }
  const double maximum = std::numeric_limits<Texel>::is_integer
    ? static_cast<double>(std::numeric_limits<Texel>::max())
    : 1.0;
  return sum / (maximum * std::max(validFraction, 1e-6));
}

glm::dvec4 ExtinctionSampler::GetValues(const glm::dvec3& inTexture, double& validFraction) const
{
  const VolumeSamples& samples = this->Volume.Samples;
  glm::dvec4 texel = samples.Format == VolumeSamples::UNORM8
    ? this->Interpolate<std::uint8_t>(inTexture, validFraction)
    : samples.Format == VolumeSamples::UNORM16
    ? this->Interpolate<std::uint16_t>(inTexture, validFraction)
    : this->Interpolate<float>(inTexture, validFraction);
  for (int c = 0; c < samples.Components; ++c)
  {
    texel[c] = samples.Offset[c] + samples.Scale[c] * texel[c];
  }
  return texel;
}

bool ExtinctionSampler::IsInRegion(const glm::dvec3& position, const glm::dvec3& inTexture) const
{
  const ClipRegion& region = this->Volume.Region;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(inTexture[axis] >= region.Box[axis][0] && inTexture[axis] <= region.Box[axis][1]))
    {
      return false;
    }
  }
  for (const std::array<double, 4>& plane : region.ClippingPlanes)
  {
    if (plane[0] * position.x + plane[1] * position.y + plane[2] * position.z + plane[3] < 0.0)
    {
      return false;
    }
  }
  return !region.Regions.HasGaps() ||
    region.Regions.IsRetained({ { position.x, position.y, position.z } });
}

double ExtinctionSampler::GetGradient(
  const glm::dvec3& inTexture, const glm::dvec4& here, int component) const
{
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 offset(0.0);
    offset[axis] = 1.0 / this->Volume.Samples.Size[axis];
    double validFraction = 0.0;
    const glm::dvec4 before = this->GetValues(inTexture - offset, validFraction);
    const double lower = validFraction > 0.0 ? before[component] : here[component];
    const glm::dvec4 after = this->GetValues(inTexture + offset, validFraction);
    const double upper = validFraction > 0.0 ? after[component] : here[component];
    const double slope = 0.5 * this->Volume.GradientSteps[axis] * (upper - lower);
    square += slope * slope;
  }
  return std::sqrt(square);
}

ExtinctionSampler::Sample ExtinctionSampler::Get(const glm::dvec3& position) const
{
  const MaterialTable& material = this->Volume.Material;
  const double length = this->Volume.Space.Radius;
  Sample sample;
  const glm::dvec3 inTexture =
    UnitVector::TransformPoint(this->Volume.Space.TextureFromUnit, position);
  if (!this->IsInRegion(position, inTexture))
  {
    return sample;
  }
  double validFraction = 0.0;
  const glm::dvec4 values = this->GetValues(inTexture, validFraction);
  if (!(validFraction > 0.0))
  {
    return sample;
  }
  for (int row = 0; row < material.Rows; ++row)
  {
    const int component = material.GetOpacityComponent(row);
    const Column column(values[component], material.OpacityRange[row]);
    double extinction = column.Interpolate(material.Colors, row, 4, 3) * validFraction * length;
    if (!(extinction > 0.0))
    {
      continue;
    }
    if (!material.GradientOpacity.empty())
    {
      const Column gradient(
        this->GetGradient(inTexture, values, component), { { 0.0, material.GradientRange[row] } });
      const double unit = this->Volume.UnitDistances[row] / length;
      const double opacity =
        -std::expm1(-extinction * unit) * gradient.Interpolate(material.GradientOpacity, row, 1, 0);
      extinction = -std::log(std::max(1.0 - opacity, 1e-30)) / unit;
    }
    glm::dvec3 color(values[0], values[1], values[2]);
    if (material.Kind == MaterialTable::RGB_OPACITY)
    {
      // The scalars of byte arrays range from 0 to 255. The slice shaders read them as 0 to 1.
      const bool isByte =
        this->Volume.Samples.Scale[0] == 255.0 && this->Volume.Samples.Offset[0] == 0.0;
      color /= isByte ? 255.0 : 1.0;
    }
    else
    {
      const Column shade(values[row], material.ColorRange[row]);
      for (int c = 0; c < 3; ++c)
      {
        color[c] = shade.Interpolate(material.Colors, row, 4, static_cast<std::size_t>(c));
      }
    }
    sample.Extinction += extinction;
    sample.Albedo += extinction * glm::clamp(color, 0.0, 1.0);
  }
  if (sample.Extinction > 0.0)
  {
    sample.Albedo /= sample.Extinction;
  }
  if (!material.Transmission.empty())
  {
    const Column column(values[0], material.ColorRange[0]);
    for (int c = 0; c < 3; ++c)
    {
      sample.Transmission[c] =
        column.Interpolate(material.Transmission, 0, 3, static_cast<std::size_t>(c));
    }
  }
  return sample;
}

}
