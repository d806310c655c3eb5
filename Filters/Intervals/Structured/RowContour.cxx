// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/RowContour.h"

#include "Common/ThreadLocals.h"
#include "Cuts/TiedCases.h"
#include "Grid/CellOrientation.h"
#include "Grid/RowIndex.h"
#include "Pass/ExtractionIndex.h"
#include "Scalars/BitKernels.h"
#include "Scalars/ExtractionScalars.h"
#include "Structured/PointOutput.h"
#include "Structured/SlotPlace.h"

#include <array>
#include <memory>
#include <vector>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;

constexpr int Vertices = 8;
// What a grid point may own: itself, and the crossings of its edges along i, j and k.
constexpr int Places = 4;

// The points of a row and the triangles of its cells: their numbers, then where they begin.
struct RowPlace
{
  vtkIdType Points = 0;
  vtkIdType Triangles = 0;
};

class Extractor
{
public:
  Extractor(ExtractionContext& context, const int dimensions[3], const GridWindow& window,
    ExtractionMesh& mesh)
    : Context(context)
    , Item(context.Values->GetItems()[0])
    , Scalars(context.MakeScalars())
    , Mesh(mesh)
    , Table(vtkIsotable::Get(vtkIsotable::CONTOUR, vtkIsotable::HEXAHEDRON))
    , Slots(SlotPlace::FindAll(Table, *context.Values))
    , Ranks(SlotPlace::FindRanks(Table))
    , Orientation(context.Input)
    , Rows(dimensions, window)
    , Nx(window.Last[0] - window.First[0] + 1)
    , Ny(window.Last[1] - window.First[1] + 1)
    , Nz(window.Last[2] - window.First[2] + 1)
  {
  }

