// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeVaryingExtraction.h"

#include "TimeVarying/TimeVaryingReport.h"
#include "Pass/CriterionRange.h"
#include "Pass/ExtractionStages.h"
#include "Scalars/ExtractionScalars.h"
#include "SpaceTime/SpaceTimeTable.h"
#include "TimeVarying/FacePlanarity.h"
#include "TimeVarying/FlatFacetCache.h"
#include "TimeVarying/TimeVaryingBoundary.h"
#include "TimeVarying/TimeVaryingCells.h"
#include "TimeVarying/TimeVaryingCut.h"
#include "TimeVarying/TimeVaryingMesh.h"
#include "TimeVarying/SpaceTimeSlots.h"
#include "Unstructured/CrossingLists.h"

#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace interlume
{

namespace
{
using Cell = TimeVaryingCell;
using Case = SpaceTimeTable::Case;
using Item = ExtractionValues::Item;
using Slot = SpaceTimeTable::Slot;
using Simplex = SpaceTimeTable::Simplex;
using Tables = SlotTables<SpaceTimeTable>;

// Number of cells in a chunk. Small chunks balance the load of the threads, because cells with
// output tend to cluster.
constexpr vtkIdType ChunkSize = 512;
constexpr int MaximumNumberOfVertices = SpaceTimeTable::MaximumNumberOfVertices;
constexpr int MaximumNumberOfSlots = SpaceTimeTable::MaximumNumberOfSlots;

// The case of a cell in a chunk.
struct Found
{
  vtkIdType Cell;
  const SpaceTimeTable::Case* Case;
  int Item;
  // If true, the cut stored in the table applies: the corner ids are in ascending order and all
  // slots are distinct points.
  bool IsPlain;
};

struct Chunk
{
  std::vector<Found> Cases;
  std::vector<TimeVaryingMesh::BoundaryCell> Boundary;
  // Tetrahedra of the interval volume at either step, from cells with merged slots.
  std::vector<TimeVaryingMesh::BoundaryCell> StepVolume;
  // Indices of the 4-simplices from cells with merged slots that lie above a single cell face (see
  // SpaceTimeSlots).
  std::vector<vtkIdType> Tied;
  vtkIdType Simplices = 0;
  bool HasDuplicates = false;
  ExtractionReport Report;
};

// Cut computed for a single cell because the cut stored in the table does not apply: the corner ids
// are not in ascending order, or several slots are the same point.
struct OwnCut
{
  std::vector<Simplex> Simplices;
  // The simplices and boundary cells if slots were merged. Otherwise the boundary cells are derived
  // from the simplices.
  TimeVaryingCut Merged;
  bool IsMerged = false;
  // The slots in use, in ascending order.
  std::vector<Slot> Slots;

  const std::vector<Simplex>& GetSimplices() const
  {
    return this->IsMerged ? this->Merged.GetSimplices() : this->Simplices;
  }
};

// The table readers and the buffers of a thread.
struct Local
{
  std::array<std::optional<SpaceTimeTable::Reader>, SpaceTimeTable::NumberOfShapes> Readers;
  std::optional<FlatFacetCache> Flats;
  std::vector<vtkIdType> Near;
  OwnCut Own;

  const Case& GetCase(vtkIsotable::Shapes shape, std::uint32_t key)
  {
    auto& reader = this->Readers[shape];
    if (!reader)
    {
      reader.emplace(SpaceTimeTable::Get(shape));
    }
    return reader->GetCase(key);
  }

  FlatFacetCache& GetFlats()
  {
    if (!this->Flats)
    {
      this->Flats.emplace();
    }
    return *this->Flats;
  }
};

// Cuts the cells of a slab. How a cell is split depends on the global order of its points (see
// CornerOrder), so that adjacent cells match.
class SlabCutter
{
public:
  SlabCutter(const CornerOrder& order, const TimeVaryingMesh& mesh)
    : Order(order)
    , Mesh(mesh)
    , TheTables(SpaceTimeTable::NumberOfShapes,
        [](vtkIsotable::Shapes shape) -> const SpaceTimeTable&
        { return SpaceTimeTable::Get(shape); })
  {
    for (int shape = 0; shape < SpaceTimeTable::NumberOfShapes; ++shape)
    {
      this->Slots.emplace_back(static_cast<vtkIsotable::Shapes>(shape));
    }
  }

  const SpaceTimeSlots& GetSlots(vtkIsotable::Shapes shape) const { return this->Slots[shape]; }

  // Calls visit(slot, owner, key) for the points of the given slots.
  template <typename Visitor>
  void ForEachPoint(
    const Cell& cell, const Item& item, const std::vector<Slot>& slots, Visitor&& visit) const
  {
    for (const Slot slot : slots)
    {
      vtkIdType owner;
      const CrossingKey key = this->TheTables.GetPoint(cell, item, slot, owner);
      visit(slot, owner, key);
    }
  }

  static const Case& GetCase(const Cell& cell, const Item& item, Local& local)
  {
    std::uint32_t key = 0;
    std::uint32_t power = 1;
    for (int v = 0; v < cell.GetNumberOfVertices(); ++v, power *= 3)
    {
      key += power * item.GetDigit(cell.Codes[v]);
    }
    return local.GetCase(cell.Shape, key);
  }

  // Returns true if the cut stored in the table applies. Otherwise merges the slots of the same
  // point, cuts the case according to the global order, and stores the cut in \a local.
  bool Cut(const Cell& cell, const Item& item, const Case& what, Local& local) const
  {
    OwnCut& cut = local.Own;
    Slot same[MaximumNumberOfSlots];
    cut.IsMerged = this->TheTables.Merge(cell, item, what, same);
    if (!cut.IsMerged && cell.IsAscending)
    {
      return true;
    }
    const SpaceTimeTable& table = this->TheTables[cell.Shape];
    // The corners at the first step precede those at the second step.
    constexpr int most = MaximumNumberOfVertices / 2;
    const int corners = std::min(cell.NumberOfCorners, most);
    Slot vertexRanks[MaximumNumberOfVertices];
    this->Order.Rank(cell.Ids, corners, vertexRanks);
    for (int v = 0; v < corners && v < most; ++v) // The second condition shows GCC the array bound.
    {
      vertexRanks[v + corners] = static_cast<Slot>(vertexRanks[v] + corners);
    }
    const SpaceTimeTable::RankArray ranks = table.GetSlotRanks(vertexRanks);
    if (cut.IsMerged)
    {
      const Case& inside = item.IsFlat
        ? local.GetCase(cell.Shape, CoincidentSlots::GetAllInsideKey(2 * corners))
        : what;
      cut.Merged.Compute(table, this->Slots[cell.Shape], item, cell.Codes, what, inside, ranks,
        same, this->Mesh.HasRequiredKinds() || this->Mesh.GetOptions().Settings.GenerateSimplices);
    }
    else
    {
      cut.Simplices.clear();
      table.Cut(what, ranks, [&cut](const Simplex& simplex) { cut.Simplices.push_back(simplex); });
    }
    this->FindSlots(cut);
    return false;
  }

private:
  void FindSlots(OwnCut& cut) const
  {
    bool isUsed[MaximumNumberOfSlots] = {};
    for (const Simplex& simplex : cut.GetSimplices())
    {
      std::for_each(simplex.begin(), simplex.end(), [&](Slot slot) { isUsed[slot] = true; });
    }
    if (cut.IsMerged)
    {
      for (const TimeVaryingCut::Side& side : cut.Merged.GetSides())
      {
        std::for_each_n(side.Points.begin(),
          this->Mesh.IsRequiredIfTied(side.Kind) ? side.Number : 0,
          [&](Slot slot) { isUsed[slot] = true; });
      }
    }
    cut.Slots.clear();
    for (int slot = 0; slot < MaximumNumberOfSlots; ++slot)
    {
      if (isUsed[slot])
      {
        cut.Slots.push_back(static_cast<Slot>(slot));
      }
    }
  }

  const CornerOrder& Order;
  const TimeVaryingMesh& Mesh;
  Tables TheTables;
  std::vector<SpaceTimeSlots> Slots;
};

// Writes the cuts of cells to a mesh.
class SlabWriter
{
public:
  SlabWriter(
    const TimeStep& first, const TimeStep& second, const SlabCutter& cutter, TimeVaryingMesh& mesh)
    : Orientations{ CellOrientation(first.GetGrid()), CellOrientation(second.GetGrid()) }
    , Planarity(first, second)
    , Cutter(cutter)
    , Mesh(mesh)
    , MarksFlat(mesh.GetOptions().Settings.GenerateTetrahedra && mesh.GetOptions().IsAlongTime() &&
        Planarity.IsStatic())
  {
  }

  bool IsStatic() const { return this->Planarity.IsStatic(); }

  bool IsFolded(const Cell& cell) const
  {
    return std::any_of(this->Orientations, this->Orientations + 2,
      [&cell](const CellOrientation& one) { return one.IsFolded(cell.Shape, cell.Ids); });
  }

  bool IsInverted(const Cell& cell) const
  {
    const int sign = this->Orientations[0].GetSign(cell.Shape, cell.Ids);
    return (sign != 0 ? sign : this->Orientations[1].GetSign(cell.Shape, cell.Ids)) < 0;
  }

  // Writes the 4-simplices of a case, beginning at index \a next. \a ids holds the point id of each
  // slot.
  void WriteSimplices(const Cell& cell, const Found& found, Local& local, const vtkIdType* ids,
    bool isInverted, bool isDuplicate, vtkIdType next)
  {
    TimeVaryingMesh::Slab& slab = this->Mesh.GetSlab();
    const auto& simplices = found.IsPlain ? found.Case->Simplices : local.Own.GetSimplices();
    const std::size_t number = slab.Simplices.GetSize() > 0 ? simplices.size() : 0;
    // The first two points are swapped in a left-handed cell.
    const int first = isInverted ? 1 : 0;
    for (std::size_t s = 0; s < number; ++s)
    {
      const Simplex& slots = simplices[s];
      slab.Simplices[next + s] = { { ids[slots[first]], ids[slots[1 - first]], ids[slots[2]],
        ids[slots[3]], ids[slots[4]] } };
    }
    const auto note = [next, number](auto& values, auto value)
    {
      if (values.GetSize() > 0)
      {
        std::fill_n(values.GetData() + next, number, value);
      }
    };
    note(slab.Items, found.Item);
    note(slab.Ties,
      static_cast<std::uint8_t>(
        this->Mesh.HasStepVolumes() || (!found.IsPlain && local.Own.IsMerged)));
    note(slab.Duplicates, static_cast<std::uint8_t>(isDuplicate));
    if (!this->MarksFlat)
    {
      note(slab.Flats, std::uint8_t(0));
      return;
    }
    const SpaceTimeSlots& meaning = this->Cutter.GetSlots(cell.Shape);
    const unsigned planar = this->Planarity.GetPlanarFaces(cell, meaning);
    const std::uint8_t* const known =
      found.IsPlain ? local.GetFlats().Find(*found.Case, meaning, planar).data() : nullptr;
    for (std::size_t s = 0; s < number; ++s)
    {
      const std::uint8_t flat = known ? known[s] : meaning.FindFlatFacets(simplices[s], planar);
      slab.Flats[next + s] = isInverted ? FlatFacetCache::SwapFirst(flat) : flat;
    }
  }

  // Adds the boundary cells of a case to a chunk.
  void WriteBoundary(const Cell& cell, const Found& found, const OwnCut& cut, const vtkIdType* ids,
    bool isInverted, bool isDuplicate, Chunk& chunk) const
  {
    const bool isMerged = !found.IsPlain && cut.IsMerged;
    const auto make = [&](int kind, const Slot* slots, int number)
    {
      TimeVaryingMesh::BoundaryCell made{ { { -1, -1, -1, -1 } }, kind, found.Item, 0, isMerged,
        isDuplicate };
      for (int p = 0; p < number; ++p)
      {
        made.Ids[p] = ids[slots[p]];
      }
      if (isInverted)
      {
        std::swap(made.Ids[0], made.Ids[1]);
      }
      return made;
    };
    if (isMerged)
    {
      const bool hasSteps = this->Mesh.GetOptions().Settings.GenerateSimplices;
      for (const TimeVaryingCut::Side& side : cut.Merged.GetSides())
      {
        if (!this->Mesh.IsRequiredIfTied(side.Kind))
        {
          continue;
        }
        const auto made = make(side.Kind, side.Points.data(), side.Number);
        if (this->Mesh.IsRequired(side.Kind))
        {
          chunk.Boundary.push_back(made);
        }
        if (hasSteps && TimeVaryingMesh::IsVolume(side.Kind))
        {
          chunk.StepVolume.push_back(made);
        }
      }
      return;
    }
    const auto add = [&](int kind, const Slot* slots, int number)
    {
      const auto made = make(kind, slots, number);
      if (this->Mesh.IsRequired(kind))
      {
        chunk.Boundary.push_back(made);
      }
      if (this->Mesh.HasStepVolumes() && TimeVaryingMesh::IsVolume(kind))
      {
        chunk.StepVolume.push_back(made);
      }
    };
    for (const Simplex& simplex : found.IsPlain ? found.Case->Simplices : cut.Simplices)
    {
      TimeVaryingBoundary::ForEach(this->Cutter.GetSlots(cell.Shape), simplex, this->Mesh, add);
    }
  }

private:
  CellOrientation Orientations[2];
  FacePlanarity Planarity;
  const SlabCutter& Cutter;
  TimeVaryingMesh& Mesh;
  // If true, degenerate facets of the 4-simplices are recorded.
  bool MarksFlat;
};

// The cells that a part of a union consists of: all cells for the intervals, and those that a
// criterion overlaps for the region outside of them.
class UnionRegion
{
public:
  UnionRegion(const TimeStep& first, const TimeStep& second, const TimeVaryingOptions& options)
    : Constants(options.SkippedConstants)
    , Scalars{ first.GetScalars(), second.GetScalars() }
  {
    if (options.Part > 0)
    {
      const auto& criterion = options.Criteria[options.Part - 1];
      const auto find = [&criterion](const TimeStep& step)
      { return step.GetGrid()->GetPointData()->GetArray(criterion.ArrayName.c_str()); };
      this->Range.emplace(
        std::vector<vtkDataArray*>{ find(first), find(second) }, criterion.Lower, criterion.Upper);
    }
  }

  bool Includes(const Cell& cell) const
  {
    return !this->Range ||
      (this->Range->Overlaps(cell.Ids, cell.NumberOfCorners) &&
        std::none_of(this->Constants.begin(), this->Constants.end(),
          [this, &cell](double constant) { return this->IsConstant(cell, constant); }));
  }

private:
  bool IsConstant(const Cell& cell, double constant) const
  {
    return std::all_of(cell.Ids, cell.Ids + cell.NumberOfCorners,
      [this, constant](vtkIdType id)
      {
        return this->Scalars[0]->GetComponent(id, 0) == constant &&
          this->Scalars[1]->GetComponent(id, 0) == constant;
      });
  }

  const std::vector<double>& Constants;
  vtkDataArray* Scalars[2];
  std::optional<CriterionRange> Range;
};

template <typename Cells>
class SlabPass : public ExtractionStages<SlabPass<Cells>, Local>
{
  using Frame = ExtractionStages<SlabPass<Cells>, Local>;

public:
  static constexpr std::array<double, 4> Progress = { { 0.2, 0.6, 0.6, 1.0 } };

  SlabPass(const ExtractionContext& context, const TimeStep& first, const TimeStep& second,
    Cells& cells, const CornerOrder& order, TimeVaryingMesh& mesh, TimeVaryingReport& report)
    : Frame(context)
    , Steps{ &first, &second }
    , TheCells(cells)
    , Order(order)
    , Cutter(order, mesh)
    , Writer(first, second, Cutter, mesh)
    , Region(first, second, mesh.GetOptions())
    , Mesh(mesh)
    , Report(report)
    , NumberOfPoints(first.GetNumberOfPoints())
    , NumberOfCells(first.GetNumberOfCells())
    , HasBoundary(mesh.HasRequiredKinds())
    , Points(2 * first.GetNumberOfPoints(), false)
    , Chunks((first.GetNumberOfCells() + ChunkSize - 1) / ChunkSize)
  {
  }

  vtkIdType GetNumberOfParts() const { return static_cast<vtkIdType>(this->Chunks.size()); }

  bool Classify() { return this->TheCells.MakeMarks(this->Context); }

  void CountPart(vtkIdType number, Local& local)
  {
    Chunk& chunk = this->Chunks[number];
    CrossingLists::Arena& arena = this->Points.GetArena();
    const vtkIdType begin = number * ChunkSize;
    const vtkIdType end = std::min(begin + ChunkSize, this->NumberOfCells);
    local.Near.clear();
    this->TheCells.FindIntersectedCells(begin, end, local.Near, chunk.Report);
    chunk.Report.CellsVisited = end - begin;
    Cell cell;
    for (const vtkIdType id : local.Near)
    {
      this->Read(id, cell);
      if (this->Region.Includes(cell))
      {
        this->CountCell(cell, chunk, local, arena);
      }
    }
  }

  bool Settle()
  {
    const auto scalars = ExtractionScalars::MakePair(this->Steps[0]->GetScalars(),
      this->Steps[1]->GetScalars(), this->NumberOfPoints, this->Values);
    ExtractionBuffer<ExtractionPoint> points;
    this->Points.MakePoints(*scalars, points);
    this->Order.SortMidpointEnds(points.GetData(), points.GetSize(), this->NumberOfPoints);
    this->Ids = this->Mesh.AddPoints(
      *this->Steps[0], *this->Steps[1], points, this->Points, this->Writer.IsStatic());
    this->NoteReport(points.GetBytes());
    this->TheCells.FreeMarks();
    return true;
  }

  void Allocate()
  {
    vtkIdType simplices = 0;
    for (Chunk& chunk : this->Chunks)
    {
      std::swap(chunk.Simplices, simplices);
      simplices += chunk.Simplices;
      this->Report.Add(chunk.Report);
    }
    const vtkTimeVaryingSettings& settings = this->Mesh.GetOptions().Settings;
    TimeVaryingMesh::Slab& slab = this->Mesh.GetSlab();
    // If a value equals a bound, the 4-simplices are needed to determine which boundary cells
    // remain. If there are criteria, the 4-simplices are needed for the boundary at their bounds.
    const TimeVaryingOptions& options = this->Mesh.GetOptions();
    const bool isNeeded = settings.GenerateTetrahedra || settings.GenerateSimplices ||
      (options.HasBoundary() && options.GetNumberOfCuts() > 0) ||
      (this->HasBoundary && (this->Steps[0]->HasTies() || this->Steps[1]->HasTies()));
    slab.Simplices.Allocate(isNeeded ? simplices : 0);
    slab.Items.Allocate(isNeeded && this->Values.GetItems().size() > 1 ? simplices : 0);
    slab.Flats.Allocate(settings.GenerateTetrahedra ? simplices : 0);
    slab.Ties.Allocate(settings.GenerateSimplices ? simplices : 0);
    const bool hasDuplicates = std::any_of(this->Chunks.begin(), this->Chunks.end(),
      [](const Chunk& chunk) { return chunk.HasDuplicates; });
    slab.Duplicates.Allocate(isNeeded && hasDuplicates ? simplices : 0);
    this->Report.Simplices += simplices;
  }

  void WritePart(vtkIdType number, Local& local)
  {
    Chunk& chunk = this->Chunks[number];
    vtkIdType next = chunk.Simplices;
    Cell cell;
    for (const Found& found : chunk.Cases)
    {
      if (found.Cell != cell.Id)
      {
        this->Read(found.Cell, cell);
      }
      const Item& item = this->Values.GetItems()[found.Item];
      if (!found.IsPlain)
      {
        this->Cutter.Cut(cell, item, *found.Case, local);
      }
      vtkIdType ids[MaximumNumberOfSlots];
      this->Cutter.ForEachPoint(cell, item, found.IsPlain ? found.Case->Slots : local.Own.Slots,
        [&](Slot slot, vtkIdType owner, CrossingKey key)
        { ids[slot] = this->Ids[this->Points.GetId(owner, key)]; });
      const bool isInverted = this->Writer.IsInverted(cell);
      const bool isDuplicate = this->TheCells.IsDuplicate(cell.Id);
      const auto& simplices = found.IsPlain ? found.Case->Simplices : local.Own.GetSimplices();
      const bool isMerged = !found.IsPlain && local.Own.IsMerged;
      this->Writer.WriteSimplices(cell, found, local, ids, isInverted, isDuplicate, next);
      for (std::size_t s = 0; isMerged && s < simplices.size(); ++s)
      {
        if (this->Cutter.GetSlots(cell.Shape).IsAboveFace(simplices[s]))
        {
          chunk.Tied.push_back(next + static_cast<vtkIdType>(s));
        }
      }
      next += static_cast<vtkIdType>(simplices.size());
      if (this->HasBoundary || this->Mesh.HasStepVolumes() ||
        (isMerged && this->Mesh.GetOptions().Settings.GenerateSimplices))
      {
        this->Writer.WriteBoundary(cell, found, local.Own, ids, isInverted, isDuplicate, chunk);
      }
    }
  }

  // Adds the boundary cells of all chunks to the mesh in order, and removes pairs of 4-simplices
  // with the same points and opposite orientation. Two neighbor cells may have such a pair above
  // their common face.
  void Finish()
  {
    std::vector<vtkIdType> tied;
    for (const Chunk& chunk : this->Chunks)
    {
      this->Mesh.AddBoundary(chunk.Boundary);
      this->Mesh.AddStepVolume(chunk.StepVolume);
      tied.insert(tied.end(), chunk.Tied.begin(), chunk.Tied.end());
    }
    if (!tied.empty() && this->Mesh.GetSlab().Simplices.GetSize() > 0)
    {
      this->Report.Simplices -= this->Mesh.RemoveOppositeSimplices(tied);
    }
  }

private:
  void Read(vtkIdType id, Cell& cell) const
  {
    this->TheCells.Read(id, cell);
    for (int v = 0; v < cell.NumberOfCorners; ++v)
    {
      cell.Ids[v + cell.NumberOfCorners] = cell.Ids[v] + this->NumberOfPoints;
      cell.Codes[v] = this->Steps[0]->GetCodes()[cell.Ids[v]];
      cell.Codes[v + cell.NumberOfCorners] = this->Steps[1]->GetCodes()[cell.Ids[v]];
    }
  }

  void CountCell(const Cell& cell, Chunk& chunk, Local& local, CrossingLists::Arena& arena)
  {
    const auto range = std::minmax_element(cell.Codes, cell.Codes + cell.GetNumberOfVertices());
    const vtkIdType before = chunk.Simplices;
    const auto& items = this->Values.GetItems();
    for (std::size_t number = 0; number < items.size(); ++number)
    {
      const Item& item = items[number];
      if (this->Values.IsOutside(item, *range.first, *range.second))
      {
        continue;
      }
      const Case& what = SlabCutter::GetCase(cell, item, local);
      const bool isPlain = this->Cutter.Cut(cell, item, what, local);
      const auto& simplices = isPlain ? what.Simplices : local.Own.GetSimplices();
      if (!isPlain && local.Own.IsMerged)
      {
        // A cut in another slot order may have more simplices than the stored cut.
        const std::size_t left = std::min(simplices.size(), what.Simplices.size());
        chunk.Report.CollapsedSimplices += static_cast<vtkIdType>(what.Simplices.size() - left);
      }
      this->Cutter.ForEachPoint(cell, item, isPlain ? what.Slots : local.Own.Slots,
        [&](Slot, vtkIdType owner, CrossingKey key) { this->Points.Enter(owner, key, arena); });
      chunk.Simplices += static_cast<vtkIdType>(simplices.size());
      chunk.Cases.push_back({ cell.Id, &what, static_cast<int>(number), isPlain });
    }
    const bool isDuplicate = this->TheCells.IsDuplicate(cell.Id);
    chunk.HasDuplicates |= isDuplicate;
    const bool hasOutput = chunk.Simplices != before && !isDuplicate;
    chunk.Report.CellsWithOutput += hasOutput;
    chunk.Report.FoldedCells += hasOutput && this->Writer.IsFolded(cell);
  }

  void NoteReport(std::size_t bytes)
  {
    for (const Local& local : this->Locals)
    {
      for (const auto& reader : local.Readers)
      {
        this->Report.TableLookups += reader ? reader->GetNumberOfLookups() : 0;
        this->Report.TableCasesComputed += reader ? reader->GetNumberOfCasesMade() : 0;
      }
    }
    bytes += this->TheCells.GetMarkBytes() + this->Points.GetBytes() + this->Ids.GetBytes() +
      this->Mesh.GetBytes() + this->Steps[0]->GetBytes() + this->Steps[1]->GetBytes();
    for (const Chunk& chunk : this->Chunks)
    {
      bytes += chunk.Cases.capacity() * sizeof(Found);
    }
    this->Context.UpdatePeakWorkingBytes(bytes);
  }

  const TimeStep* Steps[2];
  Cells& TheCells;
  const CornerOrder& Order;
  SlabCutter Cutter;
  SlabWriter Writer;
  UnionRegion Region;
  TimeVaryingMesh& Mesh;
  TimeVaryingReport& Report;
  vtkIdType NumberOfPoints;
  vtkIdType NumberOfCells;
  bool HasBoundary;
  CrossingLists Points;
  // The mesh id of each point of the slab.
  ExtractionBuffer<vtkIdType> Ids;
  std::vector<Chunk> Chunks;
};

template <typename Cells>
bool Extract(const ExtractionContext& context, const TimeStep& first, const TimeStep& second,
  Cells& cells, const CornerOrder& order, TimeVaryingMesh& mesh, TimeVaryingReport& report)
{
  SlabPass<Cells> pass(context, first, second, cells, order, mesh, report);
  return pass.Execute(pass.GetNumberOfParts());
}
}

bool TimeVaryingExtraction::Execute(const ExtractionContext& context, const TimeStep& first,
  const TimeStep& second, TimeVaryingMesh& mesh, TimeVaryingReport& report)
{
  if (const int* dimensions = first.GetDimensions())
  {
    if (*std::min_element(dimensions, dimensions + 3) < 2)
    {
      report.LowerDimensionalCells += first.GetNumberOfCells();
      return true;
    }
    TimeVaryingRows cells(first, second, *context.Values);
    // The corner ids of a structured cell are always in ascending order.
    const vtkNew<vtkPointData> noOrder;
    return Extract(context, first, second, cells, CornerOrder(noOrder), mesh, report);
  }
  if (first.GetNumberOfCells() == 0)
  {
    return true;
  }
  return VisitCellArrays(first.GetUnstructuredGrid(),
    [&](const auto* offsets, const auto* ids)
    {
      TimeVaryingUnstructured<std::decay_t<decltype(*ids)>> cells(
        first, second, *context.Values, offsets, ids);
      return Extract(context, first, second, cells, cells.GetOrder(), mesh, report);
    });
}

}
