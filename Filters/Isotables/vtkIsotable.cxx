// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsotable.h"

#include "Combinatorics/MovedPieces.h"

#include "vtkIsotableOrder.h"
#include "vtkIsotablePatch.h"
#include "vtkIsotableSymmetries.h"

#include <algorithm>
#include <cmath>

namespace
{
int Power(int base, int exponent)
{
  int result = 1;
  for (int i = 0; i < exponent; ++i)
  {
    result *= base;
  }
  return result;
}
}

vtkIsotable::vtkIsotable(Kinds kind, const vtkIsotablePolytope& cell)
  : Kind(kind)
  , Cell(cell)
  , Lifted(kind == INTERVAL ? cell.Prism() : cell)
  , NumberOfVertices(static_cast<int>(cell.Vertices.size()))
  , NumberOfEdges(static_cast<int>(cell.Edges.size()))
  , Cases(Power(kind == INTERVAL ? 3 : 2, static_cast<int>(cell.Vertices.size())))
{
  for (const auto& edge : cell.Edges)
  {
    this->Edges.push_back({ { static_cast<Slot>(std::min(edge[0], edge[1])),
      static_cast<Slot>(std::max(edge[0], edge[1])) } });
  }
  Slot ascending[MaximumNumberOfVertices];
  for (int i = 0; i < this->NumberOfVertices; ++i)
  {
    ascending[i] = static_cast<Slot>(i);
  }
  const RankArray ranks = this->GetSlotRanks(ascending);
  // The edges of the lifted cell are those at the lower side, at the upper side, then the vertical
  // ones.
  for (int side = 0; side < (kind == INTERVAL ? 2 : 1); ++side)
  {
    for (int e = 0; e < this->NumberOfEdges; ++e)
    {
      this->PointRanks.push_back(ranks[this->NumberOfVertices + side * this->NumberOfEdges + e]);
    }
  }
  for (int i = 0; kind == INTERVAL && i < this->NumberOfVertices; ++i)
  {
    this->PointRanks.push_back(ranks[i]);
  }
}

vtkIsotable::~vtkIsotable()
{
  for (auto& known : this->Cases)
  {
    delete known.load();
  }
}

const vtkIsotable& vtkIsotable::Get(Kinds kind, Shapes shape)
{
  static const vtkIsotable tables[2][NUMBER_OF_SHAPES] = {
    { { CONTOUR, vtkIsotablePolytope::Simplex(3) }, { CONTOUR, vtkIsotablePolytope::Pyramid() },
      { CONTOUR, vtkIsotablePolytope::Wedge() }, { CONTOUR, vtkIsotablePolytope::Cube(3) } },
    { { INTERVAL, vtkIsotablePolytope::Simplex(3) }, { INTERVAL, vtkIsotablePolytope::Pyramid() },
      { INTERVAL, vtkIsotablePolytope::Wedge() }, { INTERVAL, vtkIsotablePolytope::Cube(3) } }
  };
  return tables[kind][shape];
}

int vtkIsotable::GetNumberOfCasesMade() const
{
  return static_cast<int>(std::count_if(this->Cases.begin(), this->Cases.end(),
    [](const std::atomic<const Case*>& known) { return known.load() != nullptr; }));
}

vtkIsotable::RankArray vtkIsotable::GetSlotRanks(const Slot* vertexRanks) const
{
  RankArray ranks{};
  vtkIsotableOrder::RankSlots(
    this->NumberOfVertices, this->Edges, this->Kind == INTERVAL, vertexRanks, ranks.data());
  return ranks;
}

void vtkIsotable::AppendPieces(int key, Case& made) const
{
  const int n = this->NumberOfVertices;
  const int m = this->NumberOfEdges;
  std::vector<bool> positive(this->Lifted.Vertices.size());
  for (int i = 0; i < n; ++i)
  {
    if (this->Kind == CONTOUR)
    {
      positive[i] = key % 2 == 1;
      key /= 2;
    }
    else
    {
      positive[i] = key % 3 >= 1;
      positive[i + n] = key % 3 == 2;
      key /= 3;
    }
  }
  const vtkIsotablePatch patch(this->Lifted, positive);
  const auto toSlot = [n, m](int edge)
  { return static_cast<Slot>(vtkIsotableOrder::GetSlot(n, m, edge)); };
  const auto append = [&](const vtkIsotablePatch::PointList& points)
  {
    made.Pieces.push_back(static_cast<Slot>(points.size()));
    for (int edge : points)
    {
      made.Pieces.push_back(toSlot(edge));
    }
  };
  for (const vtkIsotablePatch::Facet& facet : patch.GetFacets())
  {
    for (int edge : facet.Points)
    {
      made.Slots.push_back(toSlot(edge));
    }
    if (this->Kind == CONTOUR)
    {
      append(patch.GetPolygon(facet));
      continue;
    }
    append(facet.Points);
    const std::vector<vtkIsotablePatch::PointList> faces = patch.GetFaces(facet);
    made.Pieces.push_back(static_cast<Slot>(faces.size()));
    for (const vtkIsotablePatch::PointList& face : faces)
    {
      const auto all = [&face](int from, int to)
      {
        return std::all_of(
          face.begin(), face.end(), [=](int edge) { return edge >= from && edge < to; });
      };
      made.Pieces.push_back(all(0, m) ? Slot(0) : all(m, 2 * m) ? Slot(1) : NoSide);
      append(face);
    }
  }
  std::sort(made.Slots.begin(), made.Slots.end());
  made.Slots.erase(std::unique(made.Slots.begin(), made.Slots.end()), made.Slots.end());
}

void vtkIsotable::MakePieces(int key, Case& made) const
{
  if (this->Kind == CONTOUR)
  {
    this->AppendPieces(key, made);
    return;
  }
  std::call_once(
    this->HasSymmetries, [this] { this->Symmetries.reset(new vtkIsotableSymmetries(this->Cell)); });
  const auto origin = this->Symmetries->FindOrigin(static_cast<std::uint32_t>(key));
  const int first = static_cast<int>(origin.Key);
  if (first == key)
  {
    this->AppendPieces(key, made);
    return;
  }
  const Case& from = this->GetCase(first);
  const auto& symmetry = this->Symmetries->Get()[origin.Symmetry];
  made.Pieces = interlume::MovedPieces::Move(
    from.Pieces, symmetry, this->NumberOfVertices, this->NumberOfEdges);
  for (const Slot slot : from.Slots)
  {
    made.Slots.push_back(symmetry.Slots[slot]);
  }
  std::sort(made.Slots.begin(), made.Slots.end());
}

const vtkIsotable::Case& vtkIsotable::MakeCase(int key) const
{
  std::unique_ptr<Case> made(new Case);
  this->MakePieces(key, *made);
  Slot ascending[MaximumNumberOfVertices];
  for (int i = 0; i < MaximumNumberOfVertices; ++i)
  {
    ascending[i] = static_cast<Slot>(i);
  }
  this->Cut(
    *made, this->GetSlotRanks(ascending),
    [&made](const Simplex& simplex) { made->Simplices.push_back(simplex); },
    [&made](const Triangle& triangle) { made->Boundary.push_back(triangle); });
  // Where two threads make the same case, the first one's stays.
  const Case* expected = nullptr;
  if (this->Cases[key].compare_exchange_strong(expected, made.get(), std::memory_order_acq_rel))
  {
    return *made.release();
  }
  return *expected;
}
