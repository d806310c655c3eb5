// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/UnwrappedPlaces.h"

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
// Voxels whose neighbours are to be visited, in the order of how little they differ from the voxel
// that they were reached from, and else in that of their coming.
class Waiting
{
public:
  void Push(std::size_t voxel, float difference)
  {
    // What is no number comes last.
    const float share = difference < 0.5F ? 2.0F * difference : 1.0F;
    const auto level = static_cast<std::size_t>(share * static_cast<float>(Levels));
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
  { return static_cast<std::size_t>(grid.Groups[voxel] / FlowGrid::Ways); };
  const auto isPeriodic = [&](std::size_t voxel)
  { return labelOf(voxel) > 0 && grid.Periods[labelOf(voxel) - 1][component]; };
  const auto c = static_cast<std::size_t>(component);
  std::array<std::size_t, 3> size{};
  std::copy(grid.Size.begin(), grid.Size.end(), size.begin());
  const std::array<std::size_t, 3> strides{ { 1, size[0], size[0] * size[1] } };
  std::vector<char> isVisited(grid.Groups.size(), 0);
  Waiting waiting;
  for (std::size_t first = 0; first < isVisited.size(); ++first)
  {
    if (isVisited[first] || !isPeriodic(first))
    {
      continue;
    }
    isVisited[first] = 1;
    waiting.Push(first, 0.0F);
    for (std::size_t voxel = first; waiting.Pop(voxel);)
    {
      const float from = grid.Places[2 * voxel + c];
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
          float& place = grid.Places[2 * next + c];
          const float periods = std::round(from - place);
          place += std::isfinite(periods) ? periods : 0.0F;
          isVisited[next] = 1;
          waiting.Push(next, std::abs(from - place));
        }
      }
    }
  }
}
}

void UnwrappedPlaces::Apply(FlowGrid& grid)
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
