// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SimplexSlicer.h"

#include "Common/GridCells.h"
#include "Grid/CornerOrder.h"
#include "Scalars/ExtractionScalars.h"
#include "Static/CrossingLists.h"
#include "TimeVarying/SimplexSliceTable.h"
#include "TimeVarying/SliceChunk.h"
#include "TimeVarying/SliceFaces.h"
#include "TimeVarying/SlicedSimplex.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkTimeVaryingSettings.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;
using Meeting = SliceMeeting;
using Slot = vtkIsotable::Slot;
using Case = SimplexSliceTable::Slice;
using Parts = vtkTimeVaryingSettings::PartsAtStep;

constexpr int SimplexSize = SlicedSimplex::Size;
constexpr Code AtValue = SlicedSimplex::AtValue;
constexpr Code AboveValue = SlicedSimplex::AboveValue;

// The result of the counting pass for a chunk of cells, which the writing pass uses.
struct Chunk : SliceFaces::Chunk
{
  // The place of the first tetrahedron in the slice.
  vtkIdType First = 0;
  vtkIdType WrongCell = -1;
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

// Adds a tetrahedron of a cell; \a places has the place of each slot's point.
void AddTetrahedron(const vtkIsotable::Simplex& slots, const std::uint16_t* places, bool isInverted,
  std::uint16_t cell, SliceChunkBuilder& builder)
{
  const int first = isInverted ? 1 : 0;
  builder.Add(
    { { { places[slots[first]], places[slots[1 - first]], places[slots[2]], places[slots[3]] } },
      cell });
}

class Slicer
{
public:
  Slicer(const ExtractionContext& context, vtkUnstructuredGrid* grid, SimplexSlicer::Slice& slice)
    : Context(context)
    , Grid(grid)
    , Scalars(ExtractionScalars::Make(context.Scalars, *context.Values))
    , Order(grid->GetPointData())
    , Intervals(grid->GetCellData()->GetArray("IntervalId"))
    , AtStep(grid->GetCellData()->GetArray("AtStep"))
    , Lists(grid->GetNumberOfPoints(), true)
    , Slice(slice)
  {
  }

  bool Execute()
  {
    vtkCellArray* stored = this->Grid->GetCells();
    if (this->Grid->GetNumberOfCells() == 0)
    {
      // A grid that was given none has no cell array.
      return true;
    }
    return GridCells::IsNarrow(stored->GetConnectivityArray())
      ? this->Execute<GridCells::NarrowIds>(stored)
      : this->Execute<GridCells::WideIds>(stored);
  }

private:
  // The cells as they are stored.
  template <typename Id>
  struct Cells
  {
    const unsigned char* Types;
    const Id* Offsets;
    const Id* Ids;
  };

  template <typename Array>
  bool Execute(vtkCellArray* stored)
  {
    const auto types = GridCells::GetTypes(this->Grid);
    const auto offsets = ArrayViews::Get<Array>(stored->GetOffsetsArray());
    const auto ids = ArrayViews::Get<Array>(stored->GetConnectivityArray());
    const Cells<typename Array::ValueType> all{ types->GetPointer(0), offsets->GetPointer(0),
      ids->GetPointer(0) };
    const vtkIdType points = this->Grid->GetNumberOfPoints();
    const vtkIdType cells = this->Grid->GetNumberOfCells();
    const vtkIdType chunks = (cells + SliceChunk::Size - 1) / SliceChunk::Size;
    this->Codes.Allocate(points);
    this->Chunks.resize(chunks);
    const auto forEachChunk = [this, chunks](double from, double to, auto&& work)
    {
      return this->Context.Run(chunks, from, to,
        [&work](vtkIdType first, vtkIdType last)
        {
          for (vtkIdType chunk = first; chunk < last; ++chunk)
          {
            work(chunk);
          }
        });
    };
    if (!this->Context.Run(points, 0.0, 0.05,
          [this](vtkIdType first, vtkIdType last)
          { this->Scalars->Classify(first, last - first, this->Codes.GetData() + first); }) ||
      !forEachChunk(0.05, 0.4, [&](vtkIdType chunk) { this->CountChunk(chunk, all); }))
    {
      return false;
    }
    if (this->FindWrongCell())
    {
      return true;
    }
    this->Codes.Free();
    SliceFaces faces;
    for (const Chunk& chunk : this->Chunks)
    {
      faces.Add(chunk);
    }
    faces.Sort();
    if (faces.HasGiven() &&
      !forEachChunk(0.4, 0.5, [&](vtkIdType chunk) { faces.LeaveOutGiven(this->Chunks[chunk]); }))
    {
      return false;
    }
    this->Lists.MakePoints(*this->Scalars, this->Slice.Points);
    this->Allocate();
    return forEachChunk(0.5, 0.8, [this](vtkIdType chunk) { this->WriteChunk(chunk); });
  }

