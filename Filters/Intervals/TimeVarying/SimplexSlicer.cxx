// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/SimplexSlicer.h"

#include "Grid/CornerOrder.h"
#include "Scalars/ExtractionScalars.h"
#include "Static/CrossingLists.h"
#include "TimeVarying/SimplexSliceTable.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
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
using Slot = vtkIsotable::Slot;
using Case = SimplexSliceTable::Slice;
using Parts = vtkTimeVaryingSettings::PartsAtStep;

constexpr vtkIdType ChunkSize = 4096;
constexpr int SimplexSize = 5;
// The codes of one value.
constexpr Code AtValue = 1;
constexpr Code AboveValue = 2;

// The ways in which a 4-simplex meets the value.
enum class Meeting
{
  None,
  Crosses,
  // The 4-simplex crosses with one vertex below and four at the value.
  Ends,
  // Four vertices are at the value and one is above.
  Begins,
  // All are at the value: a tetrahedron whose last point is there twice.
  Lies
};

// A tetrahedron at the value.
struct Face
{
  // Its points in the global order.
  std::array<vtkIdType, 4> Ids;
  vtkIdType Interval;
  Meeting How;

  bool operator<(const Face& other) const { return this->Ids < other.Ids; }
};
using FaceRange = std::pair<std::vector<Face>::const_iterator, std::vector<Face>::const_iterator>;

// A 4-simplex, its vertices in the global order.
struct Simplex
{
  vtkIdType Ids[SimplexSize];
  Code Codes[SimplexSize];
  bool IsInverted;
};

// A point of the slice: its owner, and its key there.
struct Point
{
  vtkIdType Owner;
  CrossingKey Key;

  bool operator==(const Point& other) const
  {
    return this->Owner == other.Owner && this->Key == other.Key;
  }
};

// A 4-simplex with output, in a chunk.
struct Found
{
  // The place of the cell, counted from the chunk's first.
  std::uint16_t Position;
  // The key of the case.
  std::uint8_t Above;
  // The tetrahedra that have not collapsed, a bit each.
  std::uint8_t Kept;
  bool IsInverted;
  // Whether the tetrahedron is a face of the 4-simplex, or all of it.
  bool IsFace;
  // Whether that tetrahedron is left to another 4-simplex.
  bool IsGiven;
};

// The result of the counting pass for a chunk of cells, which the writing pass uses.
struct Chunk
{
  std::vector<Found> Cases;
  // The points of all cases.
  std::vector<const CrossingLists::Node*> Nodes;
  // The tetrahedra at the value, in the order of the cases.
  std::vector<Face> Faces;
  vtkIdType Tetrahedra = 0;
  vtkIdType WrongCell = -1;
};

// Returns the slots that are used by the tetrahedra kept, a bit each.
unsigned int FindUsedSlots(const Case& what, unsigned int kept)
{
  unsigned int used = 0;
  for (int t = 0; t < what.NumberOfTetrahedra; ++t)
  {
    for (const Slot slot : what.Tetrahedra[t])
    {
      used |= ((kept >> t) & 1u) << slot;
    }
  }
  return used;
}

bool IsCollapsed(const vtkIsotable::Simplex& tetrahedron, const Point* points)
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
    const vtkIdType points = this->Grid->GetNumberOfPoints();
    const vtkIdType cells = this->Grid->GetNumberOfCells();
    const vtkIdType chunks = (cells + ChunkSize - 1) / ChunkSize;
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
      !forEachChunk(0.05, 0.4, [this](vtkIdType chunk) { this->CountChunk(chunk); }))
    {
      return false;
    }
    if (this->FindWrongCell())
    {
      return true;
    }
    this->Codes.Free();
    const std::vector<Face> faces = this->GatherFaces();
    if (std::any_of(
          faces.begin(), faces.end(), [](const Face& face) { return face.How != Meeting::Ends; }) &&
      !forEachChunk(0.4, 0.5, [&](vtkIdType chunk) { LeaveOutGiven(faces, this->Chunks[chunk]); }))
    {
      return false;
    }
    this->Lists.MakePoints(*this->Scalars, this->Slice.Points);
    this->Allocate();
    return forEachChunk(0.5, 0.8, [this](vtkIdType chunk) { this->WriteChunk(chunk); });
  }

