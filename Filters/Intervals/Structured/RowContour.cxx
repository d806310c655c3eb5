// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/RowContour.h"

#include "Grid/CellOrientation.h"
#include "Pass/ExtractionIndex.h"
#include "Scalars/BitKernels.h"
#include "Scalars/ExtractionScalars.h"
#include "Structured/PointOutput.h"
#include "Structured/RowPass.h"

#include <array>
#include <memory>
#include <tuple>
#include <vector>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;

constexpr int Vertices = 8;
// Maximum number of points that a grid point owns: itself and the crossings of its edges along i, j
// and k.
constexpr int MaximumOwned = 4;

// The rows of points around a row of cells: (j, k), (j + 1, k), (j, k + 1), (j + 1, k + 1). A row
// is replaced by the first row if it does not exist, or if it was not compared because the surface
// does not reach it.
struct Around
{
  vtkIdType J;
  vtkIdType K;
  bool HasCells;
  std::array<vtkIdType, 4> Numbers;
  std::array<BitRows::Row, 4> Rows;
  BitRows::Kinds Kinds;

  // Returns the rows that determine which points the first row owns.
  std::array<BitRows::Row, 3> GetOwners() const { return { { Rows[0], Rows[1], Rows[2] } }; }

  // Returns true if the bit in \a bits is set for any corner of a cell.
  bool Has(BitRows::Word* BitRows::Row::*bits, vtkIdType column) const
  {
    return std::any_of(this->Rows.begin(), this->Rows.end(),
      [=](const BitRows::Row& row)
      { return IsSet(row.*bits, column) || IsSet(row.*bits, column + 1); });
  }

  // Returns the code of a corner of a cell.
  Code GetCode(vtkIdType column, int vertex) const
  {
    const BitRows::Row& row = this->Rows[vertex >> 1];
    const vtkIdType corner = column + (vertex & 1);
    return !IsSet(row.Above, corner) ? 0 : IsSet(row.Ties, corner) ? 1 : 2;
  }

  // Returns true if points that the first row owns may be unused. All are used if the row of cells
  // exists and all values are finite and differ from the isovalue.
  bool MayHaveUnusedPoints() const { return !this->HasCells || this->Kinds.IsAny(); }

  static bool IsSet(const BitRows::Word* words, vtkIdType column)
  {
    return (words[column / BitRows::BitsOfWord] >> (column % BitRows::BitsOfWord)) & 1;
  }
};

// Calls visit(column, owned, bit) for each grid point that owns output points in a row of \a nx
// grid points. In each word of \a owned, the bit with index \a bit belongs to the grid point.
template <bool IsSpecial, typename Visitor>
void ForEachOwner(const Around& around, vtkIdType nx, Visitor&& visit)
{
  const auto rows = around.GetOwners();
  for (vtkIdType word = 0; word < BitRows::GetNumberOfWords(nx); ++word)
  {
    const BitKernels::Owned owned = BitKernels::FindOwnedPoints<IsSpecial>(rows.data(), word, nx);
    BitKernels::ForEach(owned.Points | owned.Edges[0] | owned.Edges[1] | owned.Edges[2],
      [&](int bit) { visit(word * BitRows::BitsOfWord + bit, owned, bit); });
  }
}

// Numbers the output points that a row of \a nx grid points owns, starting with \a next. Each grid
// point has MaximumOwned entries in \a ids.
template <bool IsSpecial, typename Id>
void FillIds(const Around& around, vtkIdType nx, Id next, Id* ids)
{
  ForEachOwner<IsSpecial>(around, nx,
    [&](vtkIdType column, const BitKernels::Owned& owned, int bit)
    {
      Id* const at = ids + MaximumOwned * column;
      if (IsSpecial)
      {
        at[0] = next;
        next += (owned.Points >> bit) & 1;
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        at[1 + axis] = next;
        next += (owned.Edges[axis] >> bit) & 1;
      }
    });
}

