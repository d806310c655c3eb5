// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsotableCache.h"

#include "vtkIsotableOrder.h"
#include "vtkIsotablePatch.h"
#include "vtkIsotablePointSet.h"

#include <algorithm>
#include <numeric>

vtkIsotableCache::vtkIsotableCache(const vtkIsotablePolytope& cell)
  : Cell(cell)
  , Lifted(cell.Prism())
  , Symmetries(cell)
{
  for (const auto& edge : cell.Edges)
  {
    this->Edges.push_back({ { static_cast<Slot>(std::min(edge[0], edge[1])),
      static_cast<Slot>(std::max(edge[0], edge[1])) } });
  }
  std::array<Slot, MaximumNumberOfVertices> ascending;
  std::iota(ascending.begin(), ascending.end(), Slot(0));
  this->Ascending = this->GetSlotRanks(ascending.data());
}

vtkIsotableCache::~vtkIsotableCache() = default;

vtkIsotableCache& vtkIsotableCache::Get(vtkIsotable::Shapes shape)
{
  static vtkIsotableCache caches[vtkIsotable::NUMBER_OF_SHAPES] = {
    vtkIsotableCache(vtkIsotablePolytope::Simplex(3).Prism()),
    vtkIsotableCache(vtkIsotablePolytope::Pyramid().Prism()),
    vtkIsotableCache(vtkIsotablePolytope::Wedge().Prism()),
    vtkIsotableCache(vtkIsotablePolytope::Cube(3).Prism())
  };
  return caches[shape];
}

vtkIsotableCache::RankArray vtkIsotableCache::GetSlotRanks(const Slot* vertexRanks) const
{
  RankArray ranks{};
  vtkIsotableOrder::RankSlots(
    this->GetNumberOfVertices(), this->Edges, true, vertexRanks, ranks.data());
  return ranks;
}

const vtkIsotableCache::Case& vtkIsotableCache::GetCase(std::uint32_t key)
{
  std::uint64_t misses = 0;
  const Case& found = this->FindCase(key, misses);
  this->Lookups.fetch_add(1, std::memory_order_relaxed);
  this->Misses.fetch_add(misses, std::memory_order_relaxed);
  return found;
}

const vtkIsotableCache::Case& vtkIsotableCache::FindCase(std::uint32_t key, std::uint64_t& misses)
{
  return this->Cases.Find(key,
    [this, key, &misses]
    {
      ++misses;
      return this->MakeCase(key);
    });
}

std::unique_ptr<const vtkIsotableCache::Case> vtkIsotableCache::MakeCase(std::uint32_t key)
{
  const vtkIsotableSymmetries::Origin origin = this->Symmetries.FindOrigin(key);
  std::unique_ptr<Case> made(new Case);
  made->Symmetry = origin.Symmetry;
  made->Pieces =
    &this->Kinds.Find(origin.Key, [this, &origin] { return this->MakeKind(origin.Key); });
  vtkIsotablePointSet slots;
  for (const Slot slot : made->Pieces->GetSlots())
  {
    slots.Insert(this->Symmetries.Get()[origin.Symmetry].Slots[slot]);
  }
  made->Slots.reserve(made->Pieces->GetSlots().size());
  slots.ForEach([&made](int slot) { made->Slots.push_back(static_cast<Slot>(slot)); });
  // This is enough for most cases.
  made->Simplices.reserve(64);
  this->Cut(*made, this->Ascending,
    [&made](const Simplex& simplex) { made->Simplices.push_back(simplex); });
  made->Simplices.shrink_to_fit();
  this->Bytes.fetch_add(
    sizeof(Case) + made->Simplices.capacity() * sizeof(Simplex) + made->Slots.capacity(),
    std::memory_order_relaxed);
  return made;
}

std::unique_ptr<const vtkIsotableCache::Kind> vtkIsotableCache::MakeKind(std::uint32_t key)
{
  const int n = this->GetNumberOfVertices();
  std::vector<bool> positive(2 * n);
  for (int i = 0; i < n; ++i, key /= 3)
  {
    positive[i] = key % 3 >= 1;
    positive[i + n] = key % 3 == 2;
  }
  const vtkIsotablePatch patch(this->Lifted, positive);
  std::unique_ptr<Kind> made(new Kind(patch, n, this->GetNumberOfEdges()));
  this->Bytes.fetch_add(made->GetBytes(), std::memory_order_relaxed);
  return made;
}

vtkIsotableCache::Reader::Reader(vtkIsotableCache& cache)
  : Cache(&cache)
  , Entries(new Entry[std::size_t(1) << EntryBits])
{
}

vtkIsotableCache::Reader::~Reader()
{
  this->Cache->Lookups.fetch_add(this->Lookups, std::memory_order_relaxed);
  this->Cache->Misses.fetch_add(this->Misses, std::memory_order_relaxed);
}
