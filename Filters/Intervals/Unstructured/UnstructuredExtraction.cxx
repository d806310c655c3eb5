// SPDX-License-Identifier: BSD-3-Clause
#include "Unstructured/UnstructuredExtraction.h"

#include "Common/GridCells.h"
#include "Common/ThreadLocals.h"
#include "Cuts/ExtractionCell.h"
#include "Cuts/MergedCut.h"
#include "Grid/CellOrientation.h"
#include "Grid/CornerOrder.h"
#include "Pass/ExtractionIndex.h"
#include "Scalars/ExtractionScalars.h"
#include "Soup/SoupArrays.h"
#include "Soup/SoupBuilder.h"
#include "Unstructured/ChunkCuts.h"
#include "Unstructured/CrossingLists.h"
#include "Unstructured/UnstructuredCells.h"
#include "Unstructured/WholeParts.h"

#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <atomic>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;
using Slot = vtkIsotable::Slot;
using Item = ExtractionValues::Item;

constexpr vtkIdType ChunkSize = 256 * ExtractionIndex::RunLength;
// How many cells ahead coordinates are asked for.
constexpr int CellsAhead = 4;

// The result of the counting pass for a chunk of cells, which the writing pass uses.
struct Chunk
{
  ChunkCuts Cuts;
  // The points of all cases, where nodes are kept.
  std::vector<const CrossingLists::Node*> Nodes;
  std::vector<vtkIdType> TiedTriangles;
  std::vector<vtkIdType> TiedSimplices;
  // The triangles, where they share no points.
  SoupPart Soup;
  vtkIdType Simplices = 0;
  vtkIdType Triangles = 0;
  vtkExtractionReport Report;

  std::size_t GetBytes() const
  {
    return this->Cuts.GetBytes() + this->Nodes.capacity() * sizeof(void*) + this->Soup.GetBytes();
  }
};

// A cell that is passed on whole.
struct FoundWhole
{
  // The place of the cell, counted from the chunk's first.
  std::uint16_t Position;
  std::uint16_t Item;
};

// A chunk of which some cells are passed on whole.
struct ChunkWithWhole : Chunk
{
  std::vector<FoundWhole> WholeCases;
  vtkIdType Whole = 0;
  vtkIdType WholeIds = 0;

  std::size_t GetBytes() const
  {
    return this->Chunk::GetBytes() + this->WholeCases.capacity() * sizeof(FoundWhole);
  }
};

// A cell near an item, its corners in the order of its table.
struct Cell
{
  vtkIdType Id;
  vtkIsotable::Shapes Shape;
  int NumberOfCorners;
  vtkIdType Ids[8];
  Code Codes[8];
  bool IsAscending;
  // Whether turning it has exchanged left and right; only told of tetrahedra.
  bool IsReflected;
};

template <typename Stored, bool KeepsWhole>
class Extractor
{
  using Chunk = std::conditional_t<KeepsWhole, ChunkWithWhole, interlume::Chunk>;

public:
  Extractor(const ExtractionContext& context, vtkUnstructuredGrid* grid, const Stored* offsets,
    const Stored* ids, ExtractionMesh& mesh)
    : Context(context)
    , Values(*context.Values)
    , Scalars(context.MakeScalars())
    , Cells(grid, offsets, ids)
    , Whole(context, Cells)
    , Order(grid->GetPointData())
    , Orientation(grid)
    , Mesh(mesh)
    , NumberOfPoints(grid->GetNumberOfPoints())
    , NumberOfCells(grid->GetNumberOfCells())
    , Tables(context.Values->GetKind())
    , CutKind{ context.GetSimplexSize(), context.GenerateBoundaries }
    , Marks(*context.Values, grid->GetNumberOfPoints())
    , AreIdsRanks(
        Order.IsById() && grid->GetNumberOfPoints() <= std::numeric_limits<std::uint32_t>::max())
    , KeepsNodes(context.Values->GetKind() == vtkIsotable::CONTOUR)
  {
    if (!context.Soup || context.TakeDuplicates)
    {
      this->Points.emplace(this->NumberOfPoints, this->KeepsNodes);
    }
  }