// The comparison bits of all rows that may have output.
class ComparedRows
{
public:
  ComparedRows(const ExtractionContext& context, const RowIndex& rows, const GridCellRange& window)
    : Index(context.Index)
    , Rows(rows)
    , Nx(window.Last[0] - window.First[0] + 1)
    , Ny(window.Last[1] - window.First[1] + 1)
    , Nz(window.Last[2] - window.First[2] + 1)
  {
    const vtkIdType number = rows.GetNumberOfRows();
    this->Bits.Allocate(number, this->Nx);
    if (this->Index)
    {
      this->FindActive(number);
    }
  }

  bool IsCompared(vtkIdType row) const { return !this->Index || this->Compared[row]; }

  void Compare(vtkIdType row, const ExtractionScalars& scalars)
  {
    if (this->IsCompared(row))
    {
      this->Bits.GetKinds(row) =
        scalars.Compare(this->Rows.GetFirstPoint(row), this->Nx, this->Bits.GetRow(row));
    }
  }

  Around GetAround(vtkIdType row)
  {
    Around around;
    around.J = this->Rows.GetJ(row);
    around.K = this->Rows.GetK(row);
    around.HasCells = this->MayHaveOutput(around.J, around.K);
    for (int r = 0; r < 4; ++r)
    {
      const vtkIdType j = around.J + (r & 1);
      const vtkIdType k = around.K + (r >> 1);
      const bool isThere =
        j < this->Ny && k < this->Nz && this->IsCompared(this->Rows.GetRow(j, k));
      around.Numbers[r] = isThere ? this->Rows.GetRow(j, k) : row;
      around.Rows[r] = this->Bits.GetRow(around.Numbers[r]);
      around.Kinds.Add(this->Bits.GetKinds(around.Numbers[r]));
    }
    return around;
  }

  // Returns true if any value equals the isovalue or is not finite.
  bool HasSpecial()
  {
    BitRows::Kinds kinds;
    for (vtkIdType row = 0; row < this->Rows.GetNumberOfRows(); ++row)
    {
      kinds.Add(this->Bits.GetKinds(row));
    }
    return kinds.IsAny();
  }

  std::size_t GetBytes() const { return this->Bits.GetBytes(); }

private:
  // Uses the index to find the rows of points to compare: those around rows of cells that may have
  // output.
  void FindActive(vtkIdType rows)
  {
    this->Compared.assign(rows, false);
    for (vtkIdType row = 0; row < rows; ++row)
    {
      const vtkIdType j = this->Rows.GetJ(row);
      const vtkIdType k = this->Rows.GetK(row);
      const int corners = this->MayHaveOutput(j, k) ? 4 : 0;
      for (int r = 0; r < corners; ++r)
      {
        this->Compared[this->Rows.GetRow(j + (r & 1), k + (r >> 1))] = true;
      }
    }
  }

  // Returns true if the row of cells that starts at the row of points (j, k) may have output.
  bool MayHaveOutput(vtkIdType j, vtkIdType k) const
  {
    return this->Rows.HasCells(j, k) &&
      (!this->Index || this->Index->IsRowActive(this->Rows.GetCellRow(j, k)));
  }

  // Null if all rows are compared.
  const ExtractionIndex* Index;
  const RowIndex& Rows;
  vtkIdType Nx;
  vtkIdType Ny;
  vtkIdType Nz;
  std::vector<bool> Compared;
  BitRows Bits;
};

// The ids that a thread needs for the triangles of a row of cells.
template <typename Id>
struct RowIds
{
  // The ids of the points that a row of grid points owns, with MaximumOwned entries per grid point.
  struct Row
  {
    vtkIdType Number = -1;
    std::vector<Id> Ids;
  };

  // Cached rows, indexed by the lowest bits of k and j.
  std::array<std::array<Row, 2>, 2> Rows;
  // Pointer to the point id of each slot in the first cell of the row. The id for the next cell is
  // MaximumOwned entries later.
  std::array<const Id*, vtkIsotable::MaximumNumberOfSlots> Slots{};
};

struct ContourLocal : RowResults
{
  std::vector<std::uint32_t> Columns;
  std::vector<std::uint8_t> Keys;
  std::vector<ExtractionPoint> Points;
  std::tuple<RowIds<vtkTypeInt32>, RowIds<vtkTypeInt64>> Ids;
};

