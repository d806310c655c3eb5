// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SimplexSlicer.h"

#include "Common/GridCells.h"
#include "Grid/CornerOrder.h"
#include "Pass/ExtractionStages.h"
#include "Scalars/ExtractionScalars.h"
#include "TimeVarying/SimplexSliceTable.h"
#include "TimeVarying/SliceChunk.h"
#include "TimeVarying/SliceFaces.h"
#include "TimeVarying/SlicedSimplex.h"
#include "TimeVarying/SortedSimplices.h"
#include "Unstructured/CrossingLists.h"
#include "Unstructured/UnstructuredCells.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkPointData.h"
#include "vtkTimeVaryingSettings.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;
using Intersection = SliceIntersection;
using Slot = vtkIsotable::Slot;
using Case = SimplexSliceTable::Slice;
using Parts = vtkTimeVaryingSettings::PartsAtStep;

constexpr int SimplexSize = SlicedSimplex::Size;
constexpr Code AtValue = SlicedSimplex::AtValue;
constexpr Code AboveValue = SlicedSimplex::AboveValue;
constexpr Code NonFinite = AboveValue + 1;

// Result of counting a chunk of cells, used for writing the chunk.
struct Chunk : SliceFaces::Chunk
{
  // Index of the chunk's first tetrahedron in the slice.
  vtkIdType First = 0;
  vtkIdType InvalidCell = -1;
  vtkIdType NonFiniteCells = 0;
};

bool IsCollapsed(const vtkIsotable::Simplex& tetrahedron, const SlicePoint* points)
{
  for (int a = 0; a < 4; ++a)
  {
    for (int b = a + 1; b < 4; ++b)
    {
      if (points[tetrahedron[a]] == points[tetrahedron[b]])
      {
        return true;
      }
    }
  }
  return false;
}

// Adds a tetrahedron of a cell. \a indices holds the index of each slot's point in the chunk.
template <typename Id>
void AddTetrahedron(const vtkIsotable::Simplex& slots, const std::uint16_t* indices,
  bool isInverted, std::uint16_t cell, SliceChunkBuilder<Id>& builder)
{
  const int first = isInverted ? 1 : 0;
  builder.Add({ { { indices[slots[first]], indices[slots[1 - first]], indices[slots[2]],
                  indices[slots[3]] } },
    cell });
}

// Classifies the intersection of 4-simplices with the slice value, using the cell arrays of
// vtkTimeVaryingIntervalVolume.
class SimplexIntersections
{
public:
  SimplexIntersections(vtkCellData* cells, bool isAtTime)
    : Intervals(cells->GetArray("IntervalId"))
    , AtStep(isAtTime ? cells->GetArray("AtStep") : nullptr)
  {
  }

  Intersection Intersect(vtkIdType cell, const Code* codes) const
  {
    Code minimum = AboveValue;
    Code maximum = 0;
    int numberAt = 0;
    for (int v = 0; v < SimplexSize; ++v)
    {
      minimum = std::min(minimum, codes[v]);
      maximum = std::max(maximum, codes[v]);
      numberAt += codes[v] == AtValue;
    }
    if (maximum < AtValue)
    {
      return Intersection::None;
    }
    if (numberAt == SimplexSize)
    {
      return this->GetPart(cell) == Parts::TETRAHEDRON_AT_STEP ? Intersection::InSlice
                                                               : Intersection::None;
    }
    if (numberAt == SimplexSize - 1)
    {
      const Intersection intersection =
        minimum < AtValue ? Intersection::Ends : Intersection::Begins;
      return this->GetPart(cell) == Parts::FACES_AT_STEP ? intersection : Intersection::None;
    }
    return minimum < AtValue ? Intersection::Crosses : Intersection::None;
  }

  // Returns the interval id of a cell. Intervals may overlap, and each has a separate slice.
  vtkIdType GetInterval(vtkIdType cell) const
  {
    return this->Intervals ? static_cast<vtkIdType>(this->Intervals->GetComponent(cell, 0)) : 0;
  }

private:
  int GetPart(vtkIdType cell) const
  {
    return this->AtStep ? static_cast<int>(this->AtStep->GetComponent(cell, 0))
                        : Parts::FACES_AT_STEP;
  }