private:
  void CountChunk(vtkIdType number)
  {
    Chunk& chunk = this->Chunks[number];
    CrossingLists::Arena& arena = this->Lists.GetArena();
    const vtkIdType begin = number * ChunkSize;
    const vtkIdType end = std::min(begin + ChunkSize, this->Grid->GetNumberOfCells());
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      this->Grid->GetCells()->GetCellAtId(cell, ids);
      if (this->Grid->GetCellType(cell) != VTK_POLY_VERTEX || ids->GetNumberOfIds() != SimplexSize)
      {
        chunk.WrongCell = cell;
        return;
      }
      const Meeting meeting =
        this->IsBlanked(cell, ids) ? Meeting::None : this->Meet(cell, ids->GetPointer(0));
      if (meeting != Meeting::None)
      {
        const std::uint16_t position = static_cast<std::uint16_t>(cell - begin);
        this->CountSimplex(position, this->Sort(ids->GetPointer(0), meeting), meeting,
          this->GetInterval(cell), chunk, arena);
      }
    }
  }

  bool IsBlanked(vtkIdType cell, vtkIdList* ids) const
  {
    return this->Context.HasBlanking() &&
      (this->Context.IsCellBlanked(cell) ||
        std::any_of(ids->begin(), ids->end(),
          [this](vtkIdType point) { return this->Context.IsPointBlanked(point); }));
  }

  Meeting Meet(vtkIdType cell, const vtkIdType* ids) const
  {
    Code least = AboveValue;
    Code greatest = 0;
    int numberAt = 0;
    for (int v = 0; v < SimplexSize; ++v)
    {
      const Code code = this->Codes[ids[v]];
      least = std::min(least, code);
      greatest = std::max(greatest, code);
      numberAt += code == AtValue;
    }
    if (greatest < AtValue || greatest == this->Context.Values->GetNonFiniteCode())
    {
      return Meeting::None;
    }
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

  Simplex Sort(const vtkIdType* ids, Meeting meeting) const
  {
    Slot ranks[SimplexSize];
    this->Order.Rank(ids, SimplexSize, ranks);
    Simplex simplex{};
    for (int v = 0; v < SimplexSize; ++v)
    {
      simplex.Ids[ranks[v]] = ids[v];
      simplex.Codes[ranks[v]] = this->Codes[ids[v]];
      for (int before = 0; before < v; ++before)
      {
        simplex.IsInverted ^= ranks[before] > ranks[v];
      }
    }
    if (meeting == Meeting::Lies)
    {
      // As if a 4-simplex began with the tetrahedron.
      simplex.Codes[ranks[SimplexSize - 1]] = AboveValue;
    }
    return simplex;
  }

  // Returns the interval that a cell belongs to: intervals may overlap, and each has its own slice.
  vtkIdType GetInterval(vtkIdType cell) const
  {
    return this->Intervals ? static_cast<vtkIdType>(this->Intervals->GetComponent(cell, 0)) : 0;
  }

  void CountSimplex(std::uint16_t position, const Simplex& simplex, Meeting meeting,
    vtkIdType interval, Chunk& chunk, CrossingLists::Arena& arena)
  {
    // Where a 4-simplex begins, its slice is the limit of those above the value.
    const Code first =
      meeting == Meeting::Begins || meeting == Meeting::Lies ? AboveValue : AtValue;
    unsigned int above = 0;
    for (int v = 0; v < SimplexSize; ++v)
    {
      const unsigned int isAbove = simplex.Codes[v] >= first ? 1 : 0;
      above |= isAbove << v;
    }
    const Case& what = SimplexSliceTable::Get(above);
    Point points[6];
    for (int slot = 0; slot < what.NumberOfSlots; ++slot)
    {
      points[slot] = FindPoint(simplex, what.Edges[slot]);
    }
    unsigned int kept = 0;
    for (int t = 0; t < what.NumberOfTetrahedra; ++t)
    {
      const bool isKept = !IsCollapsed(what.Tetrahedra[t], points);
      kept |= (isKept ? 1u : 0u) << t;
      chunk.Tetrahedra += isKept;
    }
    if (kept == 0)
    {
      return;
    }
    const unsigned int used = FindUsedSlots(what, kept);
    for (int slot = 0; slot < what.NumberOfSlots; ++slot)
    {
      if ((used >> slot) & 1)
      {
        chunk.Nodes.push_back(this->Lists.Enter(points[slot].Owner, points[slot].Key, arena));
      }
    }
    const bool isFace = meeting != Meeting::Crosses;
    chunk.Cases.push_back({ position, static_cast<std::uint8_t>(above),
      static_cast<std::uint8_t>(kept), simplex.IsInverted, isFace, false });
    if (isFace)
    {
      // All four points are vertices.
      chunk.Faces.push_back(
        { { { points[0].Owner, points[1].Owner, points[2].Owner, points[3].Owner } }, interval,
          meeting });
    }
  }

  static Point FindPoint(const Simplex& simplex, const std::array<Slot, 2>& edge)
  {
    for (const Slot end : edge)
    {
      if (simplex.Codes[end] == AtValue)
      {
        return { simplex.Ids[end], CrossingKey() };
      }
    }
    const auto ends = std::minmax(simplex.Ids[edge[0]], simplex.Ids[edge[1]]);
    return { ends.first, CrossingKey(ends.second, 0) };
  }

  bool FindWrongCell()
  {
    const auto wrong = std::find_if(this->Chunks.begin(), this->Chunks.end(),
      [](const Chunk& chunk) { return chunk.WrongCell >= 0; });
    this->Slice.WrongCell = wrong == this->Chunks.end() ? -1 : wrong->WrongCell;
    return this->Slice.WrongCell >= 0;
  }

  // The tetrahedra at the value of all chunks, sorted.
  std::vector<Face> GatherFaces() const
  {
    std::vector<Face> faces;
    for (const Chunk& chunk : this->Chunks)
    {
      faces.insert(faces.end(), chunk.Faces.begin(), chunk.Faces.end());
    }
    vtkSMPTools::Sort(faces.begin(), faces.end());
    return faces;
  }

  // Of one interval, what begins is given by what ends, and a tetrahedron by either.
  static bool IsGiven(const Face& face, const FaceRange& alike)
  {
    return std::any_of(alike.first, alike.second,
      [&face](const Face& other)
      { return other.Interval == face.Interval && other.How < face.How; });
  }

  static void LeaveOutGiven(const std::vector<Face>& faces, Chunk& chunk)
  {
    auto face = chunk.Faces.begin();
    for (Found& found : chunk.Cases)
    {
      if (found.IsFace)
      {
        found.IsGiven = IsGiven(*face, std::equal_range(faces.begin(), faces.end(), *face));
        chunk.Tetrahedra -= found.IsGiven;
        ++face;
      }
    }
  }

  // Turns the counts of chunks into the places where they begin, and makes room for all.
  void Allocate()
  {
    vtkIdType tetrahedra = 0;
    for (Chunk& chunk : this->Chunks)
    {
      std::swap(chunk.Tetrahedra, tetrahedra);
      tetrahedra += chunk.Tetrahedra;
    }
    this->Slice.Tetrahedra.Allocate(
      tetrahedra, 4, static_cast<vtkIdType>(this->Slice.Points.GetSize()));
    this->Slice.CellIds.Allocate(this->Context.KeepCellIds ? tetrahedra : 0);
  }

  void WriteChunk(vtkIdType number)
  {
    const Chunk& chunk = this->Chunks[number];
    vtkIdType tetrahedron = chunk.Tetrahedra;
    auto node = chunk.Nodes.begin();
    vtkIdType ids[6];
    for (const Found& found : chunk.Cases)
    {
      const Case& what = SimplexSliceTable::Get(found.Above);
      const unsigned int used = FindUsedSlots(what, found.Kept);
      for (int slot = 0; slot < what.NumberOfSlots; ++slot)
      {
        if ((used >> slot) & 1)
        {
          ids[slot] = (*node++)->Id;
        }
      }
      for (int t = 0; t < what.NumberOfTetrahedra && !found.IsGiven; ++t)
      {
        if ((found.Kept >> t) & 1)
        {
          this->Slice.Tetrahedra.Write(tetrahedron, &what.Tetrahedra[t], 1, ids, found.IsInverted);
          if (this->Context.KeepCellIds)
          {
            this->Slice.CellIds[tetrahedron] = number * ChunkSize + found.Position;
          }
          ++tetrahedron;
        }
      }
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
  std::vector<Chunk> Chunks;
  SimplexSlicer::Slice& Slice;
};
}

bool SimplexSlicer::Execute(
  const ExtractionContext& context, vtkUnstructuredGrid* grid, Slice& slice)
{
  return Slicer(context, grid, slice).Execute();
}

}
