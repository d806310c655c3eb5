// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/UnwrappedParameters.h"

#include "Grid/FlowGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace interlume
{

namespace
{
// Queue of voxels whose neighbors are to be visited. The priority of a voxel is the difference
// between its coordinate and that of the neighbor from which it was reached, quantized to a few
// levels. Within a level, voxels remain in order of insertion.
class VoxelQueue
{
public:
  void Push(std::size_t voxel, float difference)
  {
    // NaN has the lowest priority.
    const float fraction = difference < 0.5F ? 2.0F * difference : 1.0F;
    const auto level = static_cast<std::size_t>(fraction * static_cast<float>(Levels));
    this->Queues[std::min(level, Levels - 1)].push_back(voxel);
  }

  bool Pop(std::size_t& voxel)
  {
    for (std::size_t i = 0; i < Levels; ++i)
    {
      if (this->Heads[i] < this->Queues[i].size())
      {
        voxel = this->Queues[i][this->Heads[i]++];
        return true;
      }
      this->Queues[i].clear();
      this->Heads[i] = 0;
    }
    return false;
  }

private:
  static constexpr std::size_t Levels = 8;
  std::array<std::vector<std::size_t>, Levels> Queues;
  std::array<std::size_t, Levels> Heads{};
};

void Unwrap(FlowGrid& grid, int component)
{
  const auto labelOf = [&grid](std::size_t voxel)
  { return static_cast<std::size_t>(grid.Groups[voxel] / FlowGrid::NumberOfSides); };
  const auto isPeriodic = [&](std::size_t voxel)
  { return labelOf(voxel) > 0 && grid.Periods[labelOf(voxel) - 1][component]; };
  const auto c = static_cast<std::size_t>(component);
  std::array<std::size_t, 3> size{};
  std::copy(grid.Size.begin(), grid.Size.end(), size.begin());
  const std::array<std::size_t, 3> strides{ { 1, size[0], size[0] * size[1] } };
  std::vector<char> isVisited(grid.Groups.size(), 0);
  VoxelQueue queue;
  for (std::size_t first = 0; first < isVisited.size(); ++first)
  {
    if (isVisited[first] || !isPeriodic(first))
    {
      continue;
    }
    isVisited[first] = 1;
    queue.Push(first, 0.0F);
    for (std::size_t voxel = first; queue.Pop(voxel);)
    {
      const float from = grid.Parameters[2 * voxel + c];
      for (int side = 0; side < 6; ++side)
      {
        const auto axis = static_cast<std::size_t>(side / 2);
        const std::size_t at = voxel / strides[axis] % size[axis];
        const bool isUp = side % 2 == 1;
        if (isUp ? at + 1 == size[axis] : at == 0)
        {
          continue;
        }
        const std::size_t next = isUp ? voxel + strides[axis] : voxel - strides[axis];
        if (!isVisited[next] && labelOf(next) == labelOf(voxel))
        {
          float& parameter = grid.Parameters[2 * next + c];
          const float periods = std::round(from - parameter);
          parameter += std::isfinite(periods) ? periods : 0.0F;
          isVisited[next] = 1;
          queue.Push(next, std::abs(from - parameter));
        }
      }
    }
  }
}
}

void UnwrappedParameters::Apply(FlowGrid& grid)
{
  for (int component = 0; component < 2; ++component)
  {
    const bool isAny = std::any_of(grid.Periods.begin(), grid.Periods.end(),
      [component](const FlowGrid::Periodicity& periods)
      { return periods[static_cast<std::size_t>(component)]; });
    if (isAny)
    {
      Unwrap(grid, component);
    }
  }
}

}