  // The interval id of each cell, or null if the cells have no intervals.
  vtkDataArray* Intervals;
  // The PartsAtStep of each cell, or null if all are FACES_AT_STEP.
  vtkDataArray* AtStep;
};

// Stored is the value type of the cell array.
template <typename Stored>
class SlicePass : public ExtractionStages<SlicePass<Stored>, SliceChunkBuilder<Stored>>
{
  using Builder = SliceChunkBuilder<Stored>;
  using Frame = ExtractionStages<SlicePass<Stored>, Builder>;

public:
  static constexpr std::array<double, 4> Progress = { { 0.05, 0.4, 0.5, 0.8 } };

  SlicePass(const ExtractionContext& context, vtkUnstructuredGrid* grid, const Stored* offsets,
    const Stored* ids, const SimplexSlicer::Options& options, SimplexSlicer::Slice& slice)
    : Frame(context)
    , Grid(grid)
    , Types(GridCells::GetTypes(grid))
    , Offsets(offsets)
    , Ids(ids)
    , Scalars(context.MakeScalars())
    , Order(grid->GetPointData())
    , Intersections(grid->GetCellData(), options.IsAtTime)
    , Lists(grid->GetNumberOfPoints(), true)
    , Chunks((grid->GetNumberOfCells() + SliceChunk::Size - 1) / SliceChunk::Size)
    , IsMirrored(options.IsMirrored)
    , Slice(slice)
  {
  }

  vtkIdType GetNumberOfParts() const { return static_cast<vtkIdType>(this->Chunks.size()); }

  bool Classify()
  {
    const vtkIdType points = this->Grid->GetNumberOfPoints();
    this->Codes.Allocate(points);
    return this->Context.Run(points, 0.0, 0.05,
      [this](vtkIdType first, vtkIdType last)
      { this->Scalars->Classify(first, last - first, this->Codes.GetData() + first); });
  }

