// SPDX-License-Identifier: BSD-3-Clause
#include "Order/CycleOrder.h"

#include <algorithm>

namespace interlume
{

std::uint32_t CycleOrder::Append(const VisibilityGraph& graph,
  const std::vector<std::uint32_t>& centroids, std::vector<unsigned char>& isDone,
  std::vector<std::uint32_t>& frontToBack)
{
  this->Centroids = &centroids;
  this->Numbers.assign(centroids.size(), 0);
  this->Lowest.resize(centroids.size());
  this->LastNumber = 0;
  this->InCycles = 0;
  this->Ranks.clear();
  for (const std::uint32_t root : centroids)
  {
    if (!isDone[root])
    {
      this->Enter(root);
      this->Search(graph, isDone, frontToBack);
    }
  }
  return this->InCycles;
}

void CycleOrder::Enter(std::uint32_t tetrahedron)
{
  this->Numbers[tetrahedron] = this->Lowest[tetrahedron] = ++this->LastNumber;
  this->Frames.push_back({ tetrahedron, 0 });
  this->Pending.push_back(tetrahedron);
}

void CycleOrder::Search(const VisibilityGraph& graph, std::vector<unsigned char>& isDone,
  std::vector<std::uint32_t>& frontToBack)
{
  while (!this->Frames.empty())
  {
    Frame& frame = this->Frames.back();
    const std::uint32_t own = frame.Tetrahedron;
    const std::uint32_t next = graph.GetNext(own, frame.Position);
    if (next != VisibilityGraph::None)
    {
      if (!isDone[next] && this->Numbers[next] == 0)
      {
        this->Enter(next);
      }
      else if (!isDone[next])
      {
        this->Lowest[own] = std::min(this->Lowest[own], this->Numbers[next]);
      }
      continue;
    }

    this->Frames.pop_back();
    if (!this->Frames.empty())
    {
      std::uint32_t& lowest = this->Lowest[this->Frames.back().Tetrahedron];
      lowest = std::min(lowest, this->Lowest[own]);
    }
    if (this->Lowest[own] == this->Numbers[own])
    {
      // A component is complete: it is all from here on.
      const std::size_t size = frontToBack.size();
      std::uint32_t member;
      do
      {
        member = this->Pending.back();
        this->Pending.pop_back();
        isDone[member] = 1;
        frontToBack.push_back(member);
      } while (member != own);
      if (frontToBack.size() - size > 1)
      {
        this->InCycles += static_cast<std::uint32_t>(frontToBack.size() - size);
        this->SortByCentroid(&frontToBack[size], frontToBack.data() + frontToBack.size());
      }
    }
  }
}

void CycleOrder::SortByCentroid(std::uint32_t* first, std::uint32_t* last)
{
  if (this->Ranks.empty())
  {
    this->Ranks.resize(this->Centroids->size());
    for (std::size_t i = 0; i < this->Ranks.size(); ++i)
    {
      this->Ranks[(*this->Centroids)[i]] = static_cast<std::uint32_t>(i);
    }
  }
  std::sort(first, last,
    [this](std::uint32_t a, std::uint32_t b) { return this->Ranks[a] < this->Ranks[b]; });
}

}