  template <typename Id>
  void CountChunk(vtkIdType number, const Cells<Id>& cells)
  {
    Chunk& chunk = this->Chunks[number];
    SliceChunkBuilder& builder = this->Builders.Local();
    CrossingLists::Arena& arena = this->Lists.GetArena();
    const vtkIdType begin = number * SliceChunk::Size;
    const vtkIdType end = std::min(begin + SliceChunk::Size, this->Grid->GetNumberOfCells());
    builder.Begin();
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      const Id* const ids = cells.Ids + cells.Offsets[cell];
      if (cells.Types[cell] != VTK_POLY_VERTEX ||
        cells.Offsets[cell + 1] - cells.Offsets[cell] != SimplexSize)
      {
        chunk.WrongCell = cell;
        return;
      }
      Code codes[SimplexSize];
      std::transform(ids, ids + SimplexSize, codes, [this](Id id) { return this->Codes[id]; });
      bool hasTies = false;
      const Meeting meeting = this->Meet(cell, codes, hasTies);
      if (meeting == Meeting::None || (this->Context.HasBlanking() && this->IsBlanked(cell, ids)))
      {
        continue;
      }
      const std::uint16_t position = static_cast<std::uint16_t>(cell - begin);
      SlicedSimplex simplex;
      if (hasTies || !this->Order.IsById() || !simplex.SortById(ids, codes))
      {
        simplex.Sort(ids, codes, this->Order, meeting);
        this->CountTied(position, simplex, meeting, this->GetInterval(cell), chunk, builder, arena);
      }
      else
      {
        this->CountPlain(position, simplex, builder, arena);
      }
    }
    static_cast<SliceChunk&>(chunk) = builder.Finish();
  }

  template <typename Id>
  bool IsBlanked(vtkIdType cell, const Id* ids) const
  {
    return this->Context.IsCellBlanked(cell) ||
      std::any_of(
        ids, ids + SimplexSize, [this](Id point) { return this->Context.IsPointBlanked(point); });
  }

  Meeting Meet(vtkIdType cell, const Code* codes, bool& hasTies) const
  {
    Code least = AboveValue;
    Code greatest = 0;
    int numberAt = 0;
    for (int v = 0; v < SimplexSize; ++v)
    {
      least = std::min(least, codes[v]);
      greatest = std::max(greatest, codes[v]);
      numberAt += codes[v] == AtValue;
    }
    if (greatest < AtValue || greatest == this->Context.Values->GetNonFiniteCode())
    {
      return Meeting::None;
    }
    hasTies = numberAt > 0;
    if (numberAt == SimplexSize)
    {
      return this->GetPart(cell) == Parts::TETRAHEDRON_AT_STEP ? Meeting::Lies : Meeting::None;
    }
    if (numberAt == SimplexSize - 1)
    {
      const Meeting meeting = least < AtValue ? Meeting::Ends : Meeting::Begins;
      return this->GetPart(cell) == Parts::FACES_AT_STEP ? meeting : Meeting::None;
    }
    return least < AtValue ? Meeting::Crosses : Meeting::None;
  }

  int GetPart(vtkIdType cell) const
  {
    return this->AtStep ? static_cast<int>(this->AtStep->GetComponent(cell, 0))
                        : Parts::FACES_AT_STEP;
  }

