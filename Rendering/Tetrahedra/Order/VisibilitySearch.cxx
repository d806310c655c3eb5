// SPDX-License-Identifier: BSD-3-Clause
#include "Order/VisibilitySearch.h"

#include "Common/Prefetch.h"

#include <algorithm>

namespace interlume
{

namespace
{
/// Value in Numbers of tetrahedra that are already listed. It is larger than any step.
constexpr std::uint32_t Listed = 0xffffffffu;
}

std::uint32_t VisibilitySearch::ListFrontToBack(const VisibilityGraph& graph,
  const std::vector<std::uint32_t>& centroids, std::vector<std::uint32_t>& frontToBack)
{
  this->Numbers.assign(centroids.size(), 0);
  this->LastNumber = 0;
  this->InCycles = 0;
  this->Ranks.clear();
  frontToBack.clear();
  frontToBack.reserve(centroids.size());
  // Number of tetrahedra to prefetch ahead, to hide the memory latency.
  constexpr std::size_t ahead = 24;
  for (std::size_t i = 0; i < centroids.size(); ++i)
  {
    if (i + ahead < centroids.size())
    {
      const std::size_t later = centroids[i + ahead];
      Prefetch::Read(graph.Twins + 4 * later);
      Prefetch::Read(graph.InFront + later);
      Prefetch::Read(this->Numbers.data() + later);
    }
    if (this->Numbers[centroids[i]] == 0)
    {
      this->Enter(centroids[i]);
      this->Search(graph, centroids, frontToBack);
    }
  }
  return this->InCycles;
}

void VisibilitySearch::Enter(std::uint32_t tetrahedron)
{
  this->Numbers[tetrahedron] = ++this->LastNumber;
  this->Frames.push_back({ tetrahedron, 0, this->LastNumber });
}

void VisibilitySearch::Search(const VisibilityGraph& graph,
  const std::vector<std::uint32_t>& centroids, std::vector<std::uint32_t>& frontToBack)
{
  while (!this->Frames.empty())
  {
    Frame& frame = this->Frames.back();
    const std::uint32_t next = graph.GetNext(frame.Tetrahedron, frame.Position);
    if (next != VisibilityGraph::None)
    {
      if (this->Numbers[next] == 0)
      {
        this->Enter(next);
      }
      else
      {
        frame.Lowest = std::min(frame.Lowest, this->Numbers[next]);
      }
      continue;
    }
    const Frame last = frame;
    this->Frames.pop_back();
    if (last.Lowest == this->Numbers[last.Tetrahedron])
    {
      this->Complete(last.Tetrahedron, centroids, frontToBack);
    }
    else
    {
      this->Pending.push_back(last.Tetrahedron);
      std::uint32_t& lowest = this->Frames.back().Lowest;
      lowest = std::min(lowest, last.Lowest);
    }
  }
}

void VisibilitySearch::Complete(std::uint32_t root, const std::vector<std::uint32_t>& centroids,
  std::vector<std::uint32_t>& frontToBack)
{
  const std::size_t size = frontToBack.size();
  const auto list = [&](std::uint32_t member)
  {
    this->Numbers[member] = Listed;
    frontToBack.push_back(member);
  };
  // Pending tetrahedra that were entered after the root belong to its component.
  while (!this->Pending.empty() && this->Numbers[this->Pending.back()] > this->Numbers[root])
  {
    list(this->Pending.back());
    this->Pending.pop_back();
  }
  list(root);
  if (frontToBack.size() - size > 1)
  {
    this->InCycles += static_cast<std::uint32_t>(frontToBack.size() - size);
    this->SortByCentroid(centroids, &frontToBack[size], frontToBack.data() + frontToBack.size());
  }
}

void VisibilitySearch::SortByCentroid(
  const std::vector<std::uint32_t>& centroids, std::uint32_t* first, std::uint32_t* last)
{
  if (this->Ranks.empty())
  {
    this->Ranks.resize(centroids.size());
    for (std::size_t i = 0; i < centroids.size(); ++i)
    {
      this->Ranks[centroids[i]] = static_cast<std::uint32_t>(i);
    }
  }
  std::sort(first, last,
    [this](std::uint32_t a, std::uint32_t b) { return this->Ranks[a] < this->Ranks[b]; });
}

std::size_t VisibilitySearch::GetBytes() const
{
  return (this->Numbers.capacity() + this->Pending.capacity() + this->Ranks.capacity()) *
    sizeof(std::uint32_t) +
    this->Frames.capacity() * sizeof(Frame);
}

}