  void CountPart(vtkIdType number, Builder& builder)
  {
    const vtkIdType begin = number * SliceChunk::Size;
    const vtkIdType end = std::min(begin + SliceChunk::Size, this->Grid->GetNumberOfCells());
    Work work{ this->Chunks[number], builder, this->Lists.GetArena(), begin, {}, {} };
    const bool isById = this->Order.IsById();
    const unsigned char* const types = this->Types->GetPointer(0);
    work.Points.Begin();
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      const Stored* const ids = this->Ids + this->Offsets[cell];
      if (types[cell] != VTK_POLY_VERTEX ||
        this->Offsets[cell + 1] - this->Offsets[cell] != SimplexSize)
      {
        work.Made.InvalidCell = cell;
        return;
      }
      // Number of vertices with each code, four bits per code.
      unsigned int counts = 0;
      bool areAbove[SimplexSize];
      for (int v = 0; v < SimplexSize; ++v)
      {
        const Code code = this->Codes[ids[v]];
        counts += 1u << (4 * code);
        areAbove[v] = code >= AboveValue;
      }
      constexpr unsigned int below = 0xf;
      constexpr unsigned int above = 0xf << (4 * AboveValue);
      const bool isPlain = (counts & ~(below | above)) == 0;
      if (isPlain && ((counts & below) == 0 || (counts & above) == 0))
      {
        continue;
      }
      if (this->Context.HasBlanking() && this->IsBlanked(cell, ids))
      {
        continue;
      }
      if ((counts >> (4 * NonFinite)) != 0)
      {
        ++work.Made.NonFiniteCells;
        continue;
      }
      if (!isPlain || !isById)
      {
        this->CountPlain(work);
        this->CountTied(cell, work);
        continue;
      }
      work.Positions[work.Plain.Number] = static_cast<std::uint16_t>(cell - begin);
      work.Plain.Add(ids, areAbove);
      if (work.Plain.Number == Batch::Size)
      {
        this->CountPlain(work);
      }
    }
    this->CountPlain(work);
    work.Points.Finish(work.Made);
  }

  bool Settle()
  {
    if (this->FindInvalidCell())
    {
      // If a cell is invalid, there is no slice.
      std::fill(this->Chunks.begin(), this->Chunks.end(), Chunk());
      return true;
    }
    this->Codes.Free();
    SliceFaces faces;
    for (const Chunk& chunk : this->Chunks)
    {
      this->Slice.NonFiniteCells += chunk.NonFiniteCells;
      faces.Add(chunk);
    }
    faces.Sort();
    if (faces.HasDuplicates() &&
      !this->ForEachPart(this->GetNumberOfParts(), Progress[1], Progress[2],
        [&](vtkIdType chunk, Builder&) { faces.RemoveDuplicates(this->Chunks[chunk]); }))
    {
      return false;
    }
    this->Lists.MakePoints(*this->Scalars, this->Slice.Points);
    return true;
  }

  // Computes the start positions of the chunks and allocates the slice.
  void Allocate()
  {
    vtkIdType tetrahedra = 0;
    for (Chunk& chunk : this->Chunks)
    {
      chunk.First = tetrahedra;
      tetrahedra += static_cast<vtkIdType>(chunk.Tetrahedra.size());
    }
    this->Slice.Tetrahedra.Allocate(
      tetrahedra, 4, static_cast<vtkIdType>(this->Slice.Points.GetSize()));
    this->Slice.CellIds.Allocate(this->Context.KeepCellIds ? tetrahedra : 0);
  }

  void WritePart(vtkIdType number, Builder&)
  {
    const Chunk& chunk = this->Chunks[number];
    const auto write = [&chunk](auto* values)
    {
      using Value = std::decay_t<decltype(*values)>;
      std::vector<Value> ids(chunk.Nodes.size());
      std::transform(chunk.Nodes.begin(), chunk.Nodes.end(), ids.begin(),
        [](const CrossingLists::Node* node) { return static_cast<Value>(node->Id); });
      Value* next = values + 4 * chunk.First;
      for (const SliceChunk::Tetrahedron& tetrahedron : chunk.Tetrahedra)
      {
        for (const std::uint16_t point : tetrahedron.Points)
        {
          *next++ = ids[point];
        }
      }
    };
    this->Slice.Tetrahedra.Visit(write);
    if (this->Context.KeepCellIds)
    {
      std::transform(chunk.Tetrahedra.begin(), chunk.Tetrahedra.end(),
        this->Slice.CellIds.GetData() + chunk.First,
        [begin = number * SliceChunk::Size](const SliceChunk::Tetrahedron& tetrahedron)
        { return begin + tetrahedron.Cell; });
    }
  }

  void Finish() {}

