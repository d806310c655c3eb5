// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/SurfaceRegions.h"

#include "TetGen/TetGenProblem.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>

namespace interlume
{

namespace
{
using Triple = std::array<int, 3>;

struct Wall
{
  Triple Points;
  int Marker;
};

/// Finds facet triangles by their points.
class Walls
{
public:
  explicit Walls(const TetGenSolution& solution)
  {
    for (std::size_t i = 0; i < solution.Markers.size(); ++i)
    {
      Wall wall{ {}, solution.Markers[i] };
      std::copy_n(&solution.Triangles[3 * i], 3, wall.Points.begin());
      std::sort(wall.Points.begin(), wall.Points.end());
      this->List.push_back(wall);
    }
    std::sort(this->List.begin(), this->List.end(),
      [](const Wall& a, const Wall& b) { return a.Points < b.Points; });
  }

  /// Returns the marker of the facet triangle with \a points, which must be in ascending order, or
  /// 0 if there is none.
  int Find(const Triple& points) const
  {
    const auto found = std::lower_bound(this->List.begin(), this->List.end(), points,
      [](const Wall& wall, const Triple& key) { return wall.Points < key; });
    return found != this->List.end() && found->Points == points ? found->Marker : 0;
  }

private:
  std::vector<Wall> List;
};

struct Region
{
  int Depth = std::numeric_limits<int>::max();
  vtkIdType FirstCell = std::numeric_limits<vtkIdType>::max();
  struct Passage
  {
    int Region; ///< on the other side of a facet
    int Layers; ///< layers of the facet
  };
  std::vector<Passage> Passages;
};
}

SurfaceRegions::SurfaceRegions(const TetGenSolution& solution,
  const std::vector<vtkIdType>& cellIds, const std::vector<int>& layers, bool fillNestedShells)
  : Regions(solution.GetNumberOfTetrahedra(), -1)
{
  const Walls walls(solution);
  std::vector<Region> regions;
  // Each entry contains a region, a tetrahedron on the other side of a facet of the region, and the
  // facet's number of layers.
  std::vector<std::array<int, 3>> crossings;
  std::vector<int> stack;
  std::queue<int> outermost;
  for (int seed = 0; seed < solution.GetNumberOfTetrahedra(); ++seed)
  {
    if (this->Regions[seed] >= 0)
    {
      continue;
    }
    const int number = static_cast<int>(regions.size());
    regions.emplace_back();
    this->Regions[seed] = number;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const int tetrahedron = stack.back();
      stack.pop_back();
      for (int i = 0; i < 4; ++i)
      {
        const int neighbor = solution.Neighbors[4 * tetrahedron + i];
        const int marker = walls.Find(solution.GetFace(4 * tetrahedron + i));
        if (marker > 0 && marker <= static_cast<int>(cellIds.size()))
        {
          regions[number].FirstCell = std::min(regions[number].FirstCell, cellIds[marker - 1]);
        }
        if (neighbor < 0)
        {
          regions[number].Depth = 1;
        }
        else if (marker != 0)
        {
          crossings.push_back({ { number, neighbor,
            marker > 0 && marker <= static_cast<int>(layers.size()) ? layers[marker - 1] : 1 } });
        }
        else if (this->Regions[neighbor] < 0)
        {
          this->Regions[neighbor] = number;
          stack.push_back(neighbor);
        }
      }
    }
    if (regions[number].Depth == 1)
    {
      outermost.push(number);
    }
  }
  for (const auto& crossing : crossings)
  {
    regions[crossing[0]].Passages.push_back({ this->Regions[crossing[1]], crossing[2] });
  }
  while (!outermost.empty())
  {
    const Region region = regions[outermost.front()];
    outermost.pop();
    for (const Region::Passage& passage : region.Passages)
    {
      Region& other = regions[passage.Region];
      if (other.Depth > region.Depth + passage.Layers)
      {
        other.Depth = region.Depth + passage.Layers;
        outermost.push(passage.Region);
      }
    }
  }
  std::vector<int> retained;
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    if (fillNestedShells || regions[r].Depth % 2 == 1)
    {
      retained.push_back(static_cast<int>(r));
    }
  }
  std::stable_sort(retained.begin(), retained.end(),
    [&regions](int a, int b)
    {
      return regions[a].FirstCell < regions[b].FirstCell ||
        (regions[a].FirstCell == regions[b].FirstCell && regions[a].Depth < regions[b].Depth);
    });
  this->Numbers.assign(regions.size(), -1);
  for (int region : retained)
  {
    this->Numbers[region] = this->NumberOfRegions++;
  }
}

}