  // Returns the interval that a cell belongs to: intervals may overlap, and each has its own slice.
  vtkIdType GetInterval(vtkIdType cell) const
  {
    return this->Intervals ? static_cast<vtkIdType>(this->Intervals->GetComponent(cell, 0)) : 0;
  }

  // Counts a 4-simplex of five vertices in ascending order of their ids, none at the value: no two
  // points of its slice are one.
  void CountPlain(std::uint16_t position, const SlicedSimplex& simplex, SliceChunkBuilder& builder,
    CrossingLists::Arena& arena)
  {
    const Case& what = this->Cases[simplex.FindAbove(AtValue)];
    std::uint16_t places[6];
    for (int slot = 0; slot < what.NumberOfSlots; ++slot)
    {
      const auto& [near, far] = what.Edges[slot];
      places[slot] =
        builder.Find(simplex.GetId(near), CrossingKey(simplex.GetId(far), 0), this->Lists, arena);
    }
    for (int t = 0; t < what.NumberOfTetrahedra; ++t)
    {
      AddTetrahedron(what.Tetrahedra[t], places, simplex.IsInverted(), position, builder);
    }
  }

  void CountTied(std::uint16_t position, const SlicedSimplex& simplex, Meeting meeting,
    vtkIdType interval, Chunk& chunk, SliceChunkBuilder& builder, CrossingLists::Arena& arena)
  {
    // Where a 4-simplex begins, its slice is the limit of those above the value.
    const Code first =
      meeting == Meeting::Begins || meeting == Meeting::Lies ? AboveValue : AtValue;
    const Case& what = this->Cases[simplex.FindAbove(first)];
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
      std::uint16_t places[6];
      for (const Slot slot : slots)
      {
        places[slot] = builder.Find(points[slot].Owner, points[slot].Key, this->Lists, arena);
      }
      if (meeting != Meeting::Crosses)
      {
        // All four points are vertices.
        chunk.Places.push_back(builder.GetNumberOfTetrahedra());
        chunk.Faces.push_back(
          { { { points[0].Owner, points[1].Owner, points[2].Owner, points[3].Owner } }, interval,
            meeting });
      }
      AddTetrahedron(slots, places, simplex.IsInverted(), position, builder);
    }
  }

  bool FindWrongCell()
  {
    const auto wrong = std::find_if(this->Chunks.begin(), this->Chunks.end(),
      [](const Chunk& chunk) { return chunk.WrongCell >= 0; });
    this->Slice.WrongCell = wrong == this->Chunks.end() ? -1 : wrong->WrongCell;
    return this->Slice.WrongCell >= 0;
  }

  // Finds the places where chunks begin, and makes room for all.
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

  void WriteChunk(vtkIdType number)
  {
    const Chunk& chunk = this->Chunks[number];
    const auto write = [&chunk](auto* values)
    {
      using Id = std::decay_t<decltype(*values)>;
      std::vector<Id> ids(chunk.Nodes.size());
      std::transform(chunk.Nodes.begin(), chunk.Nodes.end(), ids.begin(),
        [](const CrossingLists::Node* node) { return static_cast<Id>(node->Id); });
      Id* next = values + 4 * chunk.First;
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

  const ExtractionContext& Context;
  vtkUnstructuredGrid* Grid;
  std::unique_ptr<ExtractionScalars> Scalars;
  CornerOrder Order;
  // The intervals of the cells; null where cells have none.
  vtkDataArray* Intervals;
  // Null where all faces count.
  vtkDataArray* AtStep;
  ExtractionBuffer<Code> Codes;
  CrossingLists Lists;
  const std::array<Case, 32>& Cases = SimplexSliceTable::GetAll();
  std::vector<Chunk> Chunks;
  vtkSMPThreadLocal<SliceChunkBuilder> Builders;
  SimplexSlicer::Slice& Slice;
};
}

bool SimplexSlicer::Execute(
  const ExtractionContext& context, vtkUnstructuredGrid* grid, Slice& slice)
{
  return Slicer(context, grid, slice).Execute();
}

}
