// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeVaryingExtraction.h"

#include "Common/GridCells.h"
#include "Common/ThreadLocals.h"
#include "Cuts/ExtractionCell.h"
#include "Scalars/ExtractionScalars.h"
#include "TimeVarying/FacePlanarity.h"
#include "TimeVarying/FlatSides.h"
#include "TimeVarying/TimeVaryingBoundary.h"
#include "TimeVarying/TimeVaryingCells.h"
#include "TimeVarying/TimeVaryingCut.h"
#include "TimeVarying/TimeVaryingMesh.h"
#include "TimeVarying/TimeVaryingSlots.h"
#include "Unstructured/CrossingLists.h"

#include "vtkCellArray.h"
#include "vtkIsotableCache.h"
#include "vtkPointData.h"
#include "vtkTimeVaryingReport.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;
using Item = ExtractionValues::Item;
using Slot = vtkIsotableCache::Slot;
using Simplex = vtkIsotableCache::Simplex;

// Chunks are small, since cells that matter lie in clusters, and threads are to share them.
constexpr vtkIdType ChunkSize = 512;
constexpr int MaximumNumberOfVertices = vtkIsotableCache::MaximumNumberOfVertices;
constexpr int MaximumNumberOfSlots = vtkIsotableCache::MaximumNumberOfSlots;

// A case met in a chunk of cells.
struct Found
{
  vtkIdType Cell;
  const vtkIsotableCache::Case* Case;
  int Item;
  // Whether the table's own cut serves: corners in ascending order, no two slots one point.
  bool IsPlain;
};

struct Chunk
{
  std::vector<Found> Cases;
  std::vector<TimeVaryingMesh::BoundaryCell> Boundary;
  // The volume at the two steps of cells where slots were made one.
  std::vector<TimeVaryingMesh::BoundaryCell> StepVolume;
  // The 4-simplices above one face of a cell where slots were made one.
  std::vector<vtkIdType> Tied;
  vtkIdType Simplices = 0;
  bool HasDuplicates = false;
  vtkExtractionReport Report;
};

// A case as it is cut in a cell whose corners are not in ascending order, or of which two slots are
// one point.
struct Cut
{
  std::vector<Simplex> Simplices;
  // The boundary cells, where slots were made one; else they follow from the simplices.
  TimeVaryingCut Merged;
  bool IsMerged = false;
  // The slots in use, increasing.
  std::vector<Slot> Slots;

  const std::vector<Simplex>& GetSimplices() const
  {
    return this->IsMerged ? this->Merged.GetSimplices() : this->Simplices;
  }
};

// The access of one thread to the tables, and its room for cuts.
struct Workplace
{
  // These are shared pointers only since VTK copies what a thread begins with.
  std::array<std::shared_ptr<vtkIsotableCache::Reader>, vtkIsotable::NUMBER_OF_SHAPES> Tables;
  std::shared_ptr<FlatSides> Flats;
  Cut Own;

  const vtkIsotableCache::Case& GetCase(vtkIsotable::Shapes shape, std::uint32_t key)
  {
    auto& table = this->Tables[shape];
    if (!table)
    {
      table = std::make_shared<vtkIsotableCache::Reader>(vtkIsotableCache::Get(shape));
    }
    return table->GetCase(key);
  }

  FlatSides& GetFlats()
  {
    if (!this->Flats)
    {
      this->Flats = std::make_shared<FlatSides>();
    }
    return *this->Flats;
  }
};

template <typename Cells>
class Extractor
{
public:
  Extractor(const ExtractionContext& context, const TimeStep& first, const TimeStep& second,
    Cells& cells, const CornerOrder& order, TimeVaryingMesh& mesh, vtkTimeVaryingReport& report)
    : Context(context)
    , Values(*context.Values)
    , Steps{ &first, &second }
    , TheCells(cells)
    , Order(order)
    , Orientations{ CellOrientation(first.GetGrid()), CellOrientation(second.GetGrid()) }
    , Planarity(first, second)
    , Mesh(mesh)
    , Report(report)
    , NumberOfPoints(first.GetNumberOfPoints())
    , NumberOfCells(first.GetNumberOfCells())
    , HasBoundary(mesh.HasWantedKinds())
    , Points(2 * first.GetNumberOfPoints(), false)
  {
    for (int shape = 0; shape < vtkIsotable::NUMBER_OF_SHAPES; ++shape)
    {
      this->Slots.emplace_back(static_cast<vtkIsotable::Shapes>(shape));
    }
  }