  bool Execute()
  {
    const vtkIdType chunks = (this->NumberOfCells + ChunkSize - 1) / ChunkSize;
    this->Codes.Allocate(this->NumberOfPoints);
    this->Chunks.resize(chunks);
    const bool counted =
      this->Context.Run(this->NumberOfPoints, 0.0, 0.05,
        [this](vtkIdType first, vtkIdType last)
        {
          this->Scalars->Classify(first, last - first, this->Codes.GetData() + first);
          this->Marks.Fill(this->Codes.GetData(), first, last);
        }) &&
      this->FindPolyhedra() &&
      this->Context.Run(chunks, 0.05, 0.4,
        [this](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType chunk = first; chunk < last; ++chunk)
          {
            this->CountChunk(chunk);
          }
        });
    if (!counted || !this->ShareTied(chunks))
    {
      return false;
    }
    if (this->Points)
    {
      this->Points->MakePoints(*this->Scalars, this->Mesh.Points);
      this->Order.SortHalfway(this->Mesh.Points.GetData(), this->Mesh.Points.GetSize());
    }
    this->NoteWorkingBytes();
    this->Codes.Free();
    this->Marks.Free();
    this->Allocate();
    const bool written = this->Context.Run(chunks, 0.5, 0.8,
      [this](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType chunk = first; chunk < last; ++chunk)
        {
          this->Points ? this->WriteChunk(chunk) : this->WriteSoup(chunk);
        }
      });
    for (const Chunk& chunk : this->Chunks)
    {
      this->Mesh.TiedTriangles.insert(
        this->Mesh.TiedTriangles.end(), chunk.TiedTriangles.begin(), chunk.TiedTriangles.end());
      this->Mesh.TiedSimplices.insert(
        this->Mesh.TiedSimplices.end(), chunk.TiedSimplices.begin(), chunk.TiedSimplices.end());
    }
    return written;
  }

