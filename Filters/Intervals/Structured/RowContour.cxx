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
// What a grid point may own: itself, and the crossings of its edges along i, j and k.
constexpr int Places = 4;

// The rows of points around a row of cells: (j, k), (j + 1, k), (j, k + 1), (j + 1, k + 1). Where
// there is none, or it is not compared and so on the same side, it is the first.
struct Around
{
  vtkIdType J;
  vtkIdType K;
  bool HasCells;
  std::array<vtkIdType, 4> Numbers;
  std::array<BitRows::Row, 4> Rows;
  BitRows::Kinds Kinds;

  // The rows that decide on what the first one owns.
  std::array<BitRows::Row, 3> GetOwners() const { return { { Rows[0], Rows[1], Rows[2] } }; }

  // Returns whether a bit of any corner of a cell is set.
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

  // Returns whether points that the row owns may be left without triangles. Where its own cells are
  // cut by the table, each of its crossings is in one of these.
  bool MayLeavePoints() const { return !this->HasCells || this->Kinds.IsAny(); }

  static bool IsSet(const BitRows::Word* words, vtkIdType column)
  {
    return (words[column / BitRows::BitsOfWord] >> (column % BitRows::BitsOfWord)) & 1;
  }
};

// Calls visit(column, owned, bit) for the points of a row of \a nx points that own something; their
// bits in the words of owned are at place bit.
template <bool IsSpecial, typename Visitor>
void ForEachOwner(const Around& around, vtkIdType nx, Visitor&& visit)
{
  const auto rows = around.GetOwners();
  for (vtkIdType word = 0; word < BitRows::GetNumberOfWords(nx); ++word)
  {
    const BitKernels::Owned owned = BitKernels::FindOwned<IsSpecial>(rows.data(), word, nx);
    BitKernels::ForEach(owned.Points | owned.Edges[0] | owned.Edges[1] | owned.Edges[2],
      [&](int bit) { visit(word * BitRows::BitsOfWord + bit, owned, bit); });
  }
}

