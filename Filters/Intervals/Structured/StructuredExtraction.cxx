// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/StructuredExtraction.h"

#include "Pass/GhostCells.h"
#include "Structured/RowCells.h"
#include "Structured/RowContour.h"

#include <atomic>
#include <limits>

namespace interlume
{

namespace
{
using Code = ExtractionValues::Code;
using Spans = std::vector<ExtractionIndex::Span>;

// Tells which cells of a row are blanked.
class RowBlanking
{
public:
  RowBlanking(const ExtractionContext& context, const RowIndex& rows, bool isAny)
    : Context(context)
    , Rows(rows)
    , Any(isAny)
  {
  }

  // Returns whether any cell may be blanked.
  bool IsAny() const { return this->Any; }

  // Leaves blanked cells out of the columns; returns how many there were. Notes whether one is
  // another piece's cell and tied.
  vtkIdType Cut(const CellRow& around, Spans& spans, std::atomic<bool>& hasTiedGhost) const
  {
    vtkIdType number = 0;
    Spans counted;
    for (const auto& span : spans)
    {
      for (vtkIdType i = span[0]; i < span[1];)
      {
        const vtkIdType first = i;
        i = this->FindBlanked(around, first, span[1]);
        if (first < i)
        {
          counted.push_back({ first, i });
        }
        for (; i < span[1] && this->IsBlanked(around, i); ++i)
        {
          ++number;
          if (around.HasTies && GhostCells::IsOne(this->Context, around.FirstCell + i) &&
            around.HasTiedPoints(i))
          {
            hasTiedGhost = true;
          }
        }
      }
    }
    spans.swap(counted);
    return number;
  }

private:
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

  const ExtractionContext& Context;
  const RowIndex& Rows;
  bool Any;
};

class CodePass : public RowPass<CodePass, RowBuffers>
{
public:
  CodePass(ExtractionContext& context, const int dimensions[3], const GridWindow& window,
    bool hasBlanking, ExtractionMesh& mesh)
    : RowPass(context, dimensions, window, mesh)
    , Settings(context)
    , Points(context, Rows, window)
    , Cells(context, Table, Ranks, Rows, Nx, mesh)
    , Blanking(context, Rows, hasBlanking)
    , Columns(Rows.GetNumberOfRows(), { 0, 0 })
    , Zeros(Nx, 0)
  {
  }

  bool Classify() { return this->Points.MakeCodes(); }

  void CountPart(vtkIdType row, RowBuffers& local)
  {
    const vtkIdType j = this->Rows.GetJ(row);
    const vtkIdType k = this->Rows.GetK(row);
    const ExtractionIndex* index = this->Context.Index;
    // Once a tied ghost cell is found, all is counted again.
    const bool isInVain = this->HasTiedGhost && !this->Context.TakeDuplicates;
    if (isInVain || (index && !index->IsRowActive(this->Rows.GetCellRow(j, k))))
    {
      return;
    }
    RowCount count;
    const CodeRow& codes = this->Points.GetCodes(local.Points, j, k);
    count.Points = this->Points.Count(local.Points, j, k);
    local.HasTies |= codes.HasTies || !codes.IsFinite;
    if (this->Rows.HasCells(j, k))
    {
      local.Spans.clear();
      if (index)
      {
        index->GetActiveSpans(this->Rows.GetCellRow(j, k), local.Spans);
      }
      else
      {
        local.Spans.push_back({ 0, this->Nx - 1 });
      }
      this->ProcessCells<false>(local, row, count);
      this->Columns[row] = local.Given;
    }
    this->Offsets[row + 1] = count;
  }

  bool Settle()
  {
    if (!this->HasTiedGhost)
    {
      return true;
    }
    // What there is at the faces of a ghost cell follows from the cell too.
    this->Settings.TakeDuplicates = true;
    for (RowBuffers& local : this->Locals)
    {
      local.Report = ExtractionReport();
    }
    const vtkIdType rows = this->Rows.GetNumberOfRows();
    this->Offsets.assign(rows + 1, RowCount());
    this->Columns.assign(rows, { 0, 0 });
    return this->ForEachPart(rows, Progress[0], Progress[1],
      [this](vtkIdType row, RowBuffers& local) { this->CountPart(row, local); });
  }

  void Allocate()
  {
    this->AllocateRows();
    // A point is in the output unless its cells are blanked or its simplices have collapsed.
    const bool hasTies = std::any_of(this->Locals.begin(), this->Locals.end(),
      [](const RowBuffers& local) { return local.HasTies; });
    if (hasTies || this->Blanking.IsAny() || this->Values.HasFlatItem())
    {
      this->Cells.GetWriter().StartMarks(this->Offsets.back().Points);
    }
  }