  bool Execute()
  {
    const vtkIdType chunks = (this->NumberOfCells + ChunkSize - 1) / ChunkSize;
    this->Chunks.resize(chunks);
    const bool counted = this->TheCells.MakeMarks(this->Context) &&
      this->Context.Run(chunks, 0.2, 0.6,
        [this](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType chunk = first; chunk < last; ++chunk)
          {
            this->CountChunk(chunk);
          }
        });
    if (!counted)
    {
      return false;
    }
    const auto scalars = ExtractionScalars::MakePair(this->Steps[0]->GetScalars(),
      this->Steps[1]->GetScalars(), this->NumberOfPoints, this->Values);
    ExtractionBuffer<ExtractionPoint> points;
    this->Points.MakePoints(*scalars, points);
    this->Order.SortHalfway(points.GetData(), points.GetSize(), this->NumberOfPoints);
    this->Ids = this->Mesh.AddPoints(
      *this->Steps[0], *this->Steps[1], points, this->Points, this->Planarity.IsStatic());
    this->NoteReport(points.GetBytes());
    this->TheCells.FreeMarks();
    this->Allocate();
    if (!this->Context.Run(chunks, 0.6, 1.0,
          [this](vtkIdType first, vtkIdType last)
          {
            for (vtkIdType chunk = first; chunk < last; ++chunk)
            {
              this->WriteChunk(chunk);
            }
          }))
    {
      return false;
    }
    this->TakeBoundary();
    this->RemoveOppositeSimplices();
    return true;
  }