  bool Execute()
  {
    const vtkIdType rows = this->Rows.GetNumberOfRows();
    this->FindActive(rows);
    this->Bits.Allocate(rows, this->Nx);
    const bool counted = this->Context.Run(rows, 0.0, 0.05,
                           [this](vtkIdType first, vtkIdType last)
                           {
                             for (vtkIdType row = first; row < last; ++row)
                             {
                               this->Compare(row);
                             }
                           }) &&
      this->Count(rows);
    if (!counted)
    {
      return false;
    }
    this->Allocate(rows);
    bool written = true;
    this->Mesh.Simplices.Visit([&](auto* ids) { written = this->Write(rows, ids); });
    this->GatherReport();
    return written;
  }

private:
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
  };

  // The buffers and counts of a thread.
  struct Local
  {
    std::vector<std::uint32_t> Columns;
    std::vector<std::uint8_t> Keys;
    std::vector<ExtractionPoint> Points;
    TiedCases Ties;
    std::vector<vtkIdType> TiedSimplices;
    vtkExtractionReport Report;
  };

  // The ids of what a row of grid points owns, Places for each point.
  template <typename Id>
  struct IdRow
  {
    vtkIdType Row = -1;
    std::vector<Id> Ids;
  };

  // The buffers of a thread that writes.
  template <typename Id>
  struct Writer
  {
    // By the last bits of k and j.
    std::array<std::array<IdRow<Id>, 2>, 2> Rows;
    // For each slot the id in the first cell of a row of cells, or null; those of the next cells
    // are Places further on.
    std::array<const Id*, vtkIsotable::MaximumNumberOfSlots> Slots{};
  };

  // Finds by the index, where there is one, which rows of points have to be compared: those around
  // rows of cells that may give output.
  void FindActive(vtkIdType rows)
  {
    if (!this->Context.Index)
    {
      return;
    }
    this->IsCompared.assign(rows, false);
    for (vtkIdType row = 0; row < rows; ++row)
    {
      const vtkIdType j = this->Rows.GetJ(row);
      const vtkIdType k = this->Rows.GetK(row);
      if (!this->MayGive(j, k))
      {
        continue;
      }
      for (int r = 0; r < 4; ++r)
      {
        this->IsCompared[this->Rows.GetRow(j + (r & 1), k + (r >> 1))] = true;
      }
    }
  }

  // Returns whether the cells at a row of points may give output.
  bool MayGive(vtkIdType j, vtkIdType k) const
  {
    return this->Rows.HasCells(j, k) &&
      (!this->Context.Index || this->Context.Index->IsRowActive(this->Rows.GetCellRow(j, k)));
  }

  bool IsRowCompared(vtkIdType row) const { return !this->Context.Index || this->IsCompared[row]; }

  void Compare(vtkIdType row)
  {
    if (this->IsRowCompared(row))
    {
      this->Bits.GetKinds(row) =
        this->Scalars->Compare(this->Rows.GetFirstPoint(row), this->Nx, this->Bits.GetRow(row));
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
        j < this->Ny && k < this->Nz && this->IsRowCompared(this->Rows.GetRow(j, k));
      around.Numbers[r] = isThere ? this->Rows.GetRow(j, k) : row;
      around.Rows[r] = this->Bits.GetRow(around.Numbers[r]);
      around.Kinds.Add(this->Bits.GetKinds(around.Numbers[r]));
    }
    return around;
  }

  // Counts what each row gives. Returns false when the user aborted.
  bool Count(vtkIdType rows)
  {
    this->Offsets.assign(rows + 1, RowPlace());
    return this->Context.Run(rows, 0.05, 0.4,
      [this](vtkIdType first, vtkIdType last)
      {
        Local& local = this->Locals.Local();
        local.Columns.resize(this->Nx);
        local.Keys.resize(this->Nx);
        for (vtkIdType row = first; row < last; ++row)
        {
          if (!this->IsRowCompared(row))
          {
            continue;
          }
          const Around around = this->GetAround(row);
          RowPlace& place = this->Offsets[row + 1];
          place.Points =
            BitKernels::CountOwned(around.GetOwners().data(), this->Nx, around.Kinds.IsAny());
          if (around.HasCells)
          {
            place.Triangles = this->CountCells(local, around);
          }
        }
      });
  }

  vtkIdType CountCells(Local& local, const Around& around) const
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
  void ForEachCell(Local& local, const Around& around, Visitor&& visit) const
  {
    const vtkIdType number =
      BitKernels::FindCells(around.Rows.data(), this->Nx, local.Columns.data(), local.Keys.data());
    for (vtkIdType c = 0; c < number; ++c)
    {
      const vtkIdType column = local.Columns[c];
      const vtkIsotable::Case& found = this->Table.GetCase(local.Keys[c]);
      TiedCases::Tied* tied = nullptr;
      if (around.Kinds.IsAny())
      {
        if (Has(around, &BitRows::Row::NonFinite, column))
        {
          continue;
        }
        if (Has(around, &BitRows::Row::Ties, column))
        {
          tied = this->FindTied(local, around, column, found);
        }
      }
      visit(column, found, tied);
    }
  }

  static bool IsSet(const BitRows::Word* words, vtkIdType column)
  {
    return (words[column / BitRows::BitsOfWord] >> (column % BitRows::BitsOfWord)) & 1;
  }

  // Returns whether a bit of any corner of a cell is set.
  static bool Has(const Around& around, BitRows::Word* BitRows::Row::*bits, vtkIdType column)
  {
    return std::any_of(around.Rows.begin(), around.Rows.end(),
      [=](const BitRows::Row& row)
      { return IsSet(row.*bits, column) || IsSet(row.*bits, column + 1); });
  }

  // Returns the cut of a cell where values equal the isovalue, or null where the table's serves.
  TiedCases::Tied* FindTied(
    Local& local, const Around& around, vtkIdType column, const vtkIsotable::Case& found) const
  {
    Code codes[Vertices];
    for (int v = 0; v < Vertices; ++v)
    {
      const BitRows::Row& row = around.Rows[v >> 1];
      const vtkIdType corner = column + (v & 1);
      codes[v] = !IsSet(row.Above, corner) ? 0 : IsSet(row.Ties, corner) ? 1 : 2;
    }
    TiedCases::Tied& tied =
      local.Ties.Find(this->Table, this->Ranks, this->Item, 0, codes, found, false);
    return tied.IsMerged ? &tied : nullptr;
  }

  // Turns the counts of rows into the places where they begin, and makes room for all.
  void Allocate(vtkIdType rows)
  {
    RowPlace total;
    BitRows::Kinds kinds;
    for (vtkIdType row = 0; row <= rows; ++row)
    {
      total.Points += this->Offsets[row].Points;
      total.Triangles += this->Offsets[row].Triangles;
      this->Offsets[row] = total;
      if (row < rows)
      {
        kinds.Add(this->Bits.GetKinds(row));
      }
    }
    // A point is in the output unless its simplices have collapsed, or are in cells left out.
    this->MarksUsed = kinds.IsAny();
    if (this->MarksUsed)
    {
      this->Mesh.Used.AllocateZeros(total.Points);
    }
    PointOutput::Allocate(this->Context, total.Points, this->Mesh);
    this->Mesh.Allocate(total.Points, total.Triangles, 3, 0, this->Context.KeepCellIds);
  }

  template <typename Id>
  bool Write(vtkIdType rows, Id* ids)
  {
    ThreadLocals<Writer<Id>> writers;
    return this->Context.Run(rows, 0.4, 0.8,
      [&](vtkIdType first, vtkIdType last)
      {
        Local& local = this->Locals.Local();
        local.Columns.resize(this->Nx);
        local.Keys.resize(this->Nx);
        Writer<Id>& writer = writers.Local();
        for (vtkIdType row = first; row < last; ++row)
        {
          const RowPlace& place = this->Offsets[row];
          const RowPlace& next = this->Offsets[row + 1];
          const bool hasPoints = place.Points != next.Points;
          const bool hasTriangles = place.Triangles != next.Triangles;
          if (hasPoints || hasTriangles)
          {
            const Around around = this->GetAround(row);
            if (hasPoints)
            {
              this->WritePoints(local, around, place.Points);
            }
            if (hasTriangles)
            {
              this->FindSlots(writer, around);
              this->WriteCells(local, around, writer, place.Triangles, ids);
            }
          }
        }
      });
  }

  // Calls visit(column, owned, bit) for the points of a row that own something; their bits in the
  // words of owned are at place bit.
  template <bool IsSpecial, typename Visitor>
  void ForEachOwner(const Around& around, Visitor&& visit) const
  {
    const auto rows = around.GetOwners();
    for (vtkIdType word = 0; word < BitRows::GetNumberOfWords(this->Nx); ++word)
    {
      const BitKernels::Owned owned = BitKernels::FindOwned<IsSpecial>(rows.data(), word, this->Nx);
      BitKernels::ForEach(owned.Points | owned.Edges[0] | owned.Edges[1] | owned.Edges[2],
        [&](int bit) { visit(word * BitRows::BitsOfWord + bit, owned, bit); });
    }
  }

  // Returns whether points that a row owns may be left without triangles. Where its own cells are
  // cut by the table, each of its crossings is in one of these.
  static bool MayLeavePoints(const Around& around)
  {
    return !around.HasCells || around.Kinds.IsAny();
  }

  void WritePoints(Local& local, const Around& around, vtkIdType first)
  {
    around.Kinds.IsAny() ? this->MakePoints<true>(local, around)
                         : this->MakePoints<false>(local, around);
    const vtkIdType number = this->Offsets[around.Numbers[0] + 1].Points - first;
    if (this->MarksUsed && !MayLeavePoints(around))
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
  void MakePoints(Local& local, const Around& around) const
  {
    local.Points.resize(Places * (this->Nx + 1));
    ExtractionPoint* out = local.Points.data();
    const vtkIdType firstPoint = this->Rows.GetFirstPoint(around.Numbers[0]);
    this->ForEachOwner<IsSpecial>(around,
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
  void FindSlots(Writer<Id>& writer, const Around& around)
  {
    std::array<const Id*, 4> ids;
    for (int r = 0; r < 4; ++r)
    {
      ids[r] = this->GetIds(writer, around.J + (r & 1), around.K + (r >> 1));
    }
    for (int slot = 0; slot < Vertices + this->Table.GetNumberOfEdges(); ++slot)
    {
      const SlotPlace& at = this->Slots[slot];
      writer.Slots[slot] = ids[at.Row] + Places * at.Column + at.Direction;
    }
  }

  template <typename Id>
  const Id* GetIds(Writer<Id>& writer, vtkIdType j, vtkIdType k)
  {
    IdRow<Id>& row = writer.Rows[k & 1][j & 1];
    const vtkIdType number = this->Rows.GetRow(j, k);
    if (row.Row != number)
    {
      row.Row = number;
      row.Ids.resize(Places * this->Nx);
      if (this->Offsets[number].Points != this->Offsets[number + 1].Points)
      {
        const Around around = this->GetAround(number);
        around.Kinds.IsAny() ? this->FillIds<true>(around, row.Ids.data())
                             : this->FillIds<false>(around, row.Ids.data());
      }
    }
    return row.Ids.data();
  }

  template <bool IsSpecial, typename Id>
  void FillIds(const Around& around, Id* ids) const
  {
    Id next = static_cast<Id>(this->Offsets[around.Numbers[0]].Points);
    this->ForEachOwner<IsSpecial>(around,
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

  template <typename Id>
  void WriteCells(
    Local& local, const Around& around, const Writer<Id>& writer, vtkIdType triangle, Id* ids)
  {
    const vtkIdType firstPoint = this->Rows.GetFirstPoint(around.Numbers[0]);
    const vtkIdType firstCell = this->Rows.GetFirstCell(around.J, around.K);
    const auto& slots = writer.Slots;
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
        [this](vtkIdType row) { return MayLeavePoints(this->GetAround(row)); });
    if (marks)
    {
      auto tied = local.TiedSimplices.begin() + firstTied;
      for (vtkIdType t = first; t < triangle; ++t)
      {
        if (tied != local.TiedSimplices.end() && *tied == t)
        {
          ++tied;
          continue;
        }
        std::for_each_n(ids + 3 * t, 3,
          [this](Id id) { this->Mesh.Used[id].store(1, std::memory_order_relaxed); });
      }
    }
  }

  // Notes the triangles that the neighbour of a cell may have turned over.
  void NoteTied(Local& local, TiedCases::Tied& tied, vtkIdType triangle) const
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

  void GatherReport()
  {
    std::size_t bytes = this->Offsets.capacity() * sizeof(RowPlace) + this->Bits.GetBytes() +
      this->Mesh.Points.GetBytes() + this->Mesh.Used.GetBytes();
    // The bytes of columns and keys, of the points of a row, of four rows of ids.
    constexpr std::size_t bytesOfColumn = sizeof(std::uint32_t) + sizeof(std::uint8_t) +
      Places * (sizeof(ExtractionPoint) + 4 * sizeof(vtkIdType));
    std::vector<vtkIdType>& tied = this->Mesh.TiedSimplices;
    for (const Local& local : this->Locals)
    {
      this->Context.Report->Add(local.Report);
      tied.insert(tied.end(), local.TiedSimplices.begin(), local.TiedSimplices.end());
      bytes += static_cast<std::size_t>(this->Nx) * bytesOfColumn;
    }
    vtkSMPTools::Sort(tied.begin(), tied.end());
    this->Context.NoteWorkingBytes(bytes);
  }

  ExtractionContext& Context;
  const ExtractionValues::Item& Item;
  std::unique_ptr<ExtractionScalars> Scalars;
  ExtractionMesh& Mesh;
  const vtkIsotable& Table;
  std::vector<SlotPlace> Slots;
  vtkIsotable::RankArray Ranks;
  CellOrientation Orientation;
  RowIndex Rows;
  vtkIdType Nx;
  vtkIdType Ny;
  vtkIdType Nz;
  // Which rows of points are compared; empty without an index, when all are.
  std::vector<bool> IsCompared;
  BitRows Bits;
  std::vector<RowPlace> Offsets;
  bool MarksUsed = false;
  ThreadLocals<Local> Locals;
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
  return Extractor(context, dimensions, window, mesh).Execute();
}

}