  void WritePart(vtkIdType row, RowBuffers& local)
  {
    RowCount place = this->Offsets[row];
    const RowCount& next = this->Offsets[row + 1];
    if (place.Points != next.Points)
    {
      this->Points.Write(local.Points, row, place.Points, next.Points - place.Points, this->Mesh);
    }
    if (place.HasCells(next))
    {
      local.Spans.clear();
      local.Spans.push_back({ this->Columns[row].First, this->Columns[row].Last });
      this->ProcessCells<true>(local, row, place);
    }
  }

  void Finish()
  {
    std::size_t bytes =
      this->Columns.capacity() * sizeof(this->Columns[0]) + this->Points.GetBytes();
    // The bytes of columns, keys and marks.
    constexpr std::size_t bytesOfColumn = 2 * sizeof(Code) + sizeof(std::uint8_t);
    for (const RowBuffers& local : this->Locals)
    {
      bytes +=
        static_cast<std::size_t>(this->Nx) * bytesOfColumn + this->Points.GetBytes(local.Points);
    }
    this->Gather(bytes);
  }

private:
  template <bool Write>
  void ProcessCells(RowBuffers& local, vtkIdType row, RowCount& place)
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
      if (this->Blanking.IsAny())
      {
        this->Blanking.Cut(around, local.Spans, this->HasTiedGhost);
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
      Trim(range, local.Spans);
      local.Gave.assign(this->Nx, 0);
    }
    const auto& items = this->Values.GetItems();
    for (std::size_t item = 0; item < items.size(); ++item)
    {
      if (!this->Values.IsOutside(items[item], minimum, maximum) || !around.IsFinite)
      {
        this->Cells.Process<Write>(local, around, static_cast<int>(item), place);
      }
    }
    if (!Write)
    {
      local.Report.CellsWithOutput += std::count(local.Gave.begin(), local.Gave.end(), 1);
      this->CountFolded(local, around.FirstPoint);
    }
  }

  void CountFolded(RowBuffers& local, vtkIdType firstPoint) const
  {
    const CellOrientation& orientation = this->Cells.GetWriter().GetOrientation();
    for (vtkIdType i = 0; orientation.IsPerCell() && i + 1 < this->Nx; ++i)
    {
      local.Report.FoldedCells += local.Gave[i] && orientation.IsFolded(this->Rows, firstPoint + i);
    }
  }

  void FindSlotRows(RowBuffers& local, CellRow& around) const
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
    for (const SlotPlace& at : this->Cells.GetWriter().GetPlaces())
    {
      const RowPoints::Owners& owner = *owners[at.Row];
      // A row that owns nothing has no arrays, and its slots no points.
      const vtkIdType column = owner.Starts.empty() ? 0 : at.Column;
      *slot++ = { firsts[at.Row], owner.Starts.data() + column,
        at.Direction == 0 ? this->Zeros.data() : owner.Offsets[at.Direction - 1].data() + column };
    }
  }

  // Leaves the cells between the columns of points in range.
  static void Trim(const RowPoints::ColumnRange& range, Spans& spans)
  {
    for (auto& span : spans)
    {
      span[0] = std::max<vtkIdType>(span[0], range.First);
      span[1] = std::max<vtkIdType>(span[0], std::min<vtkIdType>(span[1], range.Last - 1));
    }
  }

  void CountInput(RowBuffers& local, const CellRow& around)
  {
    for (const auto& span : local.Spans)
    {
      local.Report.CellsVisited += span[1] - span[0];
    }
    if (this->Blanking.IsAny())
    {
      local.Report.BlankedCells += this->Blanking.Cut(around, local.Spans, this->HasTiedGhost);
    }
    for (const auto& span : local.Spans)
    {
      for (vtkIdType i = span[0]; i < span[1] && !around.IsFinite; ++i)
      {
        local.Report.NonFiniteCells += !around.IsCellFinite(i, this->Values.GetNonFiniteCode());
      }
    }
  }

  ExtractionContext& Settings;
  RowPoints Points;
  RowCells Cells;
  RowBlanking Blanking;
  std::atomic<bool> HasTiedGhost{ false };
  // The columns [first, last) of a row of cells that give output.
  std::vector<RowPoints::ColumnRange> Columns;
  // What a grid point that is a point of the output adds to its own place.
  std::vector<Code> Zeros;
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
  return CodePass(context, dimensions, window, hasBlanking, mesh).Execute();
}

}
