// SPDX-License-Identifier: BSD-3-Clause
#include "Static/StructuredExtraction.h"

#include "Arrays/PointArrays.h"
#include "Common/ThreadLocals.h"
#include "Grid/CellOrientation.h"
#include "Grid/RowIndex.h"
#include "Grid/WholeCells.h"
#include "Scalars/CodeRow.h"
#include "Scalars/ExtractionKernels.h"
#include "Scalars/ExtractionScalars.h"
#include "Scalars/RowKernels.h"
#include "Static/ExtractionCell.h"
#include "Static/ExtractionIndex.h"
#include "Static/GhostCells.h"
#include "Static/RowContour.h"
#include "Static/TiedCases.h"

#include "vtkCellType.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkRectilinearGrid.h"

#include <atomic>
#include <type_traits>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;
using Slot = vtkIsotable::Slot;

// The place of a slot of the hexahedron's table in the rows around a cell.
struct SlotPlace
{
  Slot Row;       // of the owner: 0 (j,k), 1 (j+1,k), 2 (j,k+1), 3 (j+1,k+1)
  Slot Column;    // of the owner: 0 or 1
  Slot Direction; // 0: the grid point itself, 1, 2, 3: the edge along i, j, k
  Slot Kind;      // 0: lower, 1: upper isovalue
  Slot Ends[2];   // vertices of the cell
  bool MayFollow; // whether points of other isovalues may come before on the edge
};

std::vector<SlotPlace> FindSlotPlaces(const vtkIsotable& table, const ExtractionValues& values)
{
  const bool hasOneItem = values.GetItems().size() == 1;
  std::vector<SlotPlace> places;
  const auto add = [&places, hasOneItem](int a, int b, int direction, int kind)
  {
    places.push_back(
      { static_cast<Slot>(a >> 1), static_cast<Slot>(a & 1), static_cast<Slot>(direction),
        static_cast<Slot>(kind), { static_cast<Slot>(a), static_cast<Slot>(b) },
        direction != 0 && (kind == 1 || !hasOneItem) });
  };
  for (int v = 0; v < 8; ++v)
  {
    add(v, v, 0, 0);
  }
  for (int kind = 0; kind < 2; ++kind)
  {
    for (int e = 0; e < table.GetNumberOfEdges(); ++e)
    {
      const int a = table.GetEdge(e)[0];
      const int b = table.GetEdge(e)[1];
      add(a, b, b - a == 1 ? 1 : b - a == 2 ? 2 : 3, kind);
    }
  }
  return places;
}

