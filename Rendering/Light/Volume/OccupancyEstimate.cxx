// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/OccupancyEstimate.h"

#include "Volume/MaterialTable.h"
#include "Volume/VolumeBlocks.h"
#include "Volume/VolumeSamples.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace interlume
{

namespace
{
// Sampling interval along each axis, in voxels.
constexpr int Step = 4;

template <typename Texel>
double GetTexel(const VolumeSamples& samples, std::size_t index)
{
  Texel texel;
  std::memcpy(&texel, samples.Texels.data() + index * sizeof(Texel), sizeof(Texel));
  return static_cast<double>(texel);
}

double GetValue(const VolumeSamples& samples, std::size_t voxel, int component)
{
  const std::size_t index =
    voxel * static_cast<std::size_t>(samples.Components) + static_cast<std::size_t>(component);
  const double texel = samples.Format == VolumeSamples::UNORM8
    ? GetTexel<std::uint8_t>(samples, index) / 255.0
    : samples.Format == VolumeSamples::UNORM16 ? GetTexel<std::uint16_t>(samples, index) / 65535.0
                                               : GetTexel<float>(samples, index);
  const auto at = static_cast<std::size_t>(component);
  return samples.Offset[at] + samples.Scale[at] * texel;
}

bool HasMedium(const VolumeSamples& samples, const MaterialTable& material, std::size_t voxel)
{
  bool has = false;
  for (int row = 0; row < material.Rows && !has; ++row)
  {
    const double value = GetValue(samples, voxel, material.GetOpacityComponent(row));
    has = material.GetLargestExtinction(row, value, value) > 0.0;
  }
  return has;
}
}

double OccupancyEstimate::Find(
  const VolumeSamples& samples, const VolumeBlocks& blocks, const MaterialTable& material)
{
  const auto getBlock = [&](int position, std::size_t axis)
  { return std::min(position / VolumeBlocks::BlockSize, blocks.GetSize()[axis] - 1); };
  std::size_t seen = 0;
  std::size_t filled = 0;
  for (int k = 0; k < samples.Size[2]; k += Step)
  {
    for (int j = 0; j < samples.Size[1]; j += Step)
    {
      for (int i = 0; i < samples.Size[0]; i += Step)
      {
        if (!blocks.IsVisible(getBlock(i, 0), getBlock(j, 1), getBlock(k, 2)))
        {
          continue;
        }
        const std::size_t row =
          static_cast<std::size_t>(k) * static_cast<std::size_t>(samples.Size[1]) +
          static_cast<std::size_t>(j);
        const std::size_t voxel =
          row * static_cast<std::size_t>(samples.Size[0]) + static_cast<std::size_t>(i);
        const bool isFinite = samples.Mask.empty() || samples.Mask[voxel] != 0;
        ++seen;
        filled += isFinite && HasMedium(samples, material, voxel) ? 1 : 0;
      }
    }
  }
  return seen > 0 ? static_cast<double>(filled) / static_cast<double>(seen) : 1.0;
}

}
