// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsotable.h"

#include "Cases/CasePatch.h"
#include "Cases/CellSymmetries.h"
#include "Cases/TransformedPieces.h"
#include "Cases/SlotOrder.h"
#include "Hulls/Polytope.h"

#include <algorithm>
#include <mutex>
#include <numeric>

using namespace interlume;

namespace
{
using Slot = vtkIsotable::Slot;

constexpr int MaximumNumberOfVertices = vtkIsotable::MaximumNumberOfVertices;

std::array<Slot, MaximumNumberOfVertices> GetAscendingRanks()
{
  std::array<Slot, MaximumNumberOfVertices> ranks;
  std::iota(ranks.begin(), ranks.end(), Slot(0));
  return ranks;
}

// Returns the convex hull of \a vertices, or a cell without vertices if a vertex is invalid or
// there are too many vertices or slots.
Polytope MakeCell(vtkIsotable::Kinds kind, const std::vector<std::array<int, 3>>& vertices)
{
  std::vector<Polytope::Point> points;
  for (const std::array<int, 3>& vertex : vertices)
  {
    points.push_back({ { vertex[0], vertex[1], vertex[2] } });
  }
  const Polytope cell = Polytope::FromVertices(3, points);
  const std::size_t slots =
    points.size() + (kind == vtkIsotable::INTERVAL ? 2 : 1) * cell.Edges.size();
  return points.size() <= MaximumNumberOfVertices && slots <= vtkIsotable::MaximumNumberOfSlots
    ? cell
    : Polytope{};
}

int CountCases(vtkIsotable::Kinds kind, std::size_t numberOfVertices)
{
  int number = numberOfVertices > 0 ? 1 : 0;
  for (std::size_t i = 0; i < numberOfVertices; ++i)
  {
    number *= kind == vtkIsotable::INTERVAL ? 3 : 2;
  }
  return number;
}
}

class vtkIsotable::Builder
{
public:
  Builder(Kinds kind, const Polytope& cell)
    : Kind(kind)
    , Cell(cell)
    , Lifted(kind == INTERVAL ? cell.Prism() : cell)
  {
  }

  // Computes the slots and pieces of a case. In an interval table, one case of each class of
  // symmetric cases is computed from its hull. A symmetry transforms this case into the other cases
  // of the class.
  void Make(const vtkIsotable& table, int key, Case& result)
  {
    if (this->Kind == CONTOUR)
    {
      this->MakeFromHull(key, result);
      return;
    }
    std::call_once(
      this->HasSymmetries, [this] { this->Symmetries.reset(new CellSymmetries(this->Cell)); });
    const auto origin = this->Symmetries->FindRepresentative(static_cast<std::uint32_t>(key));
    const int first = static_cast<int>(origin.Key);
    if (first == key)
    {
      this->MakeFromHull(key, result);
      return;
    }
    const Case& from = table.GetCase(first);
    const auto& symmetry = this->Symmetries->Get()[origin.Symmetry];
    result.Pieces = TransformedPieces::Move(
      from.Pieces, symmetry, table.GetNumberOfVertices(), table.GetNumberOfEdges());
    for (const Slot slot : from.Slots)
    {
      result.Slots.push_back(symmetry.Slots[slot]);
    }
    std::sort(result.Slots.begin(), result.Slots.end());
  }

private:
  void MakeFromHull(int key, Case& result) const
  {
    const CasePatch patch(this->Lifted,
      CasePatch::GetSigns(static_cast<int>(this->Cell.Vertices.size()), this->Kind == INTERVAL,
        static_cast<std::uint32_t>(key)));
    for (const CasePatch::Facet& facet : patch.GetFacets())
    {
      for (int edge : facet.Points)
      {
        result.Slots.push_back(this->GetSlot(edge));
      }
      if (this->Kind == CONTOUR)
      {
        this->Append(patch.GetPolygon(facet), result);
      }
      else
      {
        this->Append(facet.Points, result);
        this->AppendFaces(
          this->Cell.Dimension == 2 ? GetSides(patch.GetPolygon(facet)) : patch.GetFaces(facet),
          result);
      }
    }
    std::sort(result.Slots.begin(), result.Slots.end());
    result.Slots.erase(std::unique(result.Slots.begin(), result.Slots.end()), result.Slots.end());
  }