private:
  // Enters the points of all cases that were counted without, where triangles may have to be
  // compared with those of the cells beside theirs. Returns false when the user aborted.
  bool ShareTied(vtkIdType chunks)
  {
    if (this->Points || !this->HasTiedFaces)
    {
      return true;
    }
    this->Points.emplace(this->NumberOfPoints, this->KeepsNodes);
    return this->Context.Run(chunks, 0.4, 0.5,
      [this](vtkIdType first, vtkIdType last)
      {
        CrossingLists::Arena& arena = this->Points->GetArena();
        Cell cell{};
        cell.Id = -1;
        for (vtkIdType chunk = first; chunk < last; ++chunk)
        {
          this->ForEachCut(chunk,
            [&](
              vtkIdType id, vtkIsotable::Shapes, const ChunkCuts::Found& found, const CellCut& cut)
            {
              this->ReadNext(id, cell);
              this->EnterCut(
                cell, this->Values.GetItems()[found.Item], cut, this->Chunks[chunk], arena);
            });
        }
      });
  }

  bool IsBlanked(vtkIdType id, const CellCorners& corners) const
  {
    if (this->Context.IsCellLeftOut(id))
    {
      return true;
    }
    vtkIdType ids[8];
    this->Cells.GetIds(id, corners, ids);
    return this->Context.PointGhosts &&
      std::any_of(ids, ids + corners.NumberOfCorners,
        [this](vtkIdType point) { return this->Context.IsPointBlanked(point); });
  }

  // Returns whether a cell is near an item and can give output; if it cannot, the reason is
  // counted.
  bool Accept(vtkIdType id, vtkExtractionReport& report) const
  {
    const CellCorners& corners = this->Cells.GetCorners(id);
    if (!corners.HasTable())
    {
      (corners.Kind == CellCorners::LOWER_DIMENSIONAL ? report.LowerDimensionalCells
                                                      : report.UnsupportedCells) += 1;
      return false;
    }
    if (this->Context.HasBlanking() && this->IsBlanked(id, corners))
    {
      ++report.BlankedCells;
      return false;
    }
    const PointMarks::Mark marks =
      this->Cells.GetMarks(id, corners.NumberOfCorners, this->Marks.GetData());
    if (PointMarks::IsNonFinite(marks))
    {
      ++report.NonFiniteCells;
      return false;
    }
    report.LinearizedCells += corners.Kind == CellCorners::HIGHER_ORDER;
    return this->Marks.IsNear(marks);
  }

  // Reads a cell but for its codes.
  void Read(vtkIdType id, Cell& cell) const
  {
    if (this->ReadCorners(id, cell))
    {
      cell.IsAscending = this->Order.IsAscending(cell.Ids, cell.NumberOfCorners);
    }
  }

  // Reads what names the points of a cell; one whose corners do not ascend is turned until most of
  // them do. Returns whether it was turned, after which it is left open whether they ascend.
  bool ReadCorners(vtkIdType id, Cell& cell) const
  {
    const CellCorners& corners = this->Cells.GetCorners(id);
    cell.Id = id;
    cell.Shape = corners.Shape;
    cell.NumberOfCorners = corners.NumberOfCorners;
    this->Cells.GetIds(id, corners, cell.Ids);
    cell.IsAscending = this->Order.IsAscending(cell.Ids, cell.NumberOfCorners);
    cell.IsReflected = false;
    if (cell.IsAscending)
    {
      return false;
    }
    if (cell.Shape == vtkIsotable::TETRAHEDRON)
    {
      cell.IsReflected = this->Order.IsOdd(cell.Ids, cell.NumberOfCorners);
    }
    this->Order.Turn(cell.Shape, cell.Ids);
    return true;
  }

  // Reads what names the points of a cell unless it is the one that was read last.
  void ReadNext(vtkIdType id, Cell& cell) const
  {
    if (id != cell.Id)
    {
      this->ReadCorners(id, cell);
    }
  }

  // Returns whether two slots of a cell may be one point: by a value equal to an isovalue, or since
  // two corners are one point.
  bool HasEqualPoints(const Cell& cell, const Item& item) const
  {
    Code ties = item.IsFlat;
    for (int v = 0; v < cell.NumberOfCorners; ++v)
    {
      ties |= cell.Codes[v];
    }
    return ExtractionValues::IsTie(ties) ||
      (!cell.IsAscending && ExtractionCell::IsCollapsed(cell.Ids, cell.NumberOfCorners));
  }

  // Returns the point of a slot, as its owner and its key there.
  CrossingKey GetPoint(const Cell& cell, const Item& item, Slot slot, vtkIdType& owner) const
  {
    return this->Tables.GetPoint(cell.Shape, cell.Ids, cell.NumberOfCorners, item, slot, owner);
  }

  void CountChunk(vtkIdType number)
  {
    Chunk& chunk = this->Chunks[number];
    CrossingLists::Arena* const arena = this->Points ? &this->Points->GetArena() : nullptr;
    SoupBuilder* const soup = this->Points ? nullptr : &this->Soups.Local();
    if (soup)
    {
      soup->Begin();
    }
    const vtkIdType begin = number * ChunkSize;
    const vtkIdType end = std::min(begin + ChunkSize, this->NumberOfCells);
    std::uint16_t near[ChunkSize];
    int numberNear = 0;
    MergedCut merged;
    // Without an index all runs are one, unless what was passed on whole comes first in each.
    const vtkIdType length =
      this->Context.Index || KeepsWhole ? ExtractionIndex::RunLength : ChunkSize;
    for (vtkIdType first = begin; first < end; first += length)
    {
      if (!this->Context.Index ||
        this->Context.Index->IsRunActive(first / ExtractionIndex::RunLength))
      {
        const vtkIdType last = std::min(first + length, end);
        chunk.Report.CellsVisited += last - first;
        this->FindNear(first, last, begin, near, numberNear, chunk.Report);
      }
    }
    chunk.Cuts.Reserve(numberNear);
    const bool isPlain = soup && this->Marks.AreOfOneValue();
    Cell cell{};
    std::vector<vtkIdType> points;
    for (int c = 0; c < numberNear; ++c)
    {
      if (c + CellsAhead < numberNear && !this->Context.KeepOrientation)
      {
        this->Cells.ForEachSecondPoint(begin + near[c + CellsAhead],
          [this](vtkIdType point) { this->Orientation.Prefetch(point); });
      }
      if (this->CountAsWhole(begin + near[c], near[c], chunk, arena, points))
      {
        continue;
      }
      this->Read(begin + near[c], cell);
      if (!isPlain || !this->CountPlain(cell, near[c], chunk, *soup))
      {
        this->CountCell(cell, near[c], chunk, arena, soup, merged, points);
      }
    }
    if (soup)
    {
      this->KeepSoup(*soup, chunk);
    }
  }

  // Interpolates the points of a chunk's triangles, which are in the cache by now.
  void KeepSoup(SoupBuilder& soup, Chunk& chunk) const
  {
    ExtractionPoint* const points = soup.GetPoints();
    const std::size_t number = soup.GetNumberOfPoints();
    this->Scalars->Place(points, static_cast<vtkIdType>(number));
    this->Order.SortHalfwayInThread(points, points + number);
    chunk.Soup = this->Context.Soup->Interpolate(soup);
  }

  // Appends the cells first ... last - 1 that are near an item, by their distance from begin.
  void FindNear(vtkIdType first, vtkIdType last, vtkIdType begin, std::uint16_t* near,
    int& numberNear, vtkExtractionReport& report) const
  {
    if constexpr (KeepsWhole)
    {
      const vtkIdType firstPassed = std::max(first, this->Whole.GetFirstPassed());
      for (vtkIdType id = firstPassed; id < last; ++id)
      {
        near[numberNear++] = static_cast<std::uint16_t>(id - begin);
      }
      last = std::min(last, firstPassed);
    }
    if (!this->Cells.IsUniform() || this->Context.HasBlanking())
    {
      for (vtkIdType id = first; id < last; ++id)
      {
        near[numberNear] = static_cast<std::uint16_t>(id - begin);
        numberNear += this->Accept(id, report);
      }
      return;
    }
    int found = numberNear;
    vtkIdType nonFinite = 0;
    this->Cells.ForEachMarks(first, last, this->Marks.GetData(),
      [&](vtkIdType id, PointMarks::Mark marks)
      {
        near[found] = static_cast<std::uint16_t>(id - begin);
        found += this->Marks.IsNear(marks);
        nonFinite += PointMarks::IsNonFinite(marks);
      });
    numberNear = found;
    report.NonFiniteCells += nonFinite;
  }

  // Counts a cell of one value's contour, without shared points, in which no two slots are one
  // point: nearly all are. Returns false, and does nothing, where some may be, and where corners
  // are neither in ascending order nor ordered by ids that are small.
  bool CountPlain(const Cell& cell, vtkIdType position, Chunk& chunk, SoupBuilder& soup) const
  {
    return cell.NumberOfCorners == 8 ? this->template CountPlain<8>(cell, position, chunk, soup)
                                     : this->template CountPlain<0>(cell, position, chunk, soup);
  }

  template <int Known>
  bool CountPlain(const Cell& cell, vtkIdType position, Chunk& chunk, SoupBuilder& soup) const
  {
    const int corners = Known ? Known : cell.NumberOfCorners;
    const PointMarks::Mark* const marks = this->Marks.GetData();
    unsigned all = 0;
    unsigned key = 0;
    for (int v = 0; v < corners; ++v)
    {
      const PointMarks::Mark mark = marks[cell.Ids[v]];
      all |= mark;
      key |= static_cast<unsigned>(PointMarks::IsReached(mark)) << v;
    }
    if (PointMarks::HasTie(static_cast<PointMarks::Mark>(all)) ||
      (!cell.IsAscending && (!this->AreIdsRanks || ExtractionCell::IsCollapsed(cell.Ids, corners))))
    {
      return false;
    }
    const vtkIsotable::Case& what = this->Tables[cell.Shape].GetCase(static_cast<int>(key));
    const bool isInverted = this->IsInverted(cell);
    const Item& item = this->Values.GetItems().front();
    SoupPart::Index points[vtkIsotable::MaximumNumberOfSlots];
    // The order of the slots is that of the edges' lower ends, then of the upper ones.
    std::uint64_t ranks[vtkIsotable::MaximumNumberOfSlots];
    soup.Reserve();
    for (const Slot slot : what.Slots)
    {
      // Without ties no slot is a corner, and a contour has one value on an edge.
      const ShapeTables::SlotEnds& ends = this->Tables.GetEnds(cell.Shape, slot);
      const auto [owner, far] = std::minmax({ cell.Ids[ends.A], cell.Ids[ends.B] });
      points[slot] = soup.Enter(owner, CrossingKey(far, item.Lower));
      ranks[slot] = (static_cast<std::uint64_t>(owner) << 32) | static_cast<std::uint64_t>(far);
    }
    const vtkIsotable::Simplex* simplices = what.Simplices.data();
    std::size_t number = what.Simplices.size();
    if (!cell.IsAscending)
    {
      const ChunkCuts::Place begin = chunk.Cuts.Begin();
      this->Tables[cell.Shape].Cut(
        what, ranks, [&chunk](const vtkIsotable::Simplex& s) { chunk.Cuts.AddSimplex(s); },
        [](const vtkIsotable::Triangle&) {});
      chunk.Cuts.End(begin);
      ChunkCuts::SlotRoom slots;
      const CellCut cut = chunk.Cuts.GetLast(begin, what, false, this->CutKind, slots);
      simplices = cut.Simplices;
      number = cut.NumberOfSimplices;
    }
    soup.Add(simplices, number, points, isInverted);
    chunk.Simplices += static_cast<vtkIdType>(number);
    this->CountOutput(cell, true, chunk);
    chunk.Cuts.Add({ position, static_cast<int>(key), 0, cell.IsAscending, false, isInverted });
    return true;
  }

  // Counts a cell with output, and whether it is folded.
  void CountOutput(const Cell& cell, bool hasOutput, Chunk& chunk) const
  {
    chunk.Report.CellsWithOutput += hasOutput;
    chunk.Report.FoldedCells += hasOutput && !this->Context.KeepOrientation &&
      this->Orientation.IsFolded(cell.Shape, cell.Ids);
  }

  // Returns whether a cell is left-handed.
  bool IsInverted(const Cell& cell) const
  {
    return this->Context.KeepOrientation ? cell.IsReflected
                                         : this->Orientation.IsInverted(cell.Shape, cell.Ids);
  }

  void CountCell(Cell& cell, vtkIdType position, Chunk& chunk, CrossingLists::Arena* arena,
    SoupBuilder* soup, MergedCut& merged, std::vector<vtkIdType>& points)
  {
    Code least = std::numeric_limits<Code>::max();
    Code greatest = 0;
    for (int v = 0; v < cell.NumberOfCorners; ++v)
    {
      cell.Codes[v] = this->Codes[cell.Ids[v]];
      least = std::min(least, cell.Codes[v]);
      greatest = std::max(greatest, cell.Codes[v]);
    }
    const bool isInverted = this->IsInverted(cell);
    const vtkIdType before = GetOutput(chunk);
    const int base = this->Values.GetBase();
    const auto& items = this->Values.GetItems();
    for (std::size_t number = 0; number < items.size(); ++number)
    {
      const Item& item = items[number];
      if (this->Values.IsOutside(item, least, greatest))
      {
        continue;
      }
      if constexpr (KeepsWhole)
      {
        if (this->Whole.IsWhole(cell.Id, item, least, greatest))
        {
          this->EnterWhole(cell.Id, position, number, chunk, arena, points);
          continue;
        }
      }
      int key = 0;
      for (int v = 0, power = 1; v < cell.NumberOfCorners; ++v, power *= base)
      {
        key += power * item.GetDigit(cell.Codes[v]);
      }
      const vtkIsotable::Case& what = this->Tables[cell.Shape].GetCase(key);
      Slot same[vtkIsotable::MaximumNumberOfSlots];
      const bool isMerged = this->Merge(cell, item, what, same);
      const bool isPlain = cell.IsAscending && !isMerged;
      ChunkCuts::SlotRoom slots;
      const CellCut cut = isPlain
        ? ChunkCuts::GetTableCut(what, this->CutKind)
        : this->MakeCut(cell, item, what, isMerged ? same : nullptr, merged, chunk, slots);
      if (soup)
      {
        this->AddToSoup(cell, item, cut, isInverted, *soup);
        if (isMerged)
        {
          this->FindTiedFaces(cell.Shape, cut, merged);
        }
      }
      else
      {
        this->EnterCut(cell, item, cut, chunk, *arena);
      }
      chunk.Simplices += static_cast<vtkIdType>(cut.NumberOfSimplices);
      chunk.Triangles += static_cast<vtkIdType>(cut.NumberOfTriangles);
      chunk.Cuts.Add({ position, key, number, isPlain, isMerged, isInverted });
    }
    this->CountOutput(cell, GetOutput(chunk) != before, chunk);
  }

  // Enters the points of a cut.
  void EnterCut(const Cell& cell, const Item& item, const CellCut& cut, Chunk& chunk,
    CrossingLists::Arena& arena)
  {
    for (std::size_t s = 0; s < cut.NumberOfSlots; ++s)
    {
      vtkIdType owner;
      const CrossingKey point = this->GetPoint(cell, item, cut.Slots[s], owner);
      const CrossingLists::Node* node = this->Points->Enter(owner, point, arena);
      if (this->KeepsNodes)
      {
        chunk.Nodes.push_back(node);
      }
    }
  }

  // Adds the triangles of a cut, each with points of its own.
  void AddToSoup(const Cell& cell, const Item& item, const CellCut& cut, bool isInverted,
    SoupBuilder& soup) const
  {
    SoupPart::Index points[vtkIsotable::MaximumNumberOfSlots];
    soup.Reserve();
    for (std::size_t s = 0; s < cut.NumberOfSlots; ++s)
    {
      vtkIdType owner;
      const CrossingKey key = this->GetPoint(cell, item, cut.Slots[s], owner);
      points[cut.Slots[s]] = soup.Enter(owner, key);
    }
    soup.Add(cut.Simplices, cut.NumberOfSimplices, points, isInverted);
  }

  // Notes whether triangles of a cell with merged slots lie in one face of it.
  void FindTiedFaces(vtkIsotable::Shapes shape, const CellCut& cut, MergedCut& merged)
  {
    if (std::any_of(cut.Simplices, cut.Simplices + cut.NumberOfSimplices,
          [&](const vtkIsotable::Simplex& simplex)
          { return merged.IsInFace(this->Tables[shape], simplex); }))
    {
      this->HasTiedFaces.store(true, std::memory_order_relaxed);
    }
  }

  static vtkIdType GetOutput(const Chunk& chunk)
  {
    if constexpr (KeepsWhole)
    {
      return chunk.Simplices + chunk.Whole;
    }
    else
    {
      return chunk.Simplices;
    }
  }

  bool FindPolyhedra()
  {
    if constexpr (KeepsWhole)
    {
      return this->Whole.FindRanges(this->Codes.GetData(), this->NumberOfCells);
    }
    else
    {
      return true;
    }
  }

  // Counts a cell that is whole in each interval that it touches. Returns false, and counts
  // nothing, where it is not.
  bool CountAsWhole(vtkIdType id, vtkIdType position, Chunk& chunk, CrossingLists::Arena* arena,
    std::vector<vtkIdType>& points)
  {
    if constexpr (KeepsWhole)
    {
      if (this->Whole.IsPassed(id))
      {
        this->EnterWhole(id, position, 0, chunk, arena, points);
        ++chunk.Report.CellsWithOutput;
        return true;
      }
      Cell cell;
      const CellCorners& corners = this->Cells.GetCorners(id);
      cell.Shape = corners.Shape;
      this->Cells.GetIds(id, corners, cell.Ids);
      Code least = ExtractionValues::NoCode;
      Code greatest = 0;
      for (int v = 0; v < corners.NumberOfCorners; ++v)
      {
        least = std::min(least, this->Codes[cell.Ids[v]]);
        greatest = std::max(greatest, this->Codes[cell.Ids[v]]);
      }
      const auto& items = this->Values.GetItems();
      if (!std::all_of(items.begin(), items.end(),
            [&](const Item& item)
            {
              return this->Values.IsOutside(item, least, greatest) ||
                this->Whole.IsWhole(id, item, least, greatest);
            }))
      {
        return false;
      }
      const vtkIdType before = GetOutput(chunk);
      for (std::size_t number = 0; number < items.size(); ++number)
      {
        if (!this->Values.IsOutside(items[number], least, greatest))
        {
          this->EnterWhole(id, position, number, chunk, arena, points);
        }
      }
      this->CountOutput(cell, GetOutput(chunk) != before, chunk);
      return true;
    }
    else
    {
      return false;
    }
  }

  void EnterWhole(vtkIdType id, vtkIdType position, std::size_t item, Chunk& chunk,
    CrossingLists::Arena* arena, std::vector<vtkIdType>& points)
  {
    this->Whole.GetPoints(id, points);
    if (points.empty())
    {
      return;
    }
    for (const vtkIdType point : points)
    {
      this->Points->Enter(point, {}, *arena);
    }
    ++chunk.Whole;
    chunk.WholeIds += static_cast<vtkIdType>(points.size());
    chunk.WholeCases.push_back(
      { static_cast<std::uint16_t>(position), static_cast<std::uint16_t>(item) });
  }

  // Finds which slots are the same point. Returns false where none are.
  bool Merge(const Cell& cell, const Item& item, const vtkIsotable::Case& what, Slot* same) const
  {
    if (!this->HasEqualPoints(cell, item))
    {
      return false;
    }
    std::iota(same, same + vtkIsotable::MaximumNumberOfSlots, Slot(0));
    ExtractionCell::IdentifyAll(
      this->Tables[cell.Shape], item, cell.Codes, what.Slots,
      ExtractionCell::IsCollapsed(cell.Ids, cell.NumberOfCorners),
      [&](Slot slot)
      {
        vtkIdType owner;
        const CrossingKey key = this->GetPoint(cell, item, slot, owner);
        return std::make_pair(owner, key);
      },
      same);
    return MergedCut::IsNeeded(what, same);
  }

  // Cuts a case in the global order, and keeps the cut; \a same tells which slots are the same
  // point, where there are such.
  CellCut MakeCut(const Cell& cell, const Item& item, const vtkIsotable::Case& what,
    const Slot* same, MergedCut& merged, Chunk& chunk, ChunkCuts::SlotRoom& slots) const
  {
    const vtkIsotable& table = this->Tables[cell.Shape];
    const ChunkCuts::Place begin = chunk.Cuts.Begin();
    Slot vertexRanks[8];
    this->Order.Rank(cell.Ids, cell.NumberOfCorners, vertexRanks);
    const vtkIsotable::RankArray ranks = table.GetSlotRanks(vertexRanks);
    const auto simplex = [&](const vtkIsotable::Simplex& s) { chunk.Cuts.AddSimplex(s); };
    const auto boundary = [&](const vtkIsotable::Triangle& t)
    {
      if (this->Context.GenerateBoundaries)
      {
        chunk.Cuts.AddTriangle(t);
      }
    };
    if (same)
    {
      merged.Make(table, item, cell.Codes, what, ranks, same, this->Context.GenerateBoundaries);
      std::for_each(merged.GetSimplices().begin(), merged.GetSimplices().end(), simplex);
      std::for_each(merged.GetTriangles().begin(), merged.GetTriangles().end(), boundary);
      chunk.Report.CollapsedSimplices += merged.GetNumberCollapsed();
    }
    else
    {
      table.Cut(what, ranks, simplex, boundary);
    }
    chunk.Cuts.End(begin);
    return chunk.Cuts.GetLast(begin, what, same != nullptr, this->CutKind, slots);
  }

  // Turns the counts of chunks into the places where they begin, and makes room for all.
  void Allocate()
  {
    vtkIdType simplices = 0;
    vtkIdType triangles = 0;
    vtkIdType whole = 0;
    vtkIdType wholeIds = 0;
    for (Chunk& chunk : this->Chunks)
    {
      // After the exchange a chunk has the sum of those before it.
      const auto sum = [](vtkIdType& count, vtkIdType& total)
      {
        std::swap(count, total);
        total += count;
      };
      sum(chunk.Simplices, simplices);
      sum(chunk.Triangles, triangles);
      if constexpr (KeepsWhole)
      {
        sum(chunk.Whole, whole);
        sum(chunk.WholeIds, wholeIds);
      }
      this->Context.Report->Add(chunk.Report);
    }
    this->Mesh.Allocate(static_cast<vtkIdType>(this->Mesh.Points.GetSize()), simplices,
      this->CutKind.SimplexSize, triangles, this->Context.KeepCellIds, whole, wholeIds);
    if (!this->Points)
    {
      this->Mesh.Simplices.NumberConsecutively();
      this->Context.Soup->Allocate(3 * simplices);
    }
  }

  void NoteWorkingBytes() const
  {
    std::size_t bytes = this->Codes.GetBytes() + this->Marks.GetBytes() +
      (this->Points ? this->Points->GetBytes() : 0) + this->Mesh.Points.GetBytes();
    for (const Chunk& chunk : this->Chunks)
    {
      bytes += chunk.GetBytes();
    }
    this->Context.NoteWorkingBytes(bytes);
  }

  // Calls visit(cell, shape, found, cut) for each case of a chunk.
  template <typename Visitor>
  void ForEachCut(vtkIdType number, Visitor&& visit) const
  {
    this->Chunks[number].Cuts.ForEach(
      number * ChunkSize, this->Tables, this->CutKind,
      [this](vtkIdType cell) { return this->Cells.GetCorners(cell).Shape; }, visit);
  }

  void WriteChunk(vtkIdType number)
  {
    Chunk& chunk = this->Chunks[number];
    vtkIdType simplex = chunk.Simplices;
    vtkIdType triangle = chunk.Triangles;
    auto node = chunk.Nodes.begin();
    vtkIdType ids[vtkIsotable::MaximumNumberOfSlots];
    MergedCut merged;
    Cell cell{};
    cell.Id = -1;
    this->ForEachCut(number,
      [&](
        vtkIdType id, vtkIsotable::Shapes shape, const ChunkCuts::Found& found, const CellCut& cut)
      {
        if (this->KeepsNodes)
        {
          for (std::size_t s = 0; s < cut.NumberOfSlots; ++s)
          {
            ids[cut.Slots[s]] = (*node++)->Id;
          }
        }
        else
        {
          this->ReadNext(id, cell);
          this->FindIds(cell, this->Values.GetItems()[found.Item], cut, ids);
        }
        if (found.IsMerged)
        {
          this->NoteTied(shape, cut, simplex, triangle, merged, chunk);
        }
        this->WriteCut(id, found, cut, ids, simplex, triangle);
      });
    if constexpr (KeepsWhole)
    {
      this->WriteWhole(number * ChunkSize, chunk);
    }
  }

  // Writes the triangles of a chunk that share no points.
  void WriteSoup(vtkIdType number)
  {
    Chunk& chunk = this->Chunks[number];
    this->Context.Soup->Write(chunk.Soup, 3 * chunk.Simplices);
    chunk.Soup = SoupPart();
    if (this->Mesh.HasSeveralItems || this->Context.KeepCellIds)
    {
      vtkIdType simplex = chunk.Simplices;
      this->ForEachCut(number,
        [&](vtkIdType id, vtkIsotable::Shapes, const ChunkCuts::Found& found, const CellCut& cut)
        {
          this->Mesh.NoteSimplices(simplex, cut.NumberOfSimplices, found.Item, id);
          simplex += static_cast<vtkIdType>(cut.NumberOfSimplices);
        });
    }
  }

  // Writes the cells of a chunk that are passed on whole; its first one is \a begin.
  void WriteWhole(vtkIdType begin, const Chunk& chunk)
  {
    std::vector<vtkIdType> points;
    vtkIdType whole = chunk.Whole;
    vtkIdType place = chunk.WholeIds;
    for (const FoundWhole& found : chunk.WholeCases)
    {
      const vtkIdType id = begin + found.Position;
      const unsigned char type = this->Whole.GetPoints(id, points);
      for (vtkIdType& point : points)
      {
        point = this->Points->GetId(point, {});
      }
      const int number = static_cast<int>(points.size());
      this->Mesh.WriteWhole(whole++, place, type, points.data(), number, found.Item, id);
      place += number;
    }
  }

  // Notes the simplices and triangles of a cell with merged slots that have to be compared with
  // those of its neighbours.
  void NoteTied(vtkIsotable::Shapes shape, const CellCut& cut, vtkIdType simplex,
    vtkIdType triangle, MergedCut& merged, Chunk& chunk) const
  {
    for (std::size_t t = 0; t < cut.NumberOfTriangles; ++t)
    {
      chunk.TiedTriangles.push_back(triangle + static_cast<vtkIdType>(t));
    }
    for (std::size_t s = 0; s < cut.NumberOfSimplices; ++s)
    {
      if (merged.IsInFace(this->Tables[shape], cut.Simplices[s]))
      {
        chunk.TiedSimplices.push_back(simplex + static_cast<vtkIdType>(s));
      }
    }
  }

  // Finds the output ids of a cut's points, by slot.
  void FindIds(const Cell& cell, const Item& item, const CellCut& cut, vtkIdType* ids) const
  {
    for (std::size_t s = 0; s < cut.NumberOfSlots; ++s)
    {
      vtkIdType owner;
      const CrossingKey key = this->GetPoint(cell, item, cut.Slots[s], owner);
      ids[cut.Slots[s]] = this->Points->GetId(owner, key);
    }
  }

  void WriteCut(vtkIdType cell, const ChunkCuts::Found& found, const CellCut& cut,
    const vtkIdType* ids, vtkIdType& simplex, vtkIdType& triangle)
  {
    this->Mesh.Simplices.Write(
      simplex, cut.Simplices, cut.NumberOfSimplices, ids, found.IsInverted);
    this->Mesh.NoteSimplices(simplex, cut.NumberOfSimplices, found.Item, cell);
    simplex += static_cast<vtkIdType>(cut.NumberOfSimplices);
    for (std::size_t t = 0; t < cut.NumberOfTriangles; ++t, ++triangle)
    {
      const vtkIsotable::Triangle& points = cut.Triangles[t];
      this->Mesh.WriteTriangle(triangle, { { ids[points[0]], ids[points[1]], ids[points[2]] } },
        found.IsInverted, found.Item, points[3], cell);
    }
  }

  const ExtractionContext& Context;
  const ExtractionValues& Values;
  std::unique_ptr<ExtractionScalars> Scalars;
  UnstructuredCells<Stored> Cells;
  WholeParts<Stored, KeepsWhole> Whole;
  CornerOrder Order;
  CellOrientation Orientation;
  ExtractionMesh& Mesh;
  vtkIdType NumberOfPoints;
  vtkIdType NumberOfCells;
  ShapeTables Tables;
  ChunkCuts::Kind CutKind;

  ExtractionBuffer<Code> Codes;
  PointMarks Marks;
  // Whether corners are ordered by ids that fit in 32 bits.
  bool AreIdsRanks;
  // Whether the nodes of points are kept. A contour is small beside its grid: it is quicker to note
  // the points of its cells than to look them up once more. For the tetrahedra of an interval that
  // would take too much memory.
  bool KeepsNodes;
  // The points that cells share; none where every triangle has points of its own.
  std::optional<CrossingLists> Points;
  std::atomic<bool> HasTiedFaces{ false };
  ThreadLocals<SoupBuilder> Soups;
  std::vector<Chunk> Chunks;
};

template <typename Array>
bool Extract(const ExtractionContext& context, vtkUnstructuredGrid* grid, ExtractionMesh& mesh)
{
  const auto offsets = ArrayViews::Get<Array>(grid->GetCells()->GetOffsetsArray());
  const auto ids = ArrayViews::Get<Array>(grid->GetCells()->GetConnectivityArray());
  using Stored = typename Array::ValueType;
  const Stored* firstOffset = offsets->GetPointer(0);
  const Stored* firstId = ids->GetPointer(0);
  return context.Whole
    ? Extractor<Stored, true>(context, grid, firstOffset, firstId, mesh).Execute()
    : Extractor<Stored, false>(context, grid, firstOffset, firstId, mesh).Execute();
}
}

bool UnstructuredExtraction::Execute(
  const ExtractionContext& context, vtkUnstructuredGrid* grid, ExtractionMesh& mesh)
{
  if (grid->GetNumberOfCells() == 0)
  {
    return true;
  }
  return GridCells::IsNarrow(grid->GetCells()->GetConnectivityArray())
    ? Extract<GridCells::NarrowIds>(context, grid, mesh)
    : Extract<GridCells::WideIds>(context, grid, mesh);
}

}
