// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/StructuredExtraction.h"

#include "Common/ThreadLocals.h"
#include "Cuts/ExtractionCell.h"
#include "Cuts/TiedCases.h"
#include "Grid/RowIndex.h"
#include "Grid/WholeCells.h"
#include "Pass/ExtractionIndex.h"
#include "Pass/GhostCells.h"
#include "Scalars/ExtractionKernels.h"
#include "Scalars/RowKernels.h"
#include "Structured/PointOutput.h"
#include "Structured/RowContour.h"
#include "Structured/RowPoints.h"
#include "Structured/RowWriter.h"

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
    , Mesh(mesh)
    , Table(vtkIsotable::Get(context.Values->GetKind(), vtkIsotable::HEXAHEDRON))
    , Ranks(SlotPlace::FindRanks(Table))
    , Rows(dimensions, window)
    , Nx(window.Last[0] - window.First[0] + 1)
    , Points(context, Rows, window)
    , Writer(context, Table, Rows, mesh)
    , HasBlanking(hasBlanking)
    , KeyInside(static_cast<Code>(ExtractionCell::GetKeyInside(8)))
    , WholeType(GetTypeInRows(context.Input))
    , Zeros(this->Nx, 0)
  {
  }

  bool Execute()
  {
    const vtkIdType rows = this->Rows.GetNumberOfRows();
    if (!this->Points.MakeCodes() || !this->Count(rows))
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
    RowPoints::Local Points;
    std::vector<Code> Columns;
    std::vector<Code> Keys;
    std::vector<std::uint8_t> Gave;
    // The columns [first, last) of the row of cells that give output.
    RowPoints::ColumnRange Given = { 0, 0 };
    std::vector<ExtractionIndex::Span> Spans;
    std::vector<ExtractionIndex::Span> Counted;
    interlume::TiedCases TiedCases;
    std::vector<vtkIdType> TiedTriangles;
    std::vector<vtkIdType> TiedSimplices;
    vtkExtractionReport Report;
    bool HasTies = false;
  };

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
        const vtkIdType number = this->Offsets[row + 1].Points - place.Points;
        if (number > 0)
        {
          this->Points.Write(local.Points, row, place.Points, number, this->Mesh);
        }
      }
      else
      {
        const CodeRow& codes = this->Points.GetCodes(local.Points, j, k);
        place.Points = this->Points.Count(local.Points, j, k);
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
    PointOutput::Allocate(this->Context, total.Points, this->Mesh);
    vtkIdType whole = 0;
    if constexpr (KeepsWhole)
    {
      whole = total.Whole;
    }
    this->Mesh.Allocate(total.Points, total.Simplices, this->Context.GetSimplexSize(),
      total.Triangles, this->Context.KeepCellIds, whole, 8 * whole);
    // A point is in the output unless its cells are blanked or its simplices have collapsed.
    const bool hasTies = std::any_of(
      this->Locals.begin(), this->Locals.end(), [](const Local& local) { return local.HasTies; });
    if (hasTies || this->HasBlanking || this->Values.HasFlatItem())
    {
      this->Writer.StartMarks(total.Points);
    }
  }

  void GatherReport()
  {
    std::size_t bytes = this->Offsets.capacity() * sizeof(RowCount) +
      this->Columns.capacity() * sizeof(this->Columns[0]) + this->Mesh.Points.GetBytes() +
      this->Points.GetBytes() + this->Mesh.Used.GetBytes();
    // The bytes of columns, keys and marks.
    constexpr std::size_t bytesOfColumn = 2 * sizeof(Code) + sizeof(std::uint8_t);
    for (const Local& local : this->Locals)
    {
      this->Context.Report->Add(local.Report);
      bytes +=
        static_cast<std::size_t>(this->Nx) * bytesOfColumn + this->Points.GetBytes(local.Points);
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
    CellRow around;
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
      const CodeRow& codes = this->Points.GetCodes(local.Points, j, k);
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
      const RowPoints::ColumnRange range = this->Points.GetRange(rows);
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
      this->CountFolded(local, around.FirstPoint);
    }
  }

  void CountFolded(Local& local, vtkIdType firstPoint) const
  {
    const CellOrientation& orientation = this->Writer.GetOrientation();
    for (vtkIdType i = 0; orientation.IsPerCell() && i + 1 < this->Nx; ++i)
    {
      local.Report.FoldedCells += local.Gave[i] && orientation.IsFolded(this->Rows, firstPoint + i);
    }
  }

  void FindSlotRows(Local& local, CellRow& around) const
  {
    const RowPoints::Owners* owners[4];
    vtkIdType firsts[4];
    for (int r = 0; r < 4; ++r)
    {
      const vtkIdType j = around.J + (r & 1);
      const vtkIdType k = around.K + (r >> 1);
      owners[r] = &this->Points.GetOwners(local.Points, j, k);
      firsts[r] = this->Offsets[this->Rows.GetRow(j, k)].Points;
    }
    CellRow::SlotRow* slot = around.Slots;
    for (const SlotPlace& at : this->Writer.GetPlaces())
    {
      const RowPoints::Owners& owner = *owners[at.Row];
      // A row that owns nothing has no arrays, and its slots no points.
      const vtkIdType column = owner.Starts.empty() ? 0 : at.Column;
      *slot++ = { firsts[at.Row], owner.Starts.data() + column,
        at.Direction == 0 ? this->Zeros.data() : owner.Offsets[at.Direction - 1].data() + column };
    }
  }

  // Leaves the cells between the columns of points in range.
  static void Trim(const RowPoints::ColumnRange& range, std::vector<ExtractionIndex::Span>& spans)
  {
    for (auto& span : spans)
    {
      span[0] = std::max<vtkIdType>(span[0], range.First);
      span[1] = std::max<vtkIdType>(span[0], std::min<vtkIdType>(span[1], range.Last - 1));
    }
  }

  bool IsBlanked(const CellRow& around, vtkIdType i) const
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
  vtkIdType CutBlanked(Local& local, const CellRow& around)
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
            around.HasTiedPoints(i))
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
  vtkIdType FindBlanked(const CellRow& around, vtkIdType first, vtkIdType last) const
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

  void CountInput(Local& local, const CellRow& around)
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
        local.Report.NonFiniteCells += !around.IsCellFinite(i, this->Values.GetNonFiniteCode());
      }
    }
  }

  void FillKeys(Local& local, const CellRow& around, const ExtractionValues::Item& item) const
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

  template <bool Write>
  void ProcessItem(Local& local, const CellRow& around, int item, RowCount& place)
  {
    RowWriter::CellInside inside;
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
        if (!around.IsFinite && !around.IsCellFinite(i, this->Values.GetNonFiniteCode()))
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
        const bool isTied = hasTies && around.HasTiedPoints(i, what.IsFlat) &&
          this->ProcessTies<Write>(local, around, i, item, found, place);
        if (!isTied && Write)
        {
          this->Writer.WriteCell(around, i, item, found, place);
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
    const Local& local, const CellRow& around, vtkIdType first, vtkIdType last) const
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
  void ProcessInside(Local& local, const CellRow& around, const RowPoints::ColumnRange& cells,
    int item, const vtkIsotable::Case& found, RowWriter::CellInside& inside, RowCount& place)
  {
    if (!Write)
    {
      place.Simplices += (cells.Last - cells.First) * found.Simplices.size();
      this->NoteGiven(local, cells, 1);
      return;
    }
    this->Writer.WriteInside(around, cells.First, cells.Last, item, found, inside, place);
  }

  // Notes that cells give output.
  static void NoteGiven(Local& local, const RowPoints::ColumnRange& cells, std::uint8_t mark)
  {
    std::fill(local.Gave.begin() + cells.First, local.Gave.begin() + cells.Last, mark);
    const bool isFirst = local.Given.First == local.Given.Last;
    local.Given = { isFirst ? cells.First : std::min(local.Given.First, cells.First),
      isFirst ? cells.Last : std::max(local.Given.Last, cells.Last) };
  }

  // Returns whether no criterion leaves a corner of a cell out.
  bool MayBeWhole(const CellRow& around, vtkIdType i) const
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
  void ProcessWhole(Local& local, const CellRow& around, vtkIdType i, int item, RowCount& place)
  {
    if (Write)
    {
      vtkIdType ids[8];
      for (int v = 0; v < 8; ++v)
      {
        // The points of a hexahedron go around its faces.
        const int corner = this->WholeType == VTK_HEXAHEDRON ? v ^ ((v >> 1) & 1) : v;
        ids[v] = around.GetVertexId(i, corner);
        this->Writer.Use(ids[v]);
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

  // Cuts a case where values equal isovalues: slots that are one point are made one before the case
  // is cut. Returns false where none are.
  template <bool Write>
  bool ProcessTies(Local& local, const CellRow& around, vtkIdType i, int item,
    const vtkIsotable::Case& found, RowCount& place)
  {
    const auto& what = this->Values.GetItems()[item];
    Code codes[8];
    around.GetCodes(i, codes);
    TiedCases::Tied& tied = local.TiedCases.Find(
      this->Table, this->Ranks, what, item, codes, found, this->Context.GenerateBoundaries);
    if (!tied.IsMerged)
    {
      return false;
    }
    if (Write)
    {
      this->Writer.WriteTied(
        around, i, item, tied.Cut, place, local.TiedSimplices, local.TiedTriangles);
    }
    else
    {
      local.Report.CollapsedSimplices += tied.Cut.GetNumberCollapsed();
      place.Simplices += static_cast<vtkIdType>(tied.Cut.GetSimplices().size());
      place.Triangles += static_cast<vtkIdType>(tied.Cut.GetTriangles().size());
    }
    return true;
  }

  ExtractionContext& Context;
  std::atomic<bool> HasTiedGhost{ false };
  const ExtractionValues& Values;
  ExtractionMesh& Mesh;
  const vtkIsotable& Table;
  vtkIsotable::RankArray Ranks;
  RowIndex Rows;
  vtkIdType Nx;
  RowPoints Points;
  RowWriter Writer;
  // Whether any cell in the window may be blanked.
  bool HasBlanking;
  // The key of a cell inside of an interval, and the type that it is passed on as.
  Code KeyInside;
  unsigned char WholeType;
  std::vector<RowCount> Offsets;
  // The columns [first, last) of a row of cells that give output.
  std::vector<RowPoints::ColumnRange> Columns;
  // What a grid point that is a point of the output adds to its own place.
  std::vector<Code> Zeros;
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