  static std::vector<CasePatch::PointList> GetSides(const CasePatch::PointList& polygon)
  {
    std::vector<CasePatch::PointList> sides;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      sides.push_back({ polygon[i], polygon[(i + 1) % polygon.size()] });
    }
    return sides;
  }

  void AppendFaces(const std::vector<CasePatch::PointList>& faces, Case& result) const
  {
    const int m = static_cast<int>(this->Cell.Edges.size());
    result.Pieces.push_back(static_cast<Slot>(faces.size()));
    for (const CasePatch::PointList& face : faces)
    {
      const auto all = [&face](int from, int to)
      {
        return std::all_of(
          face.begin(), face.end(), [=](int edge) { return edge >= from && edge < to; });
      };
      result.Pieces.push_back(all(0, m) ? Slot(0) : all(m, 2 * m) ? Slot(1) : NoSide);
      this->Append(face, result);
    }
  }

  void Append(const CasePatch::PointList& points, Case& result) const
  {
    result.Pieces.push_back(static_cast<Slot>(points.size()));
    for (int edge : points)
    {
      result.Pieces.push_back(this->GetSlot(edge));
    }
  }

  Slot GetSlot(int edge) const
  {
    return static_cast<Slot>(SlotOrder::GetSlot(static_cast<int>(this->Cell.Vertices.size()),
      static_cast<int>(this->Cell.Edges.size()), edge));
  }

  Kinds Kind;
  Polytope Cell;
  Polytope Lifted;
  std::once_flag HasSymmetries;
  std::unique_ptr<const CellSymmetries> Symmetries;
};

vtkIsotable::vtkIsotable(Kinds kind, const std::vector<std::array<int, 3>>& vertices)
  : vtkIsotable(kind, MakeCell(kind, vertices))
{
}

vtkIsotable::vtkIsotable(Kinds kind, const Polytope& cell)
  : Kind(kind)
  , SimplexSize(cell.Dimension + (kind == INTERVAL ? 1 : 0))
  , NumberOfVertices(static_cast<int>(cell.Vertices.size()))
  , NumberOfEdges(static_cast<int>(cell.Edges.size()))
  , Edges(cell.GetSortedEdges())
  , Pieces(new Builder(kind, cell))
  , Cases(CountCases(kind, cell.Vertices.size()))
{
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
    { { CONTOUR, Polytope::FromShape(0) }, { CONTOUR, Polytope::FromShape(1) },
      { CONTOUR, Polytope::FromShape(2) }, { CONTOUR, Polytope::FromShape(3) },
      { CONTOUR, Polytope() }, { CONTOUR, Polytope() } },
    { { INTERVAL, Polytope::FromShape(0) }, { INTERVAL, Polytope::FromShape(1) },
      { INTERVAL, Polytope::FromShape(2) }, { INTERVAL, Polytope::FromShape(3) },
      { INTERVAL, Polytope::FromShape(4) }, { INTERVAL, Polytope::FromShape(5) } }
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
  SlotOrder::RankSlots(
    this->NumberOfVertices, this->Edges, this->Kind == INTERVAL, vertexRanks, ranks.data());
  return ranks;
}

const vtkIsotable::Case& vtkIsotable::MakeCase(int key) const
{
  std::unique_ptr<Case> result(new Case);
  this->Pieces->Make(*this, key, *result);
  this->Cut(
    *result, this->GetSlotRanks(GetAscendingRanks().data()),
    [&result](const Simplex& simplex) { result->Simplices.push_back(simplex); },
    [&result](const Triangle& triangle) { result->Boundary.push_back(triangle); });
  // If two threads compute the same case, the first result is used.
  const Case* expected = nullptr;
  if (this->Cases[key].compare_exchange_strong(expected, result.get(), std::memory_order_acq_rel))
  {
    return *result.release();
  }
  return *expected;
}