private:
  void ReadCodes(const TimeVaryingCell& cell, Code* codes) const
  {
    for (int v = 0; v < cell.NumberOfCorners; ++v)
    {
      codes[v] = this->Steps[0]->GetCodes()[cell.Ids[v]];
      codes[v + cell.NumberOfCorners] = this->Steps[1]->GetCodes()[cell.Ids[v]];
    }
  }

  // Returns whether two slots of a cell may be one point: by a value equal to an isovalue, or since
  // two corners are one point.
  static bool HasEqualPoints(const TimeVaryingCell& cell, const Code* codes, const Item& item)
  {
    Code ties = item.IsFlat;
    for (int v = 0; v < 2 * cell.NumberOfCorners; ++v)
    {
      ties |= codes[v];
    }
    return ExtractionValues::IsTie(ties) || HasEqualCorners(cell);
  }

  static bool HasEqualCorners(const TimeVaryingCell& cell)
  {
    return !cell.IsAscending && ExtractionCell::IsCollapsed(cell.Ids, cell.NumberOfCorners);
  }

  // Returns the point of a slot, as its owner and its key there.
  std::pair<vtkIdType, CrossingKey> GetPoint(
    const TimeVaryingCell& cell, const Item& item, Slot slot) const
  {
    const TimeVaryingSlots& slots = this->Slots[cell.Shape];
    const vtkIdType a = this->GetVertexId(cell, slots.GetEnd(slot, 0));
    if (slots.IsVertex(slot))
    {
      return { a, {} };
    }
    const vtkIdType b = this->GetVertexId(cell, slots.GetEnd(slot, 1));
    const bool isUpper = slots.GetSides(slot) & TimeVaryingSlots::UPPER;
    return { std::min(a, b), { std::max(a, b), isUpper ? item.Upper : item.Lower } };
  }

  vtkIdType GetVertexId(const TimeVaryingCell& cell, Slot vertex) const
  {
    return vertex < cell.NumberOfCorners
      ? cell.Ids[vertex]
      : cell.Ids[vertex - cell.NumberOfCorners] + this->NumberOfPoints;
  }

  void CountChunk(vtkIdType number)
  {
    Chunk& chunk = this->Chunks[number];
    Workplace& place = this->Workplaces.Local();
    CrossingLists::Arena& arena = this->Points.GetArena();
    const vtkIdType begin = number * ChunkSize;
    const vtkIdType end = std::min(begin + ChunkSize, this->NumberOfCells);
    std::vector<vtkIdType> near;
    this->TheCells.FindNear(begin, end, near, chunk.Report);
    chunk.Report.CellsVisited = end - begin;
    TimeVaryingCell cell;
    for (const vtkIdType id : near)
    {
      this->TheCells.Read(id, cell);
      this->CountCell(cell, chunk, place, arena);
    }
  }

  void CountCell(
    const TimeVaryingCell& cell, Chunk& chunk, Workplace& place, CrossingLists::Arena& arena)
  {
    Code codes[MaximumNumberOfVertices] = {};
    this->ReadCodes(cell, codes);
    const int vertices = 2 * cell.NumberOfCorners;
    const auto range = std::minmax_element(codes, codes + vertices);
    const vtkIdType before = chunk.Simplices;
    const auto& items = this->Values.GetItems();
    for (std::size_t number = 0; number < items.size(); ++number)
    {
      const Item& item = items[number];
      if (this->Values.IsOutside(item, *range.first, *range.second))
      {
        continue;
      }
      std::uint32_t key = 0;
      std::uint32_t power = 1;
      for (int v = 0; v < vertices; ++v, power *= 3)
      {
        key += power * item.GetDigit(codes[v]);
      }
      const vtkIsotableCache::Case& what = place.GetCase(cell.Shape, key);
      const bool isPlain = this->MakeCut(cell, codes, item, what, place);
      if (!isPlain && place.Own.IsMerged)
      {
        // In an order other than that of the table there may be more simplices.
        const std::size_t left = std::min(place.Own.GetSimplices().size(), what.Simplices.size());
        chunk.Report.CollapsedSimplices += static_cast<vtkIdType>(what.Simplices.size() - left);
      }
      for (const Slot slot : isPlain ? what.Slots : place.Own.Slots)
      {
        const auto point = this->GetPoint(cell, item, slot);
        this->Points.Enter(point.first, point.second, arena);
      }
      chunk.Simplices +=
        static_cast<vtkIdType>((isPlain ? what.Simplices : place.Own.GetSimplices()).size());
      chunk.Cases.push_back({ cell.Id, &what, static_cast<int>(number), isPlain });
    }
    const bool isDuplicate = this->TheCells.IsDuplicate(cell.Id);
    chunk.HasDuplicates |= isDuplicate;
    const bool hasOutput = chunk.Simplices != before && !isDuplicate;
    chunk.Report.CellsWithOutput += hasOutput;
    chunk.Report.FoldedCells += hasOutput &&
      std::any_of(this->Orientations, this->Orientations + 2,
        [&cell](const CellOrientation& one) { return one.IsFolded(cell.Shape, cell.Ids); });
  }

  // Finds which slots are the same point. Returns false where none are.
  bool Merge(const TimeVaryingCell& cell, const Code* codes, const Item& item,
    const vtkIsotableCache::Case& what, Slot* same) const
  {
    if (!HasEqualPoints(cell, codes, item))
    {
      return false;
    }
    std::iota(same, same + MaximumNumberOfSlots, Slot(0));
    ExtractionCell::IdentifyAll(
      vtkIsotableCache::Get(cell.Shape), item, codes, what.Slots, HasEqualCorners(cell),
      [&](Slot slot) { return this->GetPoint(cell, item, slot); }, same);
    return std::any_of(
      what.Slots.begin(), what.Slots.end(), [same](Slot slot) { return same[slot] != slot; });
  }

  // Cuts a case in the global order, with slots that are the same point made one, where the table's
  // own cut does not serve; returns whether it does.
  bool MakeCut(const TimeVaryingCell& cell, const Code* codes, const Item& item,
    const vtkIsotableCache::Case& what, Workplace& place) const
  {
    Cut& cut = place.Own;
    Slot same[MaximumNumberOfSlots];
    cut.IsMerged = this->Merge(cell, codes, item, what, same);
    if (!cut.IsMerged && cell.IsAscending)
    {
      return true;
    }
    const vtkIsotableCache& table = vtkIsotableCache::Get(cell.Shape);
    // The corners at the first step come before those at the second.
    constexpr int most = MaximumNumberOfVertices / 2;
    const int corners = std::min(cell.NumberOfCorners, most);
    Slot vertexRanks[MaximumNumberOfVertices];
    this->Order.Rank(cell.Ids, corners, vertexRanks);
    for (int v = 0; v < corners; ++v)
    {
      vertexRanks[v + corners] = static_cast<Slot>(vertexRanks[v] + corners);
    }
    const vtkIsotableCache::RankArray ranks = table.GetSlotRanks(vertexRanks);
    if (cut.IsMerged)
    {
      // The case of a cell that is inside throughout has the digit 1 everywhere.
      std::uint32_t inside = 0;
      for (int v = 0; v < 2 * corners; ++v)
      {
        inside = 3 * inside + 1;
      }
      cut.Merged.Make(table, this->Slots[cell.Shape], item, codes, what,
        item.IsFlat ? place.GetCase(cell.Shape, inside) : what, ranks, same,
        this->HasBoundary || this->Mesh.GetOptions().Settings.GenerateSimplices);
    }
    else
    {
      cut.Simplices.clear();
      table.Cut(what, ranks, [&cut](const Simplex& simplex) { cut.Simplices.push_back(simplex); });
    }
    this->FindSlots(cut);
    return false;
  }

  void FindSlots(Cut& cut) const
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
        std::for_each_n(side.Points.begin(), this->Mesh.IsWantedOfTied(side.Kind) ? side.Number : 0,
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

  // Turns the counts of chunks into the places where they begin, and makes room for all.
  void Allocate()
  {
    vtkIdType simplices = 0;
    for (Chunk& chunk : this->Chunks)
    {
      std::swap(chunk.Simplices, simplices);
      simplices += chunk.Simplices;
      this->Report.Add(chunk.Report);
    }
    const TimeVaryingOptions& options = this->Mesh.GetOptions();
    TimeVaryingMesh::Slab& slab = this->Mesh.GetSlab();
    // With values equal to bounds those of the boundary are told by the 4-simplices.
    const bool isNeeded = options.Settings.GenerateTetrahedra ||
      options.Settings.GenerateSimplices ||
      (this->HasBoundary && (this->Steps[0]->HasTies() || this->Steps[1]->HasTies()));
    slab.Simplices.Allocate(isNeeded ? simplices : 0);
    slab.Items.Allocate(isNeeded && this->Values.GetItems().size() > 1 ? simplices : 0);
    slab.Flats.Allocate(options.Settings.GenerateTetrahedra ? simplices : 0);
    slab.Ties.Allocate(options.Settings.GenerateSimplices ? simplices : 0);
    const bool hasDuplicates = std::any_of(this->Chunks.begin(), this->Chunks.end(),
      [](const Chunk& chunk) { return chunk.HasDuplicates; });
    slab.Duplicates.Allocate(isNeeded && hasDuplicates ? simplices : 0);
    this->Report.Simplices += simplices;
    this->MarksFlat =
      options.Settings.GenerateTetrahedra && options.IsAlongTime() && this->Planarity.IsStatic();
  }

  void NoteReport(std::size_t bytes)
  {
    for (Workplace& place : this->Workplaces)
    {
      for (const auto& table : place.Tables)
      {
        this->Report.TableLookups += table ? table->GetNumberOfLookups() : 0;
        this->Report.TableCasesMade += table ? table->GetNumberOfCasesMade() : 0;
      }
    }
    bytes += this->TheCells.GetMarkBytes() + this->Points.GetBytes() + this->Ids.GetBytes() +
      this->Mesh.GetBytes() + this->Steps[0]->GetBytes() + this->Steps[1]->GetBytes();
    for (const Chunk& chunk : this->Chunks)
    {
      bytes += chunk.Cases.capacity() * sizeof(Found);
    }
    this->Context.NoteWorkingBytes(bytes);
  }

  void WriteChunk(vtkIdType number)
  {
    Chunk& chunk = this->Chunks[number];
    Workplace& place = this->Workplaces.Local();
    vtkIdType next = chunk.Simplices;
    TimeVaryingCell cell;
    for (const Found& found : chunk.Cases)
    {
      if (found.Cell != cell.Id)
      {
        this->TheCells.Read(found.Cell, cell);
      }
      const Item& item = this->Values.GetItems()[found.Item];
      if (!found.IsPlain)
      {
        Code codes[MaximumNumberOfVertices] = {};
        this->ReadCodes(cell, codes);
        this->MakeCut(cell, codes, item, *found.Case, place);
      }
      vtkIdType ids[MaximumNumberOfSlots];
      for (const Slot slot : found.IsPlain ? found.Case->Slots : place.Own.Slots)
      {
        const auto point = this->GetPoint(cell, item, slot);
        ids[slot] = this->Ids[this->Points.GetId(point.first, point.second)];
      }
      const bool isInverted = this->IsInverted(cell);
      const auto& simplices = found.IsPlain ? found.Case->Simplices : place.Own.GetSimplices();
      const bool isMerged = !found.IsPlain && place.Own.IsMerged;
      this->WriteSimplices(cell, found, place, ids, isInverted, next);
      for (std::size_t s = 0; isMerged && s < simplices.size(); ++s)
      {
        if (this->Slots[cell.Shape].IsAboveFace(simplices[s]))
        {
          chunk.Tied.push_back(next + static_cast<vtkIdType>(s));
        }
      }
      next += static_cast<vtkIdType>(simplices.size());
      if (this->HasBoundary || (isMerged && this->Mesh.GetOptions().Settings.GenerateSimplices))
      {
        this->WriteBoundary(cell, found, place.Own, ids, isInverted, chunk);
      }
    }
  }

  bool IsInverted(const TimeVaryingCell& cell) const
  {
    const int sign = this->Orientations[0].GetSign(cell.Shape, cell.Ids);
    return (sign != 0 ? sign : this->Orientations[1].GetSign(cell.Shape, cell.Ids)) < 0;
  }

  void WriteSimplices(const TimeVaryingCell& cell, const Found& found, Workplace& place,
    const vtkIdType* ids, bool isInverted, vtkIdType next)
  {
    TimeVaryingMesh::Slab& slab = this->Mesh.GetSlab();
    const auto& simplices = found.IsPlain ? found.Case->Simplices : place.Own.GetSimplices();
    const std::size_t number = slab.Simplices.GetSize() > 0 ? simplices.size() : 0;
    // The first two points change places in a left-handed cell.
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
    note(slab.Ties, static_cast<std::uint8_t>(!found.IsPlain && place.Own.IsMerged));
    note(slab.Duplicates, static_cast<std::uint8_t>(this->TheCells.IsDuplicate(cell.Id)));
    if (!this->MarksFlat)
    {
      note(slab.Flats, std::uint8_t(0));
      return;
    }
    const TimeVaryingSlots& meaning = this->Slots[cell.Shape];
    const unsigned planar = this->Planarity.GetPlanar(cell, meaning);
    const std::uint8_t* const known =
      found.IsPlain ? place.GetFlats().Find(*found.Case, meaning, planar).data() : nullptr;
    for (std::size_t s = 0; s < number; ++s)
    {
      const std::uint8_t flat = known ? known[s] : meaning.FindFlat(simplices[s], planar);
      slab.Flats[next + s] = isInverted ? FlatSides::Turn(flat) : flat;
    }
  }

  void WriteBoundary(const TimeVaryingCell& cell, const Found& found, const Cut& cut,
    const vtkIdType* ids, bool isInverted, Chunk& chunk) const
  {
    const bool isMerged = !found.IsPlain && cut.IsMerged;
    const bool isDuplicate = this->TheCells.IsDuplicate(cell.Id);
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
        if (!this->Mesh.IsWantedOfTied(side.Kind))
        {
          continue;
        }
        const auto made = make(side.Kind, side.Points.data(), side.Number);
        if (this->Mesh.IsWanted(side.Kind))
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
    { chunk.Boundary.push_back(make(kind, slots, number)); };
    for (const Simplex& simplex : found.IsPlain ? found.Case->Simplices : cut.Simplices)
    {
      TimeVaryingBoundary::ForEach(this->Slots[cell.Shape], simplex, this->Mesh, add);
    }
  }

  // Gives the mesh the boundary cells of all chunks in their order.
  void TakeBoundary()
  {
    for (const Chunk& chunk : this->Chunks)
    {
      this->Mesh.AddBoundary(chunk.Boundary);
      this->Mesh.AddStepVolume(chunk.StepVolume);
    }
  }

  // A neighbour may have the same 4-simplex above the common face, turned over.
  void RemoveOppositeSimplices()
  {
    std::vector<vtkIdType> tied;
    for (const Chunk& chunk : this->Chunks)
    {
      tied.insert(tied.end(), chunk.Tied.begin(), chunk.Tied.end());
    }
    if (!tied.empty() && this->Mesh.GetSlab().Simplices.GetSize() > 0)
    {
      this->Report.Simplices -= this->Mesh.RemoveOppositeSimplices(tied);
    }
  }

  const ExtractionContext& Context;
  const ExtractionValues& Values;
  const TimeStep* Steps[2];
  Cells& TheCells;
  const CornerOrder& Order;
  CellOrientation Orientations[2];
  FacePlanarity Planarity;
  TimeVaryingMesh& Mesh;
  vtkTimeVaryingReport& Report;
  vtkIdType NumberOfPoints;
  vtkIdType NumberOfCells;
  bool HasBoundary;
  bool MarksFlat = false;
  std::vector<TimeVaryingSlots> Slots;
  CrossingLists Points;
  // The id in the mesh of each point of the slab.
  ExtractionBuffer<vtkIdType> Ids;
  std::vector<Chunk> Chunks;
  ThreadLocals<Workplace> Workplaces;
};

