#include "vtkIsotableCache.h"

#include "vtkIsotableTriangulation.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace
{
// Vertices first, then lower, then upper crossings, each by the ends of its edge.
std::vector<int> RankPoints(const vtkIsotablePolytope& cell)
{
  const int n = static_cast<int>(cell.Vertices.size());
  const int m = static_cast<int>(cell.Edges.size());
  std::vector<std::array<int, 3>> keys;
  for (int kind = 1; kind <= 2; ++kind)
  {
    for (const auto& edge : cell.Edges)
    {
      keys.push_back({ { kind, std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) } });
    }
  }
  for (int i = 0; i < n; ++i)
  {
    keys.push_back({ { 0, i, i } });
  }
  std::vector<int> order(n + 2 * m);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&keys](int a, int b) { return keys[a] < keys[b]; });
  std::vector<int> ranks(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    ranks[order[i]] = static_cast<int>(i);
  }
  return ranks;
}
}

vtkIsotableCache::vtkIsotableCache(const vtkIsotablePolytope& cell)
  : Cell(cell)
  , Lifted(cell.Prism())
  , PointRanks(RankPoints(cell))
  , Shards(new Shard[NumberOfShards])
{
}

vtkIsotableCache::~vtkIsotableCache() = default;

vtkIsotableCache& vtkIsotableCache::GetHypercube()
{
  static vtkIsotableCache cache(vtkIsotablePolytope::Cube(4));
  return cache;
}

const vtkIsotableCache::Case& vtkIsotableCache::GetCase(std::uint32_t key)
{
  this->Lookups.fetch_add(1, std::memory_order_relaxed);
  Shard& shard = this->Shards[(key * 2654435761u) >> 26];
  std::lock_guard<std::mutex> lock(shard.Mutex);
  std::unique_ptr<const Case>& known = shard.Cases[key];
  if (!known)
  {
    known.reset(new Case(this->MakeCase(key)));
    this->Misses.fetch_add(1, std::memory_order_relaxed);
    this->Bytes.fetch_add(sizeof(Case) + known->capacity(), std::memory_order_relaxed);
  }
  return *known;
}

vtkIsotableCache::Case vtkIsotableCache::MakeCase(std::uint32_t key) const
{
  const int n = static_cast<int>(this->Cell.Vertices.size());
  const int m = static_cast<int>(this->Cell.Edges.size());
  std::vector<bool> positive(2 * n);
  for (int i = 0; i < n; ++i, key /= 3)
  {
    positive[i] = key % 3 >= 1;
    positive[i + n] = key % 3 == 2;
  }
  const vtkIsotablePatch patch(this->Lifted, positive);
  Case made;
  for (const auto& simplex : vtkIsotableTriangulation::Triangulate(
         patch, vtkIsotableTriangulation::PULLING, this->PointRanks))
  {
    for (int edge : simplex)
    {
      made.push_back(static_cast<Slot>(edge < 2 * m ? n + edge : edge - 2 * m));
    }
  }
  made.shrink_to_fit();
  return made;
}