class BitPass : public RowPass<BitPass, ContourLocal>
{
public:
  BitPass(ExtractionContext& context, const int dimensions[3], const GridCellRange& window,
    ExtractionMesh& mesh)
    : RowPass(context, dimensions, window, mesh)
    , Item(context.Values->GetItems()[0])
    , Scalars(context.MakeScalars())
    , Slots(SlotLocation::FindAll(Table, *context.Values))
    , Orientation(context.Input)
    , Bits(context, Rows, window)
  {
  }

  bool Classify()
  {
    return this->ForEachPart(this->Rows.GetNumberOfRows(), 0.0, 0.05,
      [this](vtkIdType row, ContourLocal&) { this->Bits.Compare(row, *this->Scalars); });
  }

  void CountPart(vtkIdType row, ContourLocal& local)
  {
    if (!this->Bits.IsCompared(row))
    {
      return;
    }
    const Around around = this->Bits.GetAround(row);
    RowCount& count = this->Offsets[row + 1];
    count.Points =
      BitKernels::CountOwnedPoints(around.GetOwners().data(), this->Nx, around.Kinds.IsAny());
    if (around.HasCells)
    {
      count.Simplices = this->CountCells(local, around);
    }
  }

  bool Settle() { return true; }

  void Allocate()
  {
    this->AllocateRows();
    // A point is in the output unless all its simplices have collapsed or are in skipped cells.
    this->MarksUsed = this->Bits.HasSpecial();
    if (this->MarksUsed)
    {
      this->Mesh.Used.AllocateZeros(this->Offsets.back().Points);
    }
  }

  void WritePart(vtkIdType row, ContourLocal& local)
  {
    const RowCount& position = this->Offsets[row];
    const RowCount& next = this->Offsets[row + 1];
    const bool hasPoints = position.Points != next.Points;
    const bool hasTriangles = position.HasCells(next);
    if (!hasPoints && !hasTriangles)
    {
      return;
    }
    const Around around = this->Bits.GetAround(row);
    if (hasPoints)
    {
      this->WritePoints(local, around, position.Points, next.Points - position.Points);
    }
    if (hasTriangles)
    {
      this->Mesh.Simplices.Visit(
        [&](auto* ids) { this->WriteCells(local, around, position.Simplices, ids); });
    }
  }

  void Finish()
  {
    // Bytes per grid column: Columns, Keys, Points and four rows of ids.
    constexpr std::size_t bytesOfColumn = sizeof(std::uint32_t) + sizeof(std::uint8_t) +
      MaximumOwned * (sizeof(ExtractionPoint) + 4 * sizeof(vtkIdType));
    const std::ptrdiff_t threads = std::distance(this->Locals.begin(), this->Locals.end());
    this->Gather(this->Bits.GetBytes() +
      static_cast<std::size_t>(threads) * static_cast<std::size_t>(this->Nx) * bytesOfColumn);
  }

private:
  vtkIdType CountCells(ContourLocal& local, const Around& around) const
  {
    vtkIdType triangles = 0;
    local.Report.CellsVisited += this->Nx - 1;
    local.Report.CellsByBits += this->Nx - 1;
    if (around.Kinds.NonFinite)
    {
      local.Report.NonFiniteCells += BitKernels::CountNonFinite(around.Rows.data(), this->Nx);
    }
    const vtkIdType firstPoint = this->Rows.GetFirstPoint(around.Numbers[0]);
    this->ForEachCell(local, around,
      [&](vtkIdType column, const vtkIsotable::Case& found, TieCaseCache::Tied* tied)
      {
        const std::size_t number = tied ? tied->Cut.GetSimplices().size() : found.Simplices.size();
        local.Report.CollapsedSimplices += tied ? tied->Cut.GetNumberOfCollapsedSimplices() : 0;
        local.Report.CellsWithOutput += number > 0;
        local.Report.FoldedCells +=
          number > 0 && this->Orientation.IsFolded(this->Rows, firstPoint + column);
        triangles += static_cast<vtkIdType>(number);
      });
    return triangles;
  }

