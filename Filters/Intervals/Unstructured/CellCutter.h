// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellCutter_h
#define interlume_CellCutter_h

#include "Cuts/MergedCut.h"
#include "Grid/CornerOrder.h"
#include "Pass/ExtractionContext.h"
#include "Unstructured/ChunkCuts.h"
#include "Unstructured/UnstructuredCells.h"

#include <algorithm>
#include <cstddef>

namespace interlume
{

/**
 * @class   CellCutter
 * @brief   cuts the cells of an unstructured grid
 *
 * How a cell is split depends on the global order of its points (see CornerOrder), so that adjacent
 * cells match.
 */
class CellCutter
{
public:
  using Cell = TableCell<1>;
  using Item = ExtractionValues::Item;
  using Slot = vtkIsotable::Slot;

  CellCutter(const ExtractionContext& context, const CornerOrder& order)
    : Values(*context.Values)
    , Order(order)
    , Tables(vtkIsotable::NUMBER_OF_SHAPES,
        [kind = context.Values->GetKind()](vtkIsotable::Shapes shape) -> const vtkIsotable&
        { return vtkIsotable::Get(kind, shape); })
    , Kind{ context.GetSimplexSize(), context.GenerateBoundaries }
  {
  }

  const ShapeTables& GetTables() const { return this->Tables; }
  const ChunkCuts::Kind& GetKind() const { return this->Kind; }

  /// Cuts a cell for item \a number and returns the case of the cell. If the cut stored in the
  /// table does not apply, a new cut is computed and stored in \a cuts. \a slots is a buffer for
  /// the slots of the cut. Adds the number of removed degenerate simplices to \a collapsed.
  ChunkCuts::Found Cut(const Cell& cell, std::size_t number, vtkIdType position, bool isInverted,
    MergedCut& merged, ChunkCuts& cuts, ChunkCuts::SlotBuffer& slots, CellCut& cut,
    vtkIdType& collapsed) const
  {
    const Item& item = this->Values.GetItems()[number];
    int key = 0;
    for (int v = 0, power = 1; v < cell.NumberOfCorners; ++v, power *= this->Values.GetBase())
    {
      key += power * item.GetDigit(cell.Codes[v]);
    }
    const vtkIsotable::Case& what = this->Tables[cell.Shape].GetCase(key);
    Slot same[vtkIsotable::MaximumNumberOfSlots];
    const bool isMerged = this->Tables.Merge(cell, item, what, same);
    const bool isPlain = cell.IsAscending && !isMerged;
    cut = isPlain ? ChunkCuts::GetTableCut(what, this->Kind)
                  : this->MakeCut(cell, item, what, isMerged ? same : nullptr, merged, cuts, slots);
    collapsed += isMerged ? merged.GetNumberOfCollapsedSimplices() : 0;
    return { position, key, number, isPlain, isMerged, isInverted };
  }

  /// Calls visit(cell, shape, found, cut) for each case in \a cuts. \a begin is the id of the first
  /// cell of the chunk.
  template <typename Stored, typename Visitor>
  void ForEachCut(vtkIdType begin, const UnstructuredCells<Stored>& cells, const ChunkCuts& cuts,
    Visitor&& visit) const
  {
    cuts.ForEach(
      begin, this->Tables, this->Kind,
      [&cells](vtkIdType cell) { return cells.GetCorners(cell).Shape; }, visit);
  }

private:
  // Cuts a case according to the global order and stores the cut. \a same maps each slot to the
  // slot that represents its point. It is null if all slots are distinct points.
  CellCut MakeCut(const Cell& cell, const Item& item, const vtkIsotable::Case& what,
    const Slot* same, MergedCut& merged, ChunkCuts& cuts, ChunkCuts::SlotBuffer& slots) const
  {
    const vtkIsotable& table = this->Tables[cell.Shape];
    const ChunkCuts::CutStart begin = cuts.Begin();
    Slot vertexRanks[8];
    this->Order.Rank(cell.Ids, cell.NumberOfCorners, vertexRanks);
    const vtkIsotable::RankArray ranks = table.GetSlotRanks(vertexRanks);
    const auto simplex = [&cuts](const vtkIsotable::Simplex& s) { cuts.AddSimplex(s); };
    const auto boundary = [this, &cuts](const vtkIsotable::Triangle& t)
    {
      if (this->Kind.HasBoundaries)
      {
        cuts.AddTriangle(t);
      }
    };
    if (same)
    {
      merged.Make(table, item, cell.Codes, what, ranks, same, this->Kind.HasBoundaries);
      std::for_each(merged.GetSimplices().begin(), merged.GetSimplices().end(), simplex);
      std::for_each(merged.GetTriangles().begin(), merged.GetTriangles().end(), boundary);
    }
    else
    {
      table.Cut(what, ranks, simplex, boundary);
    }
    cuts.End(begin);
    return cuts.GetLast(begin, what, same != nullptr, this->Kind, slots);
  }

  const ExtractionValues& Values;
  const CornerOrder& Order;
  ShapeTables Tables;
  ChunkCuts::Kind Kind;
};

}

#endif
