// SPDX-License-Identifier: BSD-3-Clause
#include "SpaceTime/SpaceTimeTable.h"

#include "Cases/CasePatch.h"
#include "Cases/SlotOrder.h"
#include "Hulls/PointSet.h"

#include <numeric>

namespace interlume
{

SpaceTimeTable::SpaceTimeTable(const Polytope& cell)
  : Cell(cell)
  , Lifted(cell.Prism())
  , Symmetries(cell)
  , Edges(cell.GetSortedEdges())
{
  std::array<Slot, MaximumNumberOfVertices> ascending;
  std::iota(ascending.begin(), ascending.end(), Slot(0));
  this->Ascending = this->GetSlotRanks(ascending.data());
}

SpaceTimeTable::~SpaceTimeTable() = default;

SpaceTimeTable& SpaceTimeTable::Get(vtkIsotable::Shapes shape)
{
  static SpaceTimeTable tables[NumberOfShapes] = { SpaceTimeTable(Polytope::FromShape(0).Prism()),
    SpaceTimeTable(Polytope::FromShape(1).Prism()), SpaceTimeTable(Polytope::FromShape(2).Prism()),
    SpaceTimeTable(Polytope::FromShape(3).Prism()) };
  return tables[shape];
}

SpaceTimeTable::RankArray SpaceTimeTable::GetSlotRanks(const Slot* vertexRanks) const
{
  RankArray ranks{};
  SlotOrder::RankSlots(this->GetNumberOfVertices(), this->Edges, true, vertexRanks, ranks.data());
  return ranks;
}

const SpaceTimeTable::Case& SpaceTimeTable::GetCase(std::uint32_t key)
{
  std::uint64_t misses = 0;
  const Case& found = this->FindCase(key, misses);
  this->Lookups.fetch_add(1, std::memory_order_relaxed);
  this->Misses.fetch_add(misses, std::memory_order_relaxed);
  return found;
}

const SpaceTimeTable::Case& SpaceTimeTable::FindCase(std::uint32_t key, std::uint64_t& misses)
{
  return this->Cases.Find(key,
    [this, key, &misses]
    {
      ++misses;
      return this->MakeCase(key);
    });
}

std::unique_ptr<const SpaceTimeTable::Case> SpaceTimeTable::MakeCase(std::uint32_t key)
{
  const CellSymmetries::Origin origin = this->Symmetries.FindRepresentative(key);
  std::unique_ptr<Case> made(new Case);
  made->Symmetry = origin.Symmetry;
  made->Pieces =
    &this->Kinds.Find(origin.Key, [this, &origin] { return this->MakeClassPieces(origin.Key); });
  PointSet slots;
  for (const Slot slot : made->Pieces->GetSlots())
  {
    slots.Insert(this->Symmetries.Get()[origin.Symmetry].Slots[slot]);
  }
  made->Slots.reserve(made->Pieces->GetSlots().size());
  slots.ForEach([&made](int slot) { made->Slots.push_back(static_cast<Slot>(slot)); });
  // Reserve enough for most cases.
  made->Simplices.reserve(64);
  this->Cut(*made, this->Ascending,
    [&made](const Simplex& simplex) { made->Simplices.push_back(simplex); });
  made->Simplices.shrink_to_fit();
  this->Bytes.fetch_add(
    sizeof(Case) + made->Simplices.capacity() * sizeof(Simplex) + made->Slots.capacity(),
    std::memory_order_relaxed);
  return made;
}

std::unique_ptr<const SpaceTimeTable::Kind> SpaceTimeTable::MakeClassPieces(std::uint32_t key)
{
  const int n = this->GetNumberOfVertices();
  const CasePatch patch(this->Lifted, CasePatch::GetSigns(n, true, key));
  std::unique_ptr<Kind> made(new Kind(patch, n, this->GetNumberOfEdges()));
  this->Bytes.fetch_add(made->GetBytes(), std::memory_order_relaxed);
  return made;
}

SpaceTimeTable::Reader::Reader(SpaceTimeTable& table)
  : Table(&table)
  , Entries(new Entry[std::size_t(1) << EntryBits])
{
}

SpaceTimeTable::Reader::~Reader()
{
  this->Table->Lookups.fetch_add(this->Lookups, std::memory_order_relaxed);
  this->Table->Misses.fetch_add(this->Misses, std::memory_order_relaxed);
}

}
