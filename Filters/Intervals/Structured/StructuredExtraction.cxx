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

// Finds the blanked cells of a row.
class RowBlanking
{
public:
  RowBlanking(const ExtractionContext& context, const RowIndex& rows, bool isAny)
    : Context(context)
    , Rows(rows)
    , Any(isAny)
  {
  }

  // Returns true if any cell may be blanked.
  bool IsAny() const { return this->Any; }

  // Removes blanked cells from the spans and returns their number. Sets \a hasTiedGhost if such a
  // cell belongs to another piece and has a tie.
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
          if (around.HasTies && GhostCells::IsGhost(this->Context, around.FirstCell + i) &&
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
    if (this->Context.IsCellSkipped(around.FirstCell + i))
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

  // Returns the first blanked cell in [first, last), or \a last.
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
  CodePass(ExtractionContext& context, const int dimensions[3], const GridCellRange& window,
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
    // Once a tied ghost cell is found, these counts are not needed: all cells are counted again.
    const bool isObsolete = this->HasTiedGhost && !this->Context.IncludeGhostCells;
    if (isObsolete || (index && !index->IsRowActive(this->Rows.GetCellRow(j, k))))
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
      this->Columns[row] = local.OutputRange;
    }
    this->Offsets[row + 1] = count;
  }

  bool Settle()
  {
    if (!this->HasTiedGhost)
    {
      return true;
    }
    // The output at the faces of a ghost cell also depends on that cell.
    this->Settings.IncludeGhostCells = true;
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
    RowCount position = this->Offsets[row];
    const RowCount& next = this->Offsets[row + 1];
    if (position.Points != next.Points)
    {
      this->Points.Write(
        local.Points, row, position.Points, next.Points - position.Points, this->Mesh);
    }
    if (position.HasCells(next))
    {
      local.Spans.clear();
      local.Spans.push_back({ this->Columns[row].First, this->Columns[row].Last });
      this->ProcessCells<true>(local, row, position);
    }
  }

  void Finish()
  {
    std::size_t bytes =
      this->Columns.capacity() * sizeof(this->Columns[0]) + this->Points.GetBytes();
    // Bytes per grid column: Columns, Keys and OutputMarks.
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
  void ProcessCells(RowBuffers& local, vtkIdType row, RowCount& position)
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
    // FindSlotRows() also reads the codes of the next rows along j and k. RowPoints::Local holds
    // three rows along each axis, so the pointers to codes remain valid.
    if (Write)
    {
      this->FindSlotRows(local, around);
      if (this->Blanking.IsAny())
      {
        this->Blanking.Cut(around, local.Spans, this->HasTiedGhost);
      }
    }
    local.OutputRange = { 0, 0 };
    if (!Write)
    {
      this->CountInput(local, around);
      const RowPoints::ColumnRange range = this->Points.GetRange(rows);
      if (range.First == range.Last)
      {
        return;
      }
      Trim(range, local.Spans);
      local.OutputMarks.assign(this->Nx, 0);
    }
    const auto& items = this->Values.GetItems();
    for (std::size_t item = 0; item < items.size(); ++item)
    {
      if (!this->Values.IsOutside(items[item], minimum, maximum) || !around.IsFinite)
      {
        this->Cells.Process<Write>(local, around, static_cast<int>(item), position);
      }
    }
    if (!Write)
    {
      local.Report.CellsWithOutput +=
        std::count(local.OutputMarks.begin(), local.OutputMarks.end(), 1);
      this->CountFolded(local, around.FirstPoint);
    }
  }

  void CountFolded(RowBuffers& local, vtkIdType firstPoint) const
  {
    const CellOrientation& orientation = this->Cells.GetWriter().GetOrientation();
    for (vtkIdType i = 0; orientation.IsPerCell() && i + 1 < this->Nx; ++i)
    {
      local.Report.FoldedCells +=
        local.OutputMarks[i] && orientation.IsFolded(this->Rows, firstPoint + i);
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
    for (const SlotLocation& at : this->Cells.GetWriter().GetSlotLocations())
    {
      const RowPoints::Owners& owner = *owners[at.Row];
      // A row that owns no points has empty arrays, and its slots are not used.
      const vtkIdType column = owner.Starts.empty() ? 0 : at.Column;
      *slot++ = { firsts[at.Row], owner.Starts.data() + column,
        at.Direction == 0 ? this->Zeros.data() : owner.Offsets[at.Direction - 1].data() + column };
    }
  }

  // Restricts the spans to cells between the columns of points in \a range.
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
  // The columns [first, last) of each row that contain all cells with output.
  std::vector<RowPoints::ColumnRange> Columns;
  // Zero offsets, used for slots that are grid points.
  std::vector<Code> Zeros;
};
}

bool StructuredExtraction::Execute(
  ExtractionContext& context, const int dimensions[3], ExtractionMesh& mesh)
{
  GridCellRange window(dimensions);
  const vtkIdType cells = window.GetNumberOfCells();
  // With an index, CodePass needs the full grid because the index returns columns of the full grid.
  const bool isRowContour = RowContour::IsApplicable(context);
  const bool isBox = (!context.Index || isRowContour) && window.Shrink(context, dimensions) &&
    !GhostCells::HaveTiesOutside(context, dimensions, window);
  window = isBox ? window : GridCellRange(dimensions);
  const vtkIdType outside = cells - window.GetNumberOfCells();
  context.Report->CellsVisited += outside;
  context.Report->BlankedCells += outside;
  const bool hasBlanking = context.HasBlanking() && !isBox;
  if (!hasBlanking && isRowContour)
  {
    return RowContour::Execute(context, dimensions, window, mesh);
  }
  return CodePass(context, dimensions, window, hasBlanking, mesh).Execute();
}

}