  // Calls visit(column, case, tied) for the cells of a row that the surface intersects. \a tied is
  // null if the cut stored in the table applies.
  template <typename Visitor>
  void ForEachCell(ContourLocal& local, const Around& around, Visitor&& visit) const
  {
    local.Columns.resize(this->Nx);
    local.Keys.resize(this->Nx);
    const vtkIdType number =
      BitKernels::FindCells(around.Rows.data(), this->Nx, local.Columns.data(), local.Keys.data());
    for (vtkIdType c = 0; c < number; ++c)
    {
      const vtkIdType column = local.Columns[c];
      const vtkIsotable::Case& found = this->Table.GetCase(local.Keys[c]);
      TieCaseCache::Tied* tied = nullptr;
      if (around.Kinds.IsAny())
      {
        if (around.Has(&BitRows::Row::NonFinite, column))
        {
          continue;
        }
        if (around.Has(&BitRows::Row::Ties, column))
        {
          tied = this->FindTied(local, around, column, found);
        }
      }
      visit(column, found, tied);
    }
  }

  // Returns the cut of a cell where values equal the isovalue, or null if the cut stored in the
  // table applies.
  TieCaseCache::Tied* FindTied(ContourLocal& local, const Around& around, vtkIdType column,
    const vtkIsotable::Case& found) const
  {
    Code codes[Vertices];
    for (int v = 0; v < Vertices; ++v)
    {
      codes[v] = around.GetCode(column, v);
    }
    TieCaseCache::Tied& tied =
      local.TieCaseCache.Find(this->Table, this->Ranks, this->Item, 0, codes, found, false);
    return tied.IsMerged ? &tied : nullptr;
  }

  void WritePoints(ContourLocal& local, const Around& around, vtkIdType first, vtkIdType number)
  {
    around.Kinds.IsAny() ? this->MakePoints<true>(local, around)
                         : this->MakePoints<false>(local, around);
    if (this->MarksUsed && !around.MayHaveUnusedPoints())
    {
      std::for_each_n(this->Mesh.Used.GetData() + first, number,
        [](auto& mark) { mark.store(1, std::memory_order_relaxed); });
    }
    PointOutput::Write(
      this->Context, *this->Scalars, local.Points.data(), number, first, this->Mesh);
  }

  // Lists the points that a row owns. Each candidate is written unconditionally, which avoids a
  // branch that is hard to predict. If the row does not own the candidate, the next point
  // overwrites it.
  template <bool IsSpecial>
  void MakePoints(ContourLocal& local, const Around& around) const
  {
    local.Points.resize(MaximumOwned * (this->Nx + 1));
    ExtractionPoint* out = local.Points.data();
    const vtkIdType firstPoint = this->Rows.GetFirstPoint(around.Numbers[0]);
    ForEachOwner<IsSpecial>(around, this->Nx,
      [&](vtkIdType column, const BitKernels::Owned& owned, int bit)
      {
        const vtkIdType id = firstPoint + column;
        if (IsSpecial)
        {
          *out = { id, id, 0.0 };
          out += (owned.Points >> bit) & 1;
        }
        for (int axis = 0; axis < 3; ++axis)
        {
          *out = { id, id + this->Rows.GetStep(axis), 0.0 };
          out += (owned.Edges[axis] >> bit) & 1;
        }
      });
  }

  // Finds the point ids of each slot along a row of cells.
  template <typename Id>
  void FindSlots(RowIds<Id>& rows, const Around& around)
  {
    std::array<const Id*, 4> ids;
    for (int r = 0; r < 4; ++r)
    {
      ids[r] = this->GetIds(rows, around.J + (r & 1), around.K + (r >> 1));
    }
    for (int slot = 0; slot < Vertices + this->Table.GetNumberOfEdges(); ++slot)
    {
      const SlotLocation& at = this->Slots[slot];
      rows.Slots[slot] = ids[at.Row] + MaximumOwned * at.Column + at.Direction;
    }
  }