template <typename Array>
bool ExtractUnstructured(const ExtractionContext& context, const TimeStep& first,
  const TimeStep& second, TimeVaryingMesh& mesh, vtkTimeVaryingReport& report)
{
  vtkCellArray* stored = first.GetUnstructuredGrid()->GetCells();
  const auto offsets = ArrayViews::Get<Array>(stored->GetOffsetsArray());
  const auto ids = ArrayViews::Get<Array>(stored->GetConnectivityArray());
  TimeVaryingUnstructured<typename Array::ValueType> cells(
    first, second, *context.Values, offsets->GetPointer(0), ids->GetPointer(0));
  return Extractor<std::decay_t<decltype(cells)>>(
    context, first, second, cells, cells.GetOrder(), mesh, report)
    .Execute();
}
}

bool TimeVaryingExtraction::Execute(const ExtractionContext& context, const TimeStep& first,
  const TimeStep& second, TimeVaryingMesh& mesh, vtkTimeVaryingReport& report)
{
  if (const int* dimensions = first.GetDimensions())
  {
    if (*std::min_element(dimensions, dimensions + 3) < 2)
    {
      report.LowerDimensionalCells += first.GetNumberOfCells();
      return true;
    }
    TimeVaryingRows cells(first, second, *context.Values);
    // The corners of rows ascend in the order of their ids.
    const vtkNew<vtkPointData> noOrder;
    return Extractor<TimeVaryingRows>(
      context, first, second, cells, CornerOrder(noOrder), mesh, report)
      .Execute();
  }
  if (first.GetNumberOfCells() == 0)
  {
    return true;
  }
  return GridCells::IsNarrow(first.GetUnstructuredGrid()->GetCells()->GetConnectivityArray())
    ? ExtractUnstructured<GridCells::NarrowIds>(context, first, second, mesh, report)
    : ExtractUnstructured<GridCells::WideIds>(context, first, second, mesh, report);
}

}
