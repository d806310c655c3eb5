// SPDX-License-Identifier: BSD-3-Clause
#include "Volume/VolumeBlocks.h"

#include "Volume/MaterialTable.h"
#include "Volume/VolumeSamples.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace interlume
{

namespace
{
/// A box of samples: index of the first and last sample along each axis.
struct Box
{
  std::array<int, 3> First;
  std::array<int, 3> Last;
};

/// Finds the range of each component in \a box. Ignores voxels that are not finite.
template <typename Texel>
void FindRanges(const VolumeSamples& samples, const Box& box, std::array<double, 2>* ranges)
{
  const auto* texels = reinterpret_cast<const Texel*>(samples.Texels.data());
  const auto components = static_cast<std::size_t>(samples.Components);
  const auto columns = static_cast<std::size_t>(samples.Size[0]);
  const auto rows = static_cast<std::size_t>(samples.Size[1]);
  std::array<Texel, 4> lower{};
  std::array<Texel, 4> upper{};
  bool any = false;
  for (int k = box.First[2]; k <= box.Last[2]; ++k)
  {
    for (int j = box.First[1]; j <= box.Last[1]; ++j)
    {
      const std::size_t row =
        (static_cast<std::size_t>(k) * rows + static_cast<std::size_t>(j)) * columns;
      for (int i = box.First[0]; i <= box.Last[0]; ++i)
      {
        const std::size_t voxel = row + static_cast<std::size_t>(i);
        if (!samples.Mask.empty() && samples.Mask[voxel] == 0)
        {
          continue;
        }
        for (std::size_t c = 0; c < components; ++c)
        {
          const Texel texel = texels[voxel * components + c];
          lower[c] = any ? std::min(lower[c], texel) : texel;
          upper[c] = any ? std::max(upper[c], texel) : texel;
        }
        any = true;
      }
    }
  }
  const double maximum = std::numeric_limits<Texel>::is_integer
    ? static_cast<double>(std::numeric_limits<Texel>::max())
    : 1.0;
  for (std::size_t c = 0; c < components; ++c)
  {
    const double step = samples.Scale[c] / maximum;
    ranges[c] = any
      ? std::array<double, 2>{ { samples.Offset[c] + step * static_cast<double>(lower[c]),
          samples.Offset[c] + step * static_cast<double>(upper[c]) } }
      : std::array<double, 2>{ { 1.0, 0.0 } };
  }
}
}

void VolumeBlocks::SetSize(const std::array<int, 3>& samples, int components, int cells)
{
  this->Cells = cells;
  this->Samples = samples;
  this->Components = components;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int all = std::max(samples[axis] - 1, 1);
    this->Size[axis] = components > 0 ? (all + cells - 1) / cells : 0;
  }
  const int blocks = this->GetNumberOfBlocks();
  this->Ranges.assign(
    static_cast<std::size_t>(blocks) * static_cast<std::size_t>(this->Components), {});
  this->Visible.assign(static_cast<std::size_t>(blocks), 0);
  this->NumberVisible = 0;
}

void VolumeBlocks::Build(const VolumeSamples& samples, int cells)
{
  this->SetSize(samples.Size, samples.Components, cells);
  vtkSMPTools::For(0, this->GetNumberOfBlocks(), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        const std::array<vtkIdType, 3> position{ { block % this->Size[0],
          block / this->Size[0] % this->Size[1], block / this->Size[0] / this->Size[1] } };
        Box box{};
        for (int axis = 0; axis < 3; ++axis)
        {
          const int first = static_cast<int>(position[axis]) * cells;
          box.First[axis] = std::max(first - 1, 0);
          box.Last[axis] = std::min(first + cells + 1, this->Samples[axis] - 1);
        }
        std::array<double, 2>* ranges = this->GetRanges(static_cast<int>(block));
        switch (samples.Format)
        {
          case VolumeSamples::UNORM8:
            FindRanges<std::uint8_t>(samples, box, ranges);
            break;
          case VolumeSamples::UNORM16:
            FindRanges<std::uint16_t>(samples, box, ranges);
            break;
          case VolumeSamples::FLOAT32:
            FindRanges<float>(samples, box, ranges);
            break;
        }
      }
    });
}

void VolumeBlocks::Join(const VolumeBlocks& small)
{
  this->SetSize(small.Samples, small.Components, 2 * small.Cells);
  // Start with empty ranges, whose minimum is above their maximum.
  std::fill(this->Ranges.begin(), this->Ranges.end(), std::array<double, 2>{ { 1.0, 0.0 } });
  const auto components = static_cast<std::size_t>(this->Components);
  for (int block = 0; block < small.GetNumberOfBlocks(); ++block)
  {
    const std::array<int, 3> position{ { block % small.Size[0],
      block / small.Size[0] % small.Size[1], block / small.Size[0] / small.Size[1] } };
    std::array<double, 2>* ranges = this->GetRanges(
      position[0] / 2 + this->Size[0] * (position[1] / 2 + this->Size[1] * (position[2] / 2)));
    for (std::size_t c = 0; c < components; ++c)
    {
      const std::array<double, 2>& other =
        small.Ranges[static_cast<std::size_t>(block) * components + c];
      const bool isEmpty = ranges[c][0] > ranges[c][1];
      if (other[0] <= other[1])
      {
        ranges[c] = { { isEmpty ? other[0] : std::min(ranges[c][0], other[0]),
          isEmpty ? other[1] : std::max(ranges[c][1], other[1]) } };
      }
    }
  }
}

void VolumeBlocks::Classify(const MaterialTable& material)
{
  this->NumberVisible = 0;
  for (std::size_t block = 0; block < this->Visible.size(); ++block)
  {
    bool visible = false;
    for (int row = 0; row < material.Rows && !visible; ++row)
    {
      const std::array<double, 2>& range =
        this->Ranges[block * static_cast<std::size_t>(this->Components) +
          static_cast<std::size_t>(material.GetOpacityComponent(row))];
      visible = material.GetLargestExtinction(row, range[0], range[1]) > 0.0;
    }
    this->Visible[block] = visible ? 1 : 0;
    this->NumberVisible += visible ? 1 : 0;
  }
}

std::vector<double> VolumeBlocks::GetBorders(int axis) const
{
  const int samples = this->Samples[axis];
  if (samples < 2)
  {
    return { 0.0, 1.0 };
  }
  std::vector<double> borders;
  for (int block = 0; block <= this->Size[axis]; ++block)
  {
    borders.push_back((std::min(block * this->Cells, samples - 1) + 0.5) / samples);
  }
  return borders;
}

}