  template <typename Id>
  const Id* GetIds(RowIds<Id>& rows, vtkIdType j, vtkIdType k)
  {
    typename RowIds<Id>::Row& row = rows.Rows[k & 1][j & 1];
    const vtkIdType number = this->Rows.GetRow(j, k);
    if (row.Number != number)
    {
      row.Number = number;
      row.Ids.resize(MaximumOwned * this->Nx);
      if (this->Offsets[number].Points != this->Offsets[number + 1].Points)
      {
        const Around around = this->Bits.GetAround(number);
        const Id first = static_cast<Id>(this->Offsets[number].Points);
        around.Kinds.IsAny() ? FillIds<true>(around, this->Nx, first, row.Ids.data())
                             : FillIds<false>(around, this->Nx, first, row.Ids.data());
      }
    }
    return row.Ids.data();
  }

  template <typename Id>
  void WriteCells(ContourLocal& local, const Around& around, vtkIdType triangle, Id* ids)
  {
    RowIds<Id>& rows = std::get<RowIds<Id>>(local.Ids);
    this->FindSlots(rows, around);
    const vtkIdType firstPoint = this->Rows.GetFirstPoint(around.Numbers[0]);
    const vtkIdType firstCell = this->Rows.GetFirstCell(around.J, around.K);
    const auto& slots = rows.Slots;
    Id* out = ids + 3 * triangle;
    const vtkIdType first = triangle;
    const std::size_t firstTied = local.TiedSimplices.size();
    this->ForEachCell(local, around,
      [&](vtkIdType column, const vtkIsotable::Case& found, TieCaseCache::Tied* tied)
      {
        const auto& triangles = tied ? tied->Cut.GetSimplices() : found.Simplices;
        const bool isInverted = this->Orientation.IsInverted(this->Rows, firstPoint + column);
        const vtkIdType position = MaximumOwned * column;
        for (const vtkIsotable::Simplex& corners : triangles)
        {
          out[isInverted] = slots[corners[0]][position];
          out[!isInverted] = slots[corners[1]][position];
          out[2] = slots[corners[2]][position];
          out += 3;
        }
        if (tied)
        {
          this->NoteTied(local, *tied, triangle);
        }
        this->Mesh.SetSimplexOrigins(triangle, triangles.size(), 0, firstCell + column);
        triangle += static_cast<vtkIdType>(triangles.size());
      });
    const bool marks = this->MarksUsed &&
      std::any_of(around.Numbers.begin(), around.Numbers.end(),
        [this](vtkIdType row) { return this->Bits.GetAround(row).MayHaveUnusedPoints(); });
    auto tied = local.TiedSimplices.begin() + static_cast<std::ptrdiff_t>(firstTied);
    for (vtkIdType t = first; marks && t < triangle; ++t)
    {
      if (tied != local.TiedSimplices.end() && *tied == t)
      {
        ++tied;
        continue;
      }
      std::for_each_n(
        ids + 3 * t, 3, [this](Id id) { this->Mesh.Used[id].store(1, std::memory_order_relaxed); });
    }
  }

  // Records the triangles that lie in a face of a cell. The neighbor cell may have the same
  // triangles with opposite orientation.
  void NoteTied(ContourLocal& local, TieCaseCache::Tied& tied, vtkIdType triangle) const
  {
    for (const vtkIsotable::Simplex& corners : tied.Cut.GetSimplices())
    {
      if (tied.Cut.IsInFace(this->Table, corners))
      {
        local.TiedSimplices.push_back(triangle);
      }
      ++triangle;
    }
  }

  const ExtractionValues::Item& Item;
  std::unique_ptr<ExtractionScalars> Scalars;
  std::vector<SlotLocation> Slots;
  CellOrientation Orientation;
  ComparedRows Bits;
  bool MarksUsed = false;
};
}

bool RowContour::IsApplicable(const ExtractionContext& context)
{
  return context.Values->GetKind() == vtkIsotable::CONTOUR &&
    context.Values->GetItems().size() == 1 && !context.InteriorFilter &&
    !context.IncludeGhostCells && !context.GenerateBoundaries;
}

bool RowContour::Execute(ExtractionContext& context, const int dimensions[3],
  const GridCellRange& window, ExtractionMesh& mesh)
{
  return BitPass(context, dimensions, window, mesh).Execute();
}

}