// Returns the order of slots in rows, where a cell's vertices ascend.
vtkIsotable::RankArray FindRanks(const vtkIsotable& table)
{
  constexpr Slot ascending[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  return table.GetSlotRanks(ascending);
}

// The codes of all rows are kept where they take no more bytes than this; elsewhere a thread makes
// those that it needs, each several times.
constexpr std::size_t MostBytesOfCodes = std::size_t(1) << 26;
// Where an index leaves fewer rows to be looked at, only their codes are made, about four times.
constexpr double LeastShareOfRows = 0.25;

// A row of codes and the memory for them.
struct OwnCodeRow : CodeRow
{
  std::vector<Code> Memory;
};

// The columns [First, Last) of a row.
struct ColumnRange
{
  std::int64_t First;
  std::int64_t Last;
};

// The places where the output points that a row of grid points owns begin, relative to the row's
// first: those of a grid point at Starts, those of its edge along i, j, k by Offsets[0], [1], [2]
// further on.
struct OwnerRow
{
  vtkIdType Row = -1;
  // Only these columns own points; elsewhere the arrays mean nothing.
  ColumnRange Range = { 0, 0 };
  std::vector<std::uint32_t> Starts;
  std::array<std::vector<Code>, 3> Offsets;
  std::vector<Code> Counts;
};

// The bytes that these take for a grid point, and how many may be kept by a thread, so that they
// stay in its cache: rows are asked for again in the next layer.
constexpr std::size_t BytesOfOwner = sizeof(std::uint32_t) + 4 * sizeof(Code);
constexpr std::size_t MostBytesOfOwners = std::size_t(1) << 22;

// The counts of a row: points owned, simplices and boundary triangles of its cells; after summing,
// the places where those of the row begin.
struct RowCount
{
  vtkIdType Points = 0;
  vtkIdType Simplices = 0;
  vtkIdType Triangles = 0;
};

// The counts of a row of which some cells are passed on whole.
struct RowCountWithWhole : RowCount
{
  vtkIdType Whole = 0;
};

// Returns the type of cells in rows that are passed on: a voxel lies along the axes of space.
unsigned char GetTypeInRows(vtkDataSet* input)
{
  vtkImageData* image = vtkImageData::SafeDownCast(input);
  const bool isAlongAxes = image ? image->GetDirectionMatrix()->IsIdentity()
                                 : vtkRectilinearGrid::SafeDownCast(input) != nullptr;
  return isAlongAxes ? VTK_VOXEL : VTK_HEXAHEDRON;
}

template <bool KeepsWhole>
class Extractor
{
  using RowCount = std::conditional_t<KeepsWhole, RowCountWithWhole, interlume::RowCount>;

public:
  Extractor(ExtractionContext& context, const int dimensions[3], const GridWindow& window,
    bool hasBlanking, ExtractionMesh& mesh)
    : Context(context)
    , Values(*context.Values)
    , Scalars(ExtractionScalars::Make(context.Scalars, *context.Values))
    , Mesh(mesh)
    , Table(vtkIsotable::Get(context.Values->GetKind(), vtkIsotable::HEXAHEDRON))
    , Places(FindSlotPlaces(Table, *context.Values))
    , Ranks(FindRanks(Table))
    , Orientation(context.Input)
    , Rows(dimensions, window)
    , Nx(window.Last[0] - window.First[0] + 1)
    , Ny(window.Last[1] - window.First[1] + 1)
    , Nz(window.Last[2] - window.First[2] + 1)
    , HasBlanking(hasBlanking)
    , SimplexSize(context.GetSimplexSize())
    , KeyInside(static_cast<Code>(ExtractionCell::GetKeyInside(8)))
    , WholeType(GetTypeInRows(context.Input))
    , PointsBelow(1, 0)
    , Zeros(this->Nx, 0)
    , OwnerRows(static_cast<std::size_t>(2 * this->Nx * this->Ny) * BytesOfOwner > MostBytesOfOwners
          ? 2
          : this->Ny)
  {
    for (int code = 0; code <= this->Values.GetNonFiniteCode(); ++code)
    {
      this->PointsBelow.push_back(
        this->PointsBelow.back() + this->Values.IsPoint(static_cast<Code>(code)));
    }
  }

  bool Execute()
  {
    const vtkIdType rows = this->Rows.GetNumberOfRows();
    if (!this->MakeCodes(rows) || !this->Count(rows))
    {
      return false;
    }
    if (this->HasTiedGhost)
    {
      // What there is at the faces of a ghost cell follows from the cell too.
      this->Context.TakeDuplicates = true;
      for (Local& local : this->Locals)
      {
        local.Report = vtkExtractionReport();
      }
      if (!this->Count(rows))
      {
        return false;
      }
    }
    this->Allocate();
    const bool written = this->Context.Run(rows, 0.4, 0.8,
      [this](vtkIdType first, vtkIdType last) { this->ProcessRows<true>(first, last); });
    this->GatherReport();
    this->GatherTied(this->Mesh.TiedTriangles, &Local::TiedTriangles);
    this->GatherTied(this->Mesh.TiedSimplices, &Local::TiedSimplices);
    return written;
  }

private:
  // Makes the codes of all rows, where they are kept. Returns false when the user aborted.
  bool MakeCodes(vtkIdType rows)
  {
    const std::size_t points = static_cast<std::size_t>(rows * this->Nx);
    const bool areFewUsed =
      this->Context.Index && this->Context.Index->GetActiveShare() < LeastShareOfRows;
    if (areFewUsed || points * sizeof(Code) > MostBytesOfCodes)
    {
      return true;
    }
    this->AllCodes.Allocate(points);
    this->CodeRows.resize(rows);
    return this->Context.Run(rows, 0.0, 0.05,
      [this](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType row = first; row < last; ++row)
        {
          this->CodeRows[row].Fill(*this->Scalars, row, this->Rows.GetFirstPoint(row), this->Nx,
            this->AllCodes.GetData() + row * this->Nx);
        }
      });
  }

  // Counts what each row gives. Returns false when the user aborted.
  bool Count(vtkIdType rows)
  {
    this->Offsets.assign(rows + 1, RowCount());
    this->Columns.assign(rows, { 0, 0 });
    return this->Context.Run(rows, 0.05, 0.4,
      [this](vtkIdType first, vtkIdType last) { this->ProcessRows<false>(first, last); });
  }

  // The buffers and counts of a thread.
  struct Local
  {
    std::array<std::array<OwnCodeRow, 3>, 3> Codes;
    // Of two layers of rows, where they are kept whole, or else of two rows of each.
    std::array<std::vector<OwnerRow>, 2> Owners;
    std::vector<ExtractionPoint> Points;
    std::vector<Code> Columns;
    std::vector<Code> Keys;
    std::vector<std::uint8_t> Gave;
    // The columns [first, last) of the row of cells that give output.
    ColumnRange Given = { 0, 0 };
    std::vector<ExtractionIndex::Span> Spans;
    std::vector<ExtractionIndex::Span> Counted;
    interlume::TiedCases TiedCases;
    std::vector<vtkIdType> TiedTriangles;
    std::vector<vtkIdType> TiedSimplices;
    vtkExtractionReport Report;
    bool HasTies = false;
  };

  // Returns the codes of a row; a row of cells goes by the number of its first row of grid points.
  const CodeRow& GetCodes(Local& local, vtkIdType j, vtkIdType k) const
  {
    const vtkIdType number = this->Rows.GetRow(j, k);
    if (!this->CodeRows.empty())
    {
      return this->CodeRows[number];
    }
    OwnCodeRow& row = local.Codes[k % 3][j % 3];
    if (row.Row != number)
    {
      row.Memory.resize(this->Nx);
      row.Fill(
        *this->Scalars, number, this->Rows.GetFirstPoint(number), this->Nx, row.Memory.data());
    }
    return row;
  }

  // Finds the columns of points between which all that differs lies: outside of them the codes of
  // all rows are one and the same, and no output.
  template <std::size_t Number>
  ColumnRange GetRange(const std::array<const CodeRow*, Number>& rows) const
  {
    const Code front = rows[0]->Codes[0];
    const Code back = rows[0]->Codes[this->Nx - 1];
    bool isFrontEmpty = !this->Values.IsPoint(front);
    bool isBackEmpty = !this->Values.IsPoint(back);
    ColumnRange range{ this->Nx, -1 };
    for (const CodeRow* row : rows)
    {
      isFrontEmpty &= row->Codes[0] == front;
      isBackEmpty &= row->Codes[this->Nx - 1] == back;
      range.First = std::min(range.First, row->First);
      range.Last = std::max(range.Last, row->Last);
    }
    range.First = isFrontEmpty ? range.First - 1 : 0;
    range.Last = isBackEmpty ? std::min<std::int64_t>(range.Last + 2, this->Nx) : this->Nx;
    return range.First < range.Last ? range : ColumnRange{ 0, 0 };
  }

  const OwnerRow& GetOwners(Local& local, vtkIdType j, vtkIdType k) const
  {
    std::vector<OwnerRow>& layer = local.Owners[k & 1];
    layer.resize(this->OwnerRows);
    OwnerRow& owners = layer[j % this->OwnerRows];
    if (owners.Row == this->Rows.GetRow(j, k))
    {
      return owners;
    }
    owners.Row = this->Rows.GetRow(j, k);
    const auto rows = this->GetOwnerCodes(local, j, k);
    owners.Range = this->GetRange(rows);
    if (owners.Range.First == owners.Range.Last)
    {
      return owners;
    }
    owners.Starts.resize(this->Nx + 1);
    owners.Counts.resize(this->Nx + 1);
    for (auto& offsets : owners.Offsets)
    {
      offsets.resize(this->Nx);
    }
    this->CountOwned(*rows[0], *rows[1], *rows[2], owners);
    ExtractionKernels::FillStarts(owners.Counts.data() + owners.Range.First,
      owners.Range.Last - owners.Range.First, owners.Starts.data() + owners.Range.First);
    return owners;
  }

  // Returns the codes that tell what a row of grid points owns: its own, and those of the next rows
  // along j and k.
  std::array<const CodeRow*, 3> GetOwnerCodes(Local& local, vtkIdType j, vtkIdType k) const
  {
    const CodeRow* here = &this->GetCodes(local, j, k);
    return { { here, j + 1 < this->Ny ? &this->GetCodes(local, j + 1, k) : here,
      k + 1 < this->Nz ? &this->GetCodes(local, j, k + 1) : here } };
  }

  // Returns how many points a row of grid points owns.
  vtkIdType CountPoints(Local& local, vtkIdType j, vtkIdType k) const
  {
    const auto rows = this->GetOwnerCodes(local, j, k);
    const ColumnRange range = this->GetRange(rows);
    if (range.First == range.Last)
    {
      return 0;
    }
    const vtkIdType number = range.Last - range.First;
    const Code* const codes[] = { rows[0]->Codes + range.First, rows[1]->Codes + range.First,
      rows[2]->Codes + range.First };
    const vtkIdType points = this->CountOwnPoints(*rows[0], codes[0], number);
    if (rows[0]->IsFinite && rows[1]->IsFinite && rows[2]->IsFinite)
    {
      return points + RowKernels::CountCrossings(codes[0], codes[1], codes[2], number);
    }
    vtkIdType crossings = 0;
    for (vtkIdType i = 0; i < number; ++i)
    {
      const Code* const here = codes[0] + i;
      crossings += this->Values.CountCrossings(*here, here[i + 1 < number ? 1 : 0]) +
        this->Values.CountCrossings(*here, codes[1][i]) +
        this->Values.CountCrossings(*here, codes[2][i]);
    }
    return points + crossings;
  }

  // Returns how many of the grid points of a row are points of the output.
  vtkIdType CountOwnPoints(const CodeRow& row, const Code* codes, vtkIdType number) const
  {
    const int points = this->CountCodesOfPoints(row);
    if (points == 0 || points == row.Maximum + 1 - row.Minimum)
    {
      return points == 0 ? 0 : number;
    }
    return std::count_if(
      codes, codes + number, [this](Code code) { return this->Values.IsPoint(code); });
  }

  // Returns how many of the codes between the least and the greatest of a row are of points of the
  // output.
  int CountCodesOfPoints(const CodeRow& row) const
  {
    return this->PointsBelow[row.Maximum + 1] - this->PointsBelow[row.Minimum];
  }

  void CountOwned(
    const CodeRow& here, const CodeRow& along, const CodeRow& above, OwnerRow& owners) const
  {
    const vtkIdType begin = owners.Range.First;
    const vtkIdType number = owners.Range.Last - begin;
    const Code* c = here.Codes + begin;
    const Code* alongJ = along.Codes + begin;
    const Code* alongK = above.Codes + begin;
    Code* first = owners.Offsets[0].data() + begin;
    Code* second = owners.Offsets[1].data() + begin;
    Code* third = owners.Offsets[2].data() + begin;
    Code* all = owners.Counts.data() + begin;
    this->FindPoints(here, c, number, first);
    if (here.IsFinite && along.IsFinite && above.IsFinite)
    {
      RowKernels::CountOwned(c, alongJ, alongK, number, first, second, third, all);
      return;
    }
    for (vtkIdType i = 0; i < number; ++i)
    {
      const Code next = i + 1 < number ? c[i + 1] : c[i];
      second[i] = static_cast<Code>(first[i] + this->Values.CountCrossings(c[i], next));
      third[i] = static_cast<Code>(second[i] + this->Values.CountCrossings(c[i], alongJ[i]));
      all[i] = static_cast<Code>(third[i] + this->Values.CountCrossings(c[i], alongK[i]));
    }
  }

  // Notes which grid points are points of the output. Mostly none of a row is, or all are.
  void FindPoints(const CodeRow& row, const Code* codes, vtkIdType number, Code* arePoints) const
  {
    const int points = this->CountCodesOfPoints(row);
    if (points == 0 || points == row.Maximum + 1 - row.Minimum)
    {
      std::fill_n(arePoints, number, static_cast<Code>(points != 0));
      return;
    }
    for (vtkIdType i = 0; i < number; ++i)
    {
      arePoints[i] = this->Values.IsPoint(codes[i]);
    }
  }

  template <bool Write>
  void ProcessRows(vtkIdType first, vtkIdType last)
  {
    Local& local = this->Locals.Local();
    const bool hasTiedGhost = this->HasTiedGhost;
    for (vtkIdType row = first; row < last && this->HasTiedGhost == hasTiedGhost; ++row)
    {
      const vtkIdType j = this->Rows.GetJ(row);
      const vtkIdType k = this->Rows.GetK(row);
      const ExtractionIndex* index = this->Context.Index;
      if (index && !index->IsRowActive(this->Rows.GetCellRow(j, k)))
      {
        continue;
      }
      RowCount place;
      if (Write)
      {
        place = this->Offsets[row];
        this->WritePoints(local, row);
      }
      else
      {
        const CodeRow& codes = this->GetCodes(local, j, k);
        place.Points = this->CountPoints(local, j, k);
        local.HasTies |= codes.HasTies || !codes.IsFinite;
      }
      if (this->Rows.HasCells(j, k))
      {
        this->ProcessCells<Write>(local, row, place);
      }
      if (!Write)
      {
        this->Offsets[row + 1] = place;
      }
    }
  }

  // Turns the counts of rows into the places where they begin, and makes room for all.
  void Allocate()
  {
    RowCount total;
    for (RowCount& count : this->Offsets)
    {
      total.Points += count.Points;
      total.Simplices += count.Simplices;
      total.Triangles += count.Triangles;
      if constexpr (KeepsWhole)
      {
        total.Whole += count.Whole;
      }
      count = total;
    }
    if (this->Context.Arrays)
    {
      this->Context.Arrays->Allocate(total.Points);
    }
    else
    {
      this->Mesh.Points.Allocate(total.Points);
    }
    vtkIdType whole = 0;
    if constexpr (KeepsWhole)
    {
      whole = total.Whole;
    }
    this->Mesh.Allocate(total.Points, total.Simplices, this->SimplexSize, total.Triangles,
      this->Context.KeepCellIds, whole, 8 * whole);
    // A point is in the output unless its cells are blanked or its simplices have collapsed.
    const bool hasTies = std::any_of(
      this->Locals.begin(), this->Locals.end(), [](const Local& local) { return local.HasTies; });
    this->MarksUsed = hasTies || this->HasBlanking || this->Values.HasFlatItem();
    if (this->MarksUsed)
    {
      this->Mesh.Used.AllocateZeros(total.Points);
    }
  }

  // Marks the points of some slots as used; apart from other work, since a compiler has to think
  // that a mark may change anything.
  void Use(const Slot* slots, std::size_t number, const vtkIdType* ids)
  {
    std::atomic<unsigned char>* used = this->MarksUsed ? this->Mesh.Used.GetData() : nullptr;
    for (std::size_t s = 0; used && s < number; ++s)
    {
      used[ids[slots[s]]].store(1, std::memory_order_relaxed);
    }
  }

  void Use(vtkIdType point)
  {
    if (this->MarksUsed)
    {
      this->Mesh.Used[point].store(1, std::memory_order_relaxed);
    }
  }

  void GatherReport()
  {
    std::size_t bytes = this->Offsets.capacity() * sizeof(RowCount) +
      this->Columns.capacity() * sizeof(this->Columns[0]) + this->Mesh.Points.GetBytes() +
      this->AllCodes.GetBytes() + this->CodeRows.capacity() * sizeof(CodeRow) +
      this->Mesh.Used.GetBytes();
    // The bytes of nine rows of codes; of rows of owners; of columns, keys and marks.
    const std::size_t bytesOfColumn =
      9 * sizeof(Code) + 2 * static_cast<std::size_t>(this->OwnerRows) * BytesOfOwner + 5;
    for (const Local& local : this->Locals)
    {
      this->Context.Report->Add(local.Report);
      bytes += static_cast<std::size_t>(this->Nx) * bytesOfColumn +
        local.Points.capacity() * sizeof(ExtractionPoint);
    }
    this->Context.NoteWorkingBytes(bytes);
  }

  // Gathers what threads have noted, in ascending order.
  void GatherTied(std::vector<vtkIdType>& all, std::vector<vtkIdType> Local::*noted)
  {
    for (const Local& local : this->Locals)
    {
      all.insert(all.end(), (local.*noted).begin(), (local.*noted).end());
    }
    vtkSMPTools::Sort(all.begin(), all.end());
  }

  // Writes the crossings of an edge. The first is written, whether it is there or not, and the next
  // one over it if not: which are there cannot be predicted.
  static void WriteCrossings(
    vtkIdType a, vtkIdType b, Code codeA, Code codeB, int number, ExtractionPoint*& out)
  {
    const int first = ExtractionValues::GetFirstCrossing(codeA, codeB);
    *out = { a, b, static_cast<double>(first) };
    for (int k = 1; k < number; ++k)
    {
      out[k] = { a, b, static_cast<double>(first + k) };
    }
    out += number;
  }

  void WritePoints(Local& local, vtkIdType row)
  {
    if (this->Offsets[row].Points == this->Offsets[row + 1].Points)
    {
      return;
    }
    const vtkIdType j = this->Rows.GetJ(row);
    const vtkIdType k = this->Rows.GetK(row);
    const OwnerRow& owners = this->GetOwners(local, j, k);
    const vtkIdType place = this->Offsets[row].Points;
    const vtkIdType number = this->Offsets[row + 1].Points - place;
    // There is room for one more, which is written but not there.
    if (local.Points.size() <= static_cast<std::size_t>(number))
    {
      local.Points.resize(number + 1);
    }
    ExtractionPoint* const begin = local.Points.data();
    ExtractionPoint* out = begin;
    const auto rows = this->GetOwnerCodes(local, j, k);
    const Code* here = rows[0]->Codes;
    const Code* along = rows[1]->Codes;
    const Code* above = rows[2]->Codes;
    const vtkIdType first = this->Rows.GetFirstPoint(row);
    for (vtkIdType i = owners.Range.First; i < owners.Range.Last; ++i)
    {
      if (owners.Counts[i] == 0)
      {
        i = ExtractionKernels::FindChange(owners.Counts.data(), i, owners.Range.Last) - 1;
        continue;
      }
      const vtkIdType id = first + i;
      const Code own = owners.Offsets[0][i];
      const Code all = owners.Counts[i];
      *out = { id, id, 0.0 };
      out += own;
      // Most points own nothing else.
      if (all != own)
      {
        const Code second = owners.Offsets[1][i];
        const Code third = owners.Offsets[2][i];
        WriteCrossings(id, id + 1, here[i], here[i + 1 < this->Nx ? i + 1 : i], second - own, out);
        WriteCrossings(id, id + this->Rows.GetStep(1), here[i], along[i], third - second, out);
        WriteCrossings(id, id + this->Rows.GetStep(2), here[i], above[i], all - third, out);
      }
    }
    this->Scalars->Place(begin, number);
    if (this->Context.Arrays)
    {
      this->Context.Arrays->Write(begin, number, place);
    }
    else
    {
      std::copy_n(begin, number, this->Mesh.Points.GetData() + place);
    }
  }

  // The place where the ids of a slot's points begin, and how they go on along a row of cells.
  struct SlotRow
  {
    vtkIdType First;
    const std::uint32_t* Starts;
    const Code* Offsets;
  };

  // The rows around a row of cells, in the order of SlotPlace::Row.
  struct Around
  {
    vtkIdType J;
    vtkIdType K;
    vtkIdType FirstPoint; // of the cell at column 0
    vtkIdType FirstCell;
    const Code* Codes[4];
    SlotRow Slots[vtkIsotable::MaximumNumberOfSlots];
    bool HasTies = false;
    bool IsFinite = true;
  };

  template <bool Write>
  void ProcessCells(Local& local, vtkIdType row, RowCount& place)
  {
    const RowCount& here = this->Offsets[row];
    const RowCount& next = this->Offsets[row + 1];
    if (Write && here.Simplices == next.Simplices && here.Triangles == next.Triangles &&
      !HasWhole(here, next))
    {
      return;
    }
    local.Spans.clear();
    if (Write)
    {
      local.Spans.push_back({ this->Columns[row].First, this->Columns[row].Last });
    }
    else if (this->Context.Index)
    {
      this->Context.Index->GetActiveSpans(
        this->Rows.GetCellRow(this->Rows.GetJ(row), this->Rows.GetK(row)), local.Spans);
    }
    else
    {
      local.Spans.push_back({ 0, this->Nx - 1 });
    }
    this->ProcessRow<Write>(local, row, place);
    if (!Write)
    {
      this->Columns[row] = local.Given;
    }
  }

  // Returns whether the row between two places has cells that are passed on whole.
  static bool HasWhole(const RowCount& here, const RowCount& next)
  {
    if constexpr (KeepsWhole)
    {
      return here.Whole != next.Whole;
    }
    else
    {
      return false;
    }
  }

  template <bool Write>
  void ProcessRow(Local& local, vtkIdType row, RowCount& place)
  {
    Around around;
    around.J = this->Rows.GetJ(row);
    around.K = this->Rows.GetK(row);
    around.FirstPoint = this->Rows.GetFirstPoint(row);
    around.FirstCell = this->Rows.GetFirstCell(around.J, around.K);
    Code minimum = std::numeric_limits<Code>::max();
    Code maximum = 0;
    std::array<const CodeRow*, 4> rows;
    for (int r = 0; r < 4; ++r)
    {
      const vtkIdType j = around.J + (r & 1);
      const vtkIdType k = around.K + (r >> 1);
      const CodeRow& codes = this->GetCodes(local, j, k);
      around.Codes[r] = codes.Codes;
      around.HasTies |= codes.HasTies;
      around.IsFinite &= codes.IsFinite;
      minimum = std::min(minimum, codes.Minimum);
      maximum = std::max(maximum, codes.Maximum);
      rows[r] = &codes;
    }
    // The rows of owners come after all codes, since they reach further: only now may the places of
    // codes change.
    if (Write)
    {
      this->FindSlotRows(local, around);
      if (this->HasBlanking)
      {
        this->CutBlanked(local, around);
      }
    }
    local.Given = { 0, 0 };
    if (!Write)
    {
      this->CountInput(local, around);
      const ColumnRange range = this->GetRange(rows);
      if (range.First == range.Last)
      {
        return;
      }
      this->Trim(range, local.Spans);
      local.Gave.assign(this->Nx, 0);
    }
    const auto& items = this->Values.GetItems();
    for (std::size_t item = 0; item < items.size(); ++item)
    {
      if (!this->Values.IsOutside(items[item], minimum, maximum) || !around.IsFinite)
      {
        this->ProcessItem<Write>(local, around, static_cast<int>(item), place);
      }
    }
    if (!Write)
    {
      local.Report.CellsWithOutput += std::count(local.Gave.begin(), local.Gave.end(), 1);
    }
  }

  void FindSlotRows(Local& local, Around& around) const
  {
    const OwnerRow* owners[4];
    vtkIdType firsts[4];
    for (int r = 0; r < 4; ++r)
    {
      const vtkIdType j = around.J + (r & 1);
      const vtkIdType k = around.K + (r >> 1);
      owners[r] = &this->GetOwners(local, j, k);
      firsts[r] = this->Offsets[this->Rows.GetRow(j, k)].Points;
    }
    for (std::size_t slot = 0; slot < this->Places.size(); ++slot)
    {
      const SlotPlace& at = this->Places[slot];
      const OwnerRow& owner = *owners[at.Row];
      // A row that owns nothing has no arrays, and its slots no points.
      const vtkIdType column = owner.Starts.empty() ? 0 : at.Column;
      around.Slots[slot] = { firsts[at.Row], owner.Starts.data() + column,
        at.Direction == 0 ? this->Zeros.data() : owner.Offsets[at.Direction - 1].data() + column };
    }
  }

  // Leaves the cells between the columns of points in range.
  static void Trim(const ColumnRange& range, std::vector<ExtractionIndex::Span>& spans)
  {
    for (auto& span : spans)
    {
      span[0] = std::max<vtkIdType>(span[0], range.First);
      span[1] = std::max<vtkIdType>(span[0], std::min<vtkIdType>(span[1], range.Last - 1));
    }
  }

  bool IsFinite(const Around& around, vtkIdType i) const
  {
    const Code nonFinite = this->Values.GetNonFiniteCode();
    for (const Code* codes : around.Codes)
    {
      if (codes[i] == nonFinite || codes[i + 1] == nonFinite)
      {
        return false;
      }
    }
    return true;
  }

  bool IsBlanked(const Around& around, vtkIdType i) const
  {
    if (this->Context.IsCellLeftOut(around.FirstCell + i))
    {
      return true;
    }
    for (int v = 0; this->Context.PointGhosts && v < 8; ++v)
    {
      if (this->Context.IsPointBlanked(this->Rows.GetVertex(around.FirstPoint + i, v)))
      {
        return true;
      }
    }
    return false;
  }

  // Leaves blanked cells out of the columns; returns how many there were. Notes whether one is
  // another piece's cell and tied.
  vtkIdType CutBlanked(Local& local, const Around& around)
  {
    vtkIdType number = 0;
    local.Counted.clear();
    for (const auto& span : local.Spans)
    {
      for (vtkIdType i = span[0]; i < span[1];)
      {
        const vtkIdType first = i;
        i = this->FindBlanked(around, first, span[1]);
        if (first < i)
        {
          local.Counted.push_back({ first, i });
        }
        for (; i < span[1] && this->IsBlanked(around, i); ++i)
        {
          ++number;
          if (around.HasTies && GhostCells::IsOne(this->Context, around.FirstCell + i) &&
            this->HasTiedPoints(around, i))
          {
            this->HasTiedGhost = true;
          }
        }
      }
    }
    local.Spans.swap(local.Counted);
    return number;
  }

  // Returns the first blanked cell of [first, last), or last.
  vtkIdType FindBlanked(const Around& around, vtkIdType first, vtkIdType last) const
  {
    while (first < last && !this->IsBlanked(around, first))
    {
      const vtkIdType next = around.FirstCell + first + 1;
      first = this->Context.PointGhosts
        ? first + 1
        : this->Context.FindMarkedCell(next, around.FirstCell + last) - around.FirstCell;
    }
    return first;
  }

  void CountInput(Local& local, const Around& around)
  {
    for (const auto& span : local.Spans)
    {
      local.Report.CellsVisited += span[1] - span[0];
    }
    if (this->HasBlanking)
    {
      local.Report.BlankedCells += this->CutBlanked(local, around);
    }
    for (const auto& span : local.Spans)
    {
      for (vtkIdType i = span[0]; i < span[1] && !around.IsFinite; ++i)
      {
        local.Report.NonFiniteCells += !this->IsFinite(around, i);
      }
    }
  }

  void FillKeys(Local& local, const Around& around, const ExtractionValues::Item& item) const
  {
    local.Columns.resize(this->Nx);
    local.Keys.resize(this->Nx);
    for (const auto& span : local.Spans)
    {
      const vtkIdType first = span[0];
      const Code* const rows[4] = { around.Codes[0] + first, around.Codes[1] + first,
        around.Codes[2] + first, around.Codes[3] + first };
      RowKernels::FillKeys(this->Values.GetBase(), rows, item.First, item.Second, span[1] - first,
        local.Columns.data() + first, local.Keys.data() + first);
    }
  }

  // The cell inside of an interval that was written last in a row.
  struct CellInside
  {
    vtkIdType Column = -1;
    vtkIdType Corners[8] = {};
    bool IsInverted = false;
  };

  template <bool Write>
  void ProcessItem(Local& local, const Around& around, int item, RowCount& place)
  {
    CellInside inside;
    const auto& what = this->Values.GetItems()[item];
    this->FillKeys(local, around, what);
    const Code last = static_cast<Code>(this->Table.GetNumberOfCases() - 1);
    const bool hasTies = around.HasTies || what.IsFlat;
    for (const auto& span : local.Spans)
    {
      for (vtkIdType i = span[0]; i < span[1]; ++i)
      {
        const Code key = local.Keys[i];
        if (key == 0 || key == last)
        {
          i = ExtractionKernels::FindChange(local.Keys.data(), i, span[1]) - 1;
          continue;
        }
        if (!around.IsFinite && !this->IsFinite(around, i))
        {
          continue;
        }
        if constexpr (KeepsWhole)
        {
          if (key == this->KeyInside && this->MayBeWhole(around, i))
          {
            this->ProcessWhole<Write>(local, around, i, item, place);
            continue;
          }
        }
        const vtkIsotable::Case& found = this->Table.GetCase(key);
        const vtkIdType end = key == this->KeyInside && !KeepsWhole && !what.IsFlat
          ? this->FindEndInside(local, around, i, span[1])
          : i;
        if (end > i)
        {
          this->ProcessInside<Write>(local, around, { i, end }, item, found, inside, place);
          i = end - 1;
          continue;
        }
        const RowCount before = place;
        const bool isTied = hasTies && this->HasTiedPoints(around, i, what.IsFlat) &&
          this->ProcessTies<Write>(local, around, i, item, found, place);
        if (!isTied && Write)
        {
          this->WriteCell(around, i, item, found, place);
        }
        else if (!isTied)
        {
          place.Simplices += found.Simplices.size();
          place.Triangles += this->Context.GenerateBoundaries ? found.Boundary.size() : 0;
        }
        if (!Write && place.Simplices != before.Simplices)
        {
          this->NoteGiven(local, { i, i + 1 }, 1);
        }
        else if (!Write && place.Triangles != before.Triangles)
        {
          this->NoteGiven(local, { i, i + 1 }, std::max<std::uint8_t>(local.Gave[i], 2));
        }
      }
    }
  }

  // Returns the end of the cells from \a first on that are inside of an interval, finite and not
  // tied.
  vtkIdType FindEndInside(
    const Local& local, const Around& around, vtkIdType first, vtkIdType last) const
  {
    const vtkIdType end =
      around.IsFinite ? ExtractionKernels::FindChange(local.Keys.data(), first, last) : first + 1;
    if (!around.HasTies)
    {
      return end;
    }
    // A cell ends at the column after it.
    const vtkIdType tie = ExtractionKernels::FindOdd(around.Codes, first, end + 1);
    return tie > end ? end : std::max(first, tie - 1);
  }

  // Counts or writes cells inside of an interval. Without ties they have no boundary.
  template <bool Write>
  void ProcessInside(Local& local, const Around& around, const ColumnRange& cells, int item,
    const vtkIsotable::Case& found, CellInside& inside, RowCount& place)
  {
    if (!Write)
    {
      place.Simplices += (cells.Last - cells.First) * found.Simplices.size();
      this->NoteGiven(local, cells, 1);
      return;
    }
    for (vtkIdType i = cells.First; i < cells.Last;)
    {
      this->WriteInside(around, i, item, found, inside, place);
      const vtkIdType next =
        this->Orientation.IsPerCell() ? i + 1 : FindBreak(around, i, cells.Last);
      this->WriteRun(around, { i + 1, next }, item, found.Simplices.size(), inside, place);
      i = next;
    }
  }

  // Notes that cells give output.
  static void NoteGiven(Local& local, const ColumnRange& cells, std::uint8_t mark)
  {
    std::fill(local.Gave.begin() + cells.First, local.Gave.begin() + cells.Last, mark);
    const bool isFirst = local.Given.First == local.Given.Last;
    local.Given = { isFirst ? cells.First : std::min(local.Given.First, cells.First),
      isFirst ? cells.Last : std::max(local.Given.Last, cells.Last) };
  }

  // Returns whether no criterion leaves a corner of a cell out.
  bool MayBeWhole(const Around& around, vtkIdType i) const
  {
    for (int v = 0; v < 8; ++v)
    {
      if (!this->Context.Whole->MayHave(this->Rows.GetVertex(around.FirstPoint + i, v)))
      {
        return false;
      }
    }
    return true;
  }

  // Counts or writes a cell that is passed on whole.
  template <bool Write>
  void ProcessWhole(Local& local, const Around& around, vtkIdType i, int item, RowCount& place)
  {
    if (Write)
    {
      vtkIdType ids[8];
      for (int v = 0; v < 8; ++v)
      {
        // The points of a hexahedron go around its faces.
        const int corner = this->WholeType == VTK_HEXAHEDRON ? v ^ ((v >> 1) & 1) : v;
        const SlotRow& row = around.Slots[corner];
        ids[v] = row.First + row.Starts[i];
        this->Use(ids[v]);
      }
      this->Mesh.WriteWhole(
        place.Whole, 8 * place.Whole, this->WholeType, ids, 8, item, around.FirstCell + i);
    }
    else
    {
      this->NoteGiven(local, { i, i + 1 }, 1);
    }
    ++place.Whole;
  }

  bool HasTiedPoints(const Around& around, vtkIdType i, Code ties = 0) const
  {
    for (const Code* codes : around.Codes)
    {
      ties |= codes[i] | codes[i + 1];
    }
    return ExtractionValues::IsTie(ties);
  }

  // Returns the output id of a slot.
  vtkIdType GetId(
    const Around& around, vtkIdType i, const ExtractionValues::Item& item, Slot slot) const
  {
    const SlotPlace& at = this->Places[slot];
    const SlotRow& row = around.Slots[slot];
    const vtkIdType id = row.First + row.Starts[i] + row.Offsets[i];
    if (!at.MayFollow)
    {
      return id;
    }
    return id + (at.Kind == 0 ? item.Lower : item.Upper) -
      ExtractionValues::GetFirstCrossing(
        GetCode(around, i, at.Ends[0]), GetCode(around, i, at.Ends[1]));
  }

  static Code GetCode(const Around& around, vtkIdType i, int vertex)
  {
    return around.Codes[vertex >> 1][i + (vertex & 1)];
  }

  void GetCodes(const Around& around, vtkIdType i, Code* codes) const
  {
    for (int v = 0; v < 8; ++v)
    {
      codes[v] = GetCode(around, i, v);
    }
  }

  bool IsInverted(const Around& around, vtkIdType i) const
  {
    if (!this->Orientation.IsPerCell())
    {
      return this->Orientation.AreAllInverted();
    }
    vtkIdType vertices[8];
    for (int v = 0; v < 8; ++v)
    {
      vertices[v] = this->Rows.GetVertex(around.FirstPoint + i, v);
    }
    return this->Orientation.IsInverted(vtkIsotable::HEXAHEDRON, vertices);
  }

  void WriteCell(
    const Around& around, vtkIdType i, int item, const vtkIsotable::Case& found, RowCount& place)
  {
    const auto& what = this->Values.GetItems()[item];
    vtkIdType ids[vtkIsotable::MaximumNumberOfSlots];
    for (const Slot slot : found.Slots)
    {
      ids[slot] = this->GetId(around, i, what, slot);
    }
    this->Use(found.Slots.data(), found.Slots.size(), ids);
    const bool isInverted = this->IsInverted(around, i);
    const std::size_t number = found.Simplices.size();
    this->Mesh.Simplices.Write(place.Simplices, found.Simplices.data(), number, ids, isInverted);
    this->Mesh.NoteSimplices(place.Simplices, number, item, around.FirstCell + i);
    place.Simplices += static_cast<vtkIdType>(number);
    for (std::size_t t = 0; this->Context.GenerateBoundaries && t < found.Boundary.size(); ++t)
    {
      this->WriteTriangle(around, i, item, found.Boundary[t], ids, isInverted, place);
    }
  }

  // Writes a cell inside of an interval. Along a row of such cells each point's id is mostly one
  // more than that of the cell before, and so are those of the simplices.
  void WriteInside(const Around& around, vtkIdType i, int item, const vtkIsotable::Case& found,
    CellInside& before, RowCount& place)
  {
    const bool isInverted = this->IsInverted(around, i);
    bool isNext = before.Column + 1 == i && before.IsInverted == isInverted;
    for (int v = 0; v < 8; ++v)
    {
      const vtkIdType id = around.Slots[v].First + around.Slots[v].Starts[i];
      isNext &= id == before.Corners[v] + 1;
      before.Corners[v] = id;
    }
    before.Column = i;
    before.IsInverted = isInverted;
    const std::size_t number = found.Simplices.size();
    this->Use(found.Slots.data(), found.Slots.size(), before.Corners);
    if (isNext)
    {
      this->Mesh.Simplices.WriteNext(place.Simplices, number, 1);
    }
    else
    {
      this->Mesh.Simplices.Write(
        place.Simplices, found.Simplices.data(), number, before.Corners, isInverted);
    }
    this->Mesh.NoteSimplices(place.Simplices, number, item, around.FirstCell + i);
    place.Simplices += static_cast<vtkIdType>(number);
  }

  // Returns the end of the cells inside after the first each of whose points has an id one more
  // than that of the cell before.
  static vtkIdType FindBreak(const Around& around, vtkIdType first, vtkIdType last)
  {
    // Vertices 0, 2, 4 and 6 are at the columns' beginnings, in the four rows.
    const std::uint32_t* starts[4];
    for (int r = 0; r < 4; ++r)
    {
      starts[r] = around.Slots[2 * r].Starts;
    }
    const auto isNext = [&starts](vtkIdType i)
    {
      return starts[0][i] == starts[0][i - 1] + 1 && starts[1][i] == starts[1][i - 1] + 1 &&
        starts[2][i] == starts[2][i - 1] + 1 && starts[3][i] == starts[3][i - 1] + 1;
    };
    vtkIdType i = first + 1;
    while (i <= last && isNext(i))
    {
      ++i;
    }
    // The last cell's points end a column later.
    return std::max(first + 1, i - 1);
  }

  // Writes cells inside of an interval that follow one, where each id is one more than that of the
  // cell before.
  void WriteRun(const Around& around, const ColumnRange& cells, int item, std::size_t number,
    CellInside& before, RowCount& place)
  {
    const vtkIdType length = cells.Last - cells.First;
    if (length == 0)
    {
      return;
    }
    this->Mesh.Simplices.WriteNext(place.Simplices, number, length);
    this->Mesh.NoteRun(place.Simplices, number, length, item, around.FirstCell + cells.First);
    place.Simplices += static_cast<vtkIdType>(number) * length;
    before.Column += length;
    // The last cell's points end a column later; each row's are those of two corners.
    for (int v = 0; this->MarksUsed && v < 8; v += 2)
    {
      for (vtkIdType id = before.Corners[v] + 1; id <= before.Corners[v] + length + 1; ++id)
      {
        this->Use(id);
      }
    }
    for (vtkIdType& corner : before.Corners)
    {
      corner += length;
    }
  }

  void WriteTriangle(const Around& around, vtkIdType i, int item,
    const vtkIsotable::Triangle& slots, const vtkIdType* ids, bool isInverted, RowCount& place)
  {
    this->Mesh.WriteTriangle(place.Triangles++, { { ids[slots[0]], ids[slots[1]], ids[slots[2]] } },
      isInverted, item, slots[3], around.FirstCell + i);
  }

  // Cuts a case where values equal isovalues: slots that are one point are made one before the case
  // is cut. Returns false where none are.
  template <bool Write>
  bool ProcessTies(Local& local, const Around& around, vtkIdType i, int item,
    const vtkIsotable::Case& found, RowCount& place)
  {
    const auto& what = this->Values.GetItems()[item];
    Code codes[8];
    this->GetCodes(around, i, codes);
    TiedCases::Tied& tied = local.TiedCases.Find(
      this->Table, this->Ranks, what, item, codes, found, this->Context.GenerateBoundaries);
    if (!tied.IsMerged)
    {
      return false;
    }
    const auto& simplices = tied.Cut.GetSimplices();
    const auto& triangles = tied.Cut.GetTriangles();
    const std::size_t number = triangles.size();
    if (!Write)
    {
      local.Report.CollapsedSimplices += tied.Cut.GetNumberCollapsed();
      place.Simplices += static_cast<vtkIdType>(simplices.size());
      place.Triangles += static_cast<vtkIdType>(number);
      return true;
    }
    vtkIdType ids[vtkIsotable::MaximumNumberOfSlots];
    const auto find = [&](Slot slot) { ids[slot] = this->GetId(around, i, what, slot); };
    const bool isInverted = this->IsInverted(around, i);
    for (const vtkIsotable::Simplex& simplex : simplices)
    {
      std::for_each_n(simplex.begin(), this->SimplexSize, find);
      if (tied.Cut.IsInFace(this->Table, simplex))
      {
        local.TiedSimplices.push_back(place.Simplices + (&simplex - simplices.data()));
      }
      else
      {
        this->Use(simplex.data(), this->SimplexSize, ids);
      }
    }
    this->Mesh.Simplices.Write(
      place.Simplices, simplices.data(), simplices.size(), ids, isInverted);
    this->Mesh.NoteSimplices(place.Simplices, simplices.size(), item, around.FirstCell + i);
    place.Simplices += static_cast<vtkIdType>(simplices.size());
    for (std::size_t t = 0; t < number; ++t)
    {
      std::for_each_n(triangles[t].begin(), 3, find);
      this->Use(triangles[t].data(), 3, ids);
      local.TiedTriangles.push_back(place.Triangles);
      this->WriteTriangle(around, i, item, triangles[t], ids, isInverted, place);
    }
    return true;
  }

  ExtractionContext& Context;
  std::atomic<bool> HasTiedGhost{ false };
  const ExtractionValues& Values;
  std::unique_ptr<ExtractionScalars> Scalars;
  ExtractionMesh& Mesh;
  const vtkIsotable& Table;
  std::vector<SlotPlace> Places;
  vtkIsotable::RankArray Ranks;
  CellOrientation Orientation;
  RowIndex Rows;
  vtkIdType Nx;
  vtkIdType Ny;
  vtkIdType Nz;
  // Whether any cell in the window may be blanked.
  bool HasBlanking;
  int SimplexSize;
  // The key of a cell inside of an interval, and the type that it is passed on as.
  Code KeyInside;
  unsigned char WholeType;
  // For each code the number of smaller ones of which grid points are points of the output.
  std::vector<int> PointsBelow;
  std::vector<RowCount> Offsets;
  // The columns [first, last) of a row of cells that give output.
  std::vector<ColumnRange> Columns;
  // What a grid point that is a point of the output adds to its own place.
  std::vector<Code> Zeros;
  // How many rows of owners a thread keeps of a layer.
  vtkIdType OwnerRows;
  bool MarksUsed = false;
  // All rows of codes, where they are kept.
  ExtractionBuffer<Code> AllCodes;
  std::vector<CodeRow> CodeRows;
  ThreadLocals<Local> Locals;
};
}

bool StructuredExtraction::Execute(
  ExtractionContext& context, const int dimensions[3], ExtractionMesh& mesh)
{
  GridWindow window(dimensions);
  const vtkIdType cells = window.GetNumberOfCells();
  // An index is of the rows of the whole grid.
  const bool isRowContour = RowContour::IsSuited(context);
  const bool isBox = (!context.Index || isRowContour) && window.Shrink(context, dimensions) &&
    !GhostCells::AreTiedBeyond(context, dimensions, window);
  window = isBox ? window : GridWindow(dimensions);
  const vtkIdType beyond = cells - window.GetNumberOfCells();
  context.Report->CellsVisited += beyond;
  context.Report->BlankedCells += beyond;
  const bool hasBlanking = context.HasBlanking() && !isBox;
  if (!hasBlanking && isRowContour)
  {
    return RowContour::Execute(context, dimensions, window, mesh);
  }
  return context.Whole ? Extractor<true>(context, dimensions, window, hasBlanking, mesh).Execute()
                       : Extractor<false>(context, dimensions, window, hasBlanking, mesh).Execute();
}

}