// Writes the ids of what a row of \a nx points owns, from \a next on, Places for each point.
template <bool IsSpecial, typename Id>
void FillIds(const Around& around, vtkIdType nx, Id next, Id* ids)
{
  ForEachOwner<IsSpecial>(around, nx,
    [&](vtkIdType column, const BitKernels::Owned& owned, int bit)
    {
      Id* const at = ids + Places * column;
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

// The bits of all rows that may give output.
class ComparedRows
{
public:
  ComparedRows(const ExtractionContext& context, const RowIndex& rows, const GridWindow& window)
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
    around.HasCells = this->MayGive(around.J, around.K);
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

  // Returns whether any value equals the isovalue or is not finite.
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
  // Finds by the index which rows of points have to be compared: those around rows of cells that
  // may give output.
  void FindActive(vtkIdType rows)
  {
    this->Compared.assign(rows, false);
    for (vtkIdType row = 0; row < rows; ++row)
    {
      const vtkIdType j = this->Rows.GetJ(row);
      const vtkIdType k = this->Rows.GetK(row);
      const int corners = this->MayGive(j, k) ? 4 : 0;
      for (int r = 0; r < corners; ++r)
      {
        this->Compared[this->Rows.GetRow(j + (r & 1), k + (r >> 1))] = true;
      }
    }
  }

  // Returns whether the cells at a row of points may give output.
  bool MayGive(vtkIdType j, vtkIdType k) const
  {
    return this->Rows.HasCells(j, k) &&
      (!this->Index || this->Index->IsRowActive(this->Rows.GetCellRow(j, k)));
  }

  // Null where all rows are compared.
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
  // The ids of what a row of grid points owns, Places for each point.
  struct Row
  {
    vtkIdType Number = -1;
    std::vector<Id> Ids;
  };

  // By the last bits of k and j.
  std::array<std::array<Row, 2>, 2> Rows;
  // For each slot the id in the first cell of a row of cells, or null; those of the next cells are
  // Places further on.
  std::array<const Id*, vtkIsotable::MaximumNumberOfSlots> Slots{};
};

struct ContourLocal : RowNotes
{
  std::vector<std::uint32_t> Columns;
  std::vector<std::uint8_t> Keys;
  std::vector<ExtractionPoint> Points;
  std::tuple<RowIds<vtkTypeInt32>, RowIds<vtkTypeInt64>> Ids;
};

class BitPass : public RowPass<BitPass, ContourLocal>
{
public:
  BitPass(ExtractionContext& context, const int dimensions[3], const GridWindow& window,
    ExtractionMesh& mesh)
    : RowPass(context, dimensions, window, mesh)
    , Item(context.Values->GetItems()[0])
    , Scalars(context.MakeScalars())
    , Slots(SlotPlace::FindAll(Table, *context.Values))
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
      BitKernels::CountOwned(around.GetOwners().data(), this->Nx, around.Kinds.IsAny());
    if (around.HasCells)
    {
      count.Simplices = this->CountCells(local, around);
    }
  }

  bool Settle() { return true; }

  void Allocate()
  {
    this->AllocateRows();
    // A point is in the output unless its simplices have collapsed, or are in cells left out.
    this->MarksUsed = this->Bits.HasSpecial();
    if (this->MarksUsed)
    {
      this->Mesh.Used.AllocateZeros(this->Offsets.back().Points);
    }
  }

  void WritePart(vtkIdType row, ContourLocal& local)
  {
    const RowCount& place = this->Offsets[row];
    const RowCount& next = this->Offsets[row + 1];
    const bool hasPoints = place.Points != next.Points;
    const bool hasTriangles = place.HasCells(next);
    if (!hasPoints && !hasTriangles)
    {
      return;
    }
    const Around around = this->Bits.GetAround(row);
    if (hasPoints)
    {
      this->WritePoints(local, around, place.Points, next.Points - place.Points);
    }
    if (hasTriangles)
    {
      this->Mesh.Simplices.Visit(
        [&](auto* ids) { this->WriteCells(local, around, place.Simplices, ids); });
    }
  }

  void Finish()
  {
    // The bytes of columns and keys, of the points of a row, of four rows of ids.
    constexpr std::size_t bytesOfColumn = sizeof(std::uint32_t) + sizeof(std::uint8_t) +
      Places * (sizeof(ExtractionPoint) + 4 * sizeof(vtkIdType));
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
      [&](vtkIdType column, const vtkIsotable::Case& found, TiedCases::Tied* tied)
      {
        const std::size_t number = tied ? tied->Cut.GetSimplices().size() : found.Simplices.size();
        local.Report.CollapsedSimplices += tied ? tied->Cut.GetNumberCollapsed() : 0;
        local.Report.CellsWithOutput += number > 0;
        local.Report.FoldedCells +=
          number > 0 && this->Orientation.IsFolded(this->Rows, firstPoint + column);
        triangles += static_cast<vtkIdType>(number);
      });
    return triangles;
  }

  // Calls visit(column, case, tied) for the cells of a row that the surface meets; tied is null
  // where the table's own cut serves.
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
      TiedCases::Tied* tied = nullptr;
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

  // Returns the cut of a cell where values equal the isovalue, or null where the table's serves.
  TiedCases::Tied* FindTied(ContourLocal& local, const Around& around, vtkIdType column,
    const vtkIsotable::Case& found) const
  {
    Code codes[Vertices];
    for (int v = 0; v < Vertices; ++v)
    {
      codes[v] = around.GetCode(column, v);
    }
    TiedCases::Tied& tied =
      local.TiedCases.Find(this->Table, this->Ranks, this->Item, 0, codes, found, false);
    return tied.IsMerged ? &tied : nullptr;
  }

  void WritePoints(ContourLocal& local, const Around& around, vtkIdType first, vtkIdType number)
  {
    around.Kinds.IsAny() ? this->MakePoints<true>(local, around)
                         : this->MakePoints<false>(local, around);
    if (this->MarksUsed && !around.MayLeavePoints())
    {
      std::for_each_n(this->Mesh.Used.GetData() + first, number,
        [](auto& mark) { mark.store(1, std::memory_order_relaxed); });
    }
    PointOutput::Write(
      this->Context, *this->Scalars, local.Points.data(), number, first, this->Mesh);
  }

  // Lists the points that a row owns. Each is written, whether it is there or not, and the next one
  // over it if not: which are there cannot be predicted.
  template <bool IsSpecial>
  void MakePoints(ContourLocal& local, const Around& around) const
  {
    local.Points.resize(Places * (this->Nx + 1));
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

  // Finds where the ids of each slot are for a row of cells.
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
      const SlotPlace& at = this->Slots[slot];
      rows.Slots[slot] = ids[at.Row] + Places * at.Column + at.Direction;
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
      row.Ids.resize(Places * this->Nx);
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
      [&](vtkIdType column, const vtkIsotable::Case& found, TiedCases::Tied* tied)
      {
        const auto& triangles = tied ? tied->Cut.GetSimplices() : found.Simplices;
        const bool isInverted = this->Orientation.IsInverted(this->Rows, firstPoint + column);
        const vtkIdType place = Places * column;
        for (const vtkIsotable::Simplex& corners : triangles)
        {
          out[isInverted] = slots[corners[0]][place];
          out[!isInverted] = slots[corners[1]][place];
          out[2] = slots[corners[2]][place];
          out += 3;
        }
        if (tied)
        {
          this->NoteTied(local, *tied, triangle);
        }
        this->Mesh.NoteSimplices(triangle, triangles.size(), 0, firstCell + column);
        triangle += static_cast<vtkIdType>(triangles.size());
      });
    const bool marks = this->MarksUsed &&
      std::any_of(around.Numbers.begin(), around.Numbers.end(),
        [this](vtkIdType row) { return this->Bits.GetAround(row).MayLeavePoints(); });
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

  // Notes the triangles that the neighbour of a cell may have turned over.
  void NoteTied(ContourLocal& local, TiedCases::Tied& tied, vtkIdType triangle) const
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
  std::vector<SlotPlace> Slots;
  CellOrientation Orientation;
  ComparedRows Bits;
  bool MarksUsed = false;
};
}

bool RowContour::IsSuited(const ExtractionContext& context)
{
  return context.Values->GetKind() == vtkIsotable::CONTOUR &&
    context.Values->GetItems().size() == 1 && !context.Whole && !context.TakeDuplicates &&
    !context.GenerateBoundaries;
}

bool RowContour::Execute(ExtractionContext& context, const int dimensions[3],
  const GridWindow& window, ExtractionMesh& mesh)
{
  return BitPass(context, dimensions, window, mesh).Execute();
}

}