private:
  // A vertex id and one more bit fit in this type.
  using Key = std::conditional_t<sizeof(Stored) == 4, std::uint32_t, std::int64_t>;
  using Batch = SortedSimplices<Key>;

  // State of a thread while it fills a chunk.
  struct Work
  {
    Chunk& Made;
    Builder& Points;
    CrossingLists::Arena& Arena;
    const vtkIdType Begin;
    // Cells with no vertex at the slice value are counted in batches. The batch is flushed before
    // any other cell is counted, to preserve the order of the cells.
    Batch Plain;
    std::array<std::uint16_t, Batch::Size> Positions;
  };

  bool IsFlipped(bool isOdd) const { return isOdd != this->IsMirrored; }

  bool IsBlanked(vtkIdType cell, const Stored* ids) const
  {
    return this->Context.IsCellBlanked(cell) ||
      std::any_of(ids, ids + SimplexSize,
        [this](Stored point) { return this->Context.IsPointBlanked(point); });
  }

  // Counts the batched cells. All points of their slices are distinct, unless a cell contains a
  // vertex twice.
  void CountPlain(Work& work)
  {
    Batch& batch = work.Plain;
    SimplexSorting::Sort(batch);
    for (int s = 0; s < batch.Number; ++s)
    {
      const std::uint16_t position = work.Positions[s];
      if (batch.HasEqual[s] != 0)
      {
        this->CountTied(work.Begin + position, work);
        continue;
      }
      const Case& what = this->Cases[batch.Above[s]];
      std::uint16_t indices[6];
      for (int slot = 0; slot < what.NumberOfSlots; ++slot)
      {
        const auto& [near, far] = what.Edges[slot];
        indices[slot] = work.Points.Find(
          batch.GetId(near, s), CrossingKey(batch.GetId(far, s), 0), this->Lists, work.Arena);
      }
      for (int t = 0; t < what.NumberOfTetrahedra; ++t)
      {
        AddTetrahedron(
          what.Tetrahedra[t], indices, this->IsFlipped(batch.IsOdd[s] != 0), position, work.Points);
      }
    }
    batch.Number = 0;
  }

  // Counts a cell in which slots may be the same point.
  void CountTied(vtkIdType cell, Work& work)
  {
    const Stored* const ids = this->Ids + this->Offsets[cell];
    Code codes[SimplexSize];
    std::transform(ids, ids + SimplexSize, codes, [this](Stored id) { return this->Codes[id]; });
    const Intersection intersection = this->Intersections.Intersect(cell, codes);
    if (intersection == Intersection::None)
    {
      return;
    }
    SlicedSimplex simplex;
    simplex.Sort(ids, codes, this->Order, intersection);
    // If the 4-simplex begins at the value, its slice is the limit of the slices just above the
    // value.
    const Code first = intersection == Intersection::Begins || intersection == Intersection::InSlice
      ? AboveValue
      : AtValue;
    const Case& what = this->Cases[simplex.FindVerticesAtLeast(first)];
    SlicePoint points[6];
    for (int slot = 0; slot < what.NumberOfSlots; ++slot)
    {
      points[slot] = simplex.FindPoint(what.Edges[slot]);
    }
    for (int t = 0; t < what.NumberOfTetrahedra; ++t)
    {
      const vtkIsotable::Simplex& slots = what.Tetrahedra[t];
      if (IsCollapsed(slots, points))
      {
        continue;
      }
      std::uint16_t indices[6];
      for (const Slot slot : slots)
      {
        indices[slot] =
          work.Points.Find(points[slot].Owner, points[slot].Key, this->Lists, work.Arena);
      }
      if (intersection != Intersection::Crosses)
      {
        // All four points are vertices.
        work.Made.FaceTetrahedra.push_back(work.Points.GetNumberOfTetrahedra());
        work.Made.Faces.push_back(
          { { { points[0].Owner, points[1].Owner, points[2].Owner, points[3].Owner } },
            this->Intersections.GetInterval(cell), intersection });
      }
      AddTetrahedron(slots, indices, this->IsFlipped(simplex.IsInverted()),
        static_cast<std::uint16_t>(cell - work.Begin), work.Points);
    }
  }

  bool FindInvalidCell()
  {
    const auto invalid = std::find_if(this->Chunks.begin(), this->Chunks.end(),
      [](const Chunk& chunk) { return chunk.InvalidCell >= 0; });
    this->Slice.InvalidCell = invalid == this->Chunks.end() ? -1 : invalid->InvalidCell;
    return this->Slice.InvalidCell >= 0;
  }

  vtkUnstructuredGrid* Grid;
  vtkSmartPointer<GridCells::Types> Types;
  const Stored* Offsets;
  const Stored* Ids;
  std::unique_ptr<ExtractionScalars> Scalars;
  CornerOrder Order;
  SimplexIntersections Intersections;
  ExtractionBuffer<Code> Codes;
  CrossingLists Lists;
  const std::array<Case, 32>& Cases = SimplexSliceTable::GetAll();
  std::vector<Chunk> Chunks;
  const bool IsMirrored;
  SimplexSlicer::Slice& Slice;
};
}

bool SimplexSlicer::Execute(
  const ExtractionContext& context, vtkUnstructuredGrid* grid, const Options& options, Slice& slice)
{
  if (grid->GetNumberOfCells() == 0)
  {
    // A grid without cells may have no cell array.
    return true;
  }
  return VisitCellArrays(grid,
    [&](const auto* offsets, const auto* ids)
    {
      SlicePass<std::decay_t<decltype(*ids)>> pass(context, grid, offsets, ids, options, slice);
      return pass.Execute(pass.GetNumberOfParts());
    });
}

}
