// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnsharedTriangles_h
#define interlume_UnsharedTriangles_h

#include "Unstructured/CellCutter.h"
#include "Unstructured/CellReader.h"
#include "Unstructured/UnsharedPoints.h"
#include "Unstructured/UnstructuredChunk.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace interlume
{

/**
 * @class   UnsharedTriangles
 * @brief   counts and collects contour triangles that share no points
 *
 * \a Stored is the integer type of the offsets and connectivity arrays.
 */
template <typename Stored>
class UnsharedTriangles
{
public:
  using Cell = TableCell<1>;
  using Item = ExtractionValues::Item;
  using Slot = vtkIsotable::Slot;
  using Chunk = UnstructuredChunk;
  using Index = PointArrays::Part::Index;

  UnsharedTriangles(const ExtractionContext& context, const CellReader<Stored>& reader,
    const CellCutter& cutter, const ExtractionScalars& scalars)
    : Context(context)
    , Reader(reader)
    , Cutter(cutter)
    , Scalars(scalars)
    , HasOneValue(reader.GetMarks().HasSingleIsovalue())
    , AreIdsRanks(reader.GetOrder().IsById() &&
        reader.GetNumberOfPoints() <= std::numeric_limits<std::uint32_t>::max())
  {
  }

  /// Counts a cell in the common case: the contour has one value and all slots are distinct points.
  /// Returns false and does nothing if slots may coincide, or if the corner ids are neither in
  /// ascending order nor usable as 32-bit ranks.
  bool CountPlain(
    const Cell& cell, vtkIdType position, Chunk& chunk, UnsharedPoints& unshared) const
  {
    return this->HasOneValue &&
      (cell.NumberOfCorners == 8 ? this->template CountPlain<8>(cell, position, chunk, unshared)
                                 : this->template CountPlain<0>(cell, position, chunk, unshared));
  }

  /// Adds the triangles of a cut.
  void Add(const Cell& cell, const Item& item, const CellCut& cut, const ChunkCuts::Found& found,
    MergedCut& merged, UnsharedPoints& unshared)
  {
    Index points[vtkIsotable::MaximumNumberOfSlots];
    unshared.Reserve();
    for (std::size_t s = 0; s < cut.NumberOfSlots; ++s)
    {
      vtkIdType owner;
      const CrossingKey key = this->Cutter.GetTables().GetPoint(cell, item, cut.Slots[s], owner);
      points[cut.Slots[s]] = unshared.Enter(owner, key);
    }
    unshared.Add(cut.Simplices, cut.NumberOfSimplices, points, found.IsInverted);
    const vtkIsotable& table = this->Cutter.GetTables()[cell.Shape];
    if (found.IsMerged &&
      std::any_of(cut.Simplices, cut.Simplices + cut.NumberOfSimplices,
        [&](const vtkIsotable::Simplex& simplex) { return merged.IsInFace(table, simplex); }))
    {
      this->TiedFaces.store(true, std::memory_order_relaxed);
    }
  }

  /// Interpolates the points of a chunk's triangles while they are in the cache.
  void Interpolate(UnsharedPoints& unshared, Chunk& chunk) const
  {
    ExtractionPoint* const points = unshared.GetPoints();
    const std::size_t number = unshared.GetNumberOfPoints();
    this->Scalars.Place(points, static_cast<vtkIdType>(number));
    this->Reader.GetOrder().SortMidpointEndsInThread(points, points + number);
    chunk.Unshared = this->Context.Unshared->Interpolate(
      points, number, unshared.GetCorners(), unshared.GetNumberOfCorners());
  }

  /// Returns true if any triangle lies in a cell face. The neighbor cell may then have the same
  /// triangle.
  bool HasTiedFaces() const { return this->TiedFaces; }

private:
  template <int Known>
  bool CountPlain(
    const Cell& cell, vtkIdType position, Chunk& chunk, UnsharedPoints& unshared) const
  {
    const int corners = Known ? Known : cell.NumberOfCorners;
    const PointMarks::Mark* const marks = this->Reader.GetMarks().GetData();
    unsigned all = 0;
    unsigned key = 0;
    for (int v = 0; v < corners; ++v)
    {
      const PointMarks::Mark mark = marks[cell.Ids[v]];
      all |= mark;
      key |= static_cast<unsigned>(PointMarks::IsReached(mark)) << v;
    }
    if (PointMarks::HasTie(static_cast<PointMarks::Mark>(all)) ||
      (!cell.IsAscending &&
        (!this->AreIdsRanks || CoincidentSlots::IsCollapsed(cell.Ids, corners))))
    {
      return false;
    }
    const ShapeTables& tables = this->Cutter.GetTables();
    const vtkIsotable::Case& what = tables[cell.Shape].GetCase(static_cast<int>(key));
    const bool isInverted = this->Reader.IsInverted(cell);
    const Item& item = this->Context.Values->GetItems().front();
    Index points[vtkIsotable::MaximumNumberOfSlots];
    // Slots are ranked by the lower point id of their edge, then by the higher one.
    std::uint64_t ranks[vtkIsotable::MaximumNumberOfSlots];
    unshared.Reserve();
    for (const Slot slot : what.Slots)
    {
      // Since no corner has the contour value, every slot is an edge crossing. With a single
      // isovalue, an edge has at most one crossing.
      const ShapeTables::SlotEnds& ends = tables.GetEnds(cell.Shape, slot);
      const auto [owner, far] = std::minmax({ cell.Ids[ends.A], cell.Ids[ends.B] });
      points[slot] = unshared.Enter(owner, CrossingKey(far, item.Lower));
      ranks[slot] = (static_cast<std::uint64_t>(owner) << 32) | static_cast<std::uint64_t>(far);
    }
    const vtkIsotable::Simplex* simplices = what.Simplices.data();
    std::size_t number = what.Simplices.size();
    if (!cell.IsAscending)
    {
      const ChunkCuts::CutStart begin = chunk.Cuts.Begin();
      tables[cell.Shape].Cut(
        what, ranks, [&chunk](const vtkIsotable::Simplex& s) { chunk.Cuts.AddSimplex(s); },
        [](const vtkIsotable::Triangle&) {});
      chunk.Cuts.End(begin);
      ChunkCuts::SlotBuffer slots;
      const CellCut cut = chunk.Cuts.GetLast(begin, what, false, this->Cutter.GetKind(), slots);
      simplices = cut.Simplices;
      number = cut.NumberOfSimplices;
    }
    unshared.Add(simplices, number, points, isInverted);
    chunk.Simplices += static_cast<vtkIdType>(number);
    this->Reader.CountOutput(cell, true, chunk.Report);
    chunk.Cuts.Add({ position, static_cast<int>(key), 0, cell.IsAscending, false, isInverted });
    return true;
  }

  const ExtractionContext& Context;
  const CellReader<Stored>& Reader;
  const CellCutter& Cutter;
  const ExtractionScalars& Scalars;
  // If true, there is a single isovalue.
  bool HasOneValue;
  // If true, corners are ordered by ids that fit in 32 bits.
  bool AreIdsRanks;
  std::atomic<bool> TiedFaces{ false };
};

}

#endif
