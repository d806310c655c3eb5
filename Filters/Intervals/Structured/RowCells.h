// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowCells_h
#define interlume_RowCells_h

#include "Cuts/CoincidentSlots.h"
#include "Grid/InteriorCellFilter.h"
#include "Pass/ExtractionIndex.h"
#include "Scalars/ExtractionKernels.h"
#include "Scalars/RowKernels.h"
#include "Structured/RowPass.h"
#include "Structured/RowPoints.h"
#include "Structured/RowWriter.h"

#include "vtkCellType.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * Buffers of a thread for a row of cells.
 */
struct RowBuffers : RowResults
{
  RowPoints::Local Points;
  std::vector<ExtractionValues::Code> Columns;
  std::vector<ExtractionValues::Code> Keys;
  /// Marks of the cells of the row: 1 if a cell produces simplices or is an interior cell, 2 if it
  /// produces only boundary triangles.
  std::vector<std::uint8_t> OutputMarks;
  /// The columns [first, last) of the row that contain all cells with output.
  RowPoints::ColumnRange OutputRange = { 0, 0 };
  /// The columns of the cells to visit.
  std::vector<ExtractionIndex::Span> Spans;
  bool HasTies = false;
};

/**
 * @class   RowCells
 * @brief   counts or writes the output of a contour or an interval in a row of cells
 */
class RowCells
{
public:
  using Code = ExtractionValues::Code;

  /// All arguments must outlive this object. \a nx is the number of grid points in a row.
  RowCells(const ExtractionContext& context, const vtkIsotable& table,
    const vtkIsotable::RankArray& ranks, const RowIndex& rows, vtkIdType nx, ExtractionMesh& mesh)
    : Context(context)
    , Values(*context.Values)
    , Table(table)
    , Ranks(ranks)
    , Rows(rows)
    , Nx(nx)
    , Mesh(mesh)
    , Writer(context, table, rows, mesh)
    , KeyInside(static_cast<Code>(CoincidentSlots::GetAllInsideKey(8)))
    , InteriorType(GetInteriorCellType(context.Input))
  {
  }

  RowWriter& GetWriter() { return this->Writer; }
  const RowWriter& GetWriter() const { return this->Writer; }

  /// Counts or writes the cells in the spans of \a local, and advances \a position.
  template <bool Write>
  void Process(RowBuffers& local, const CellRow& around, int item, RowCount& position)
  {
    RowWriter::InsideCell inside;
    const auto& what = this->Values.GetItems()[item];
    this->FillKeys(local, around, what);
    const Code last = static_cast<Code>(this->Table.GetNumberOfCases() - 1);
    const bool hasTies = around.HasTies || what.IsFlat;
    const bool passesInterior = this->Context.InteriorFilter != nullptr;
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
        if (passesInterior && key == this->KeyInside && this->MayBeInterior(around, i))
        {
          this->ProcessInterior<Write>(local, around, i, item, position);
          continue;
        }
        const vtkIsotable::Case& found = this->Table.GetCase(key);
        const vtkIdType end = key == this->KeyInside && !passesInterior && !what.IsFlat
          ? this->FindInsideRangeEnd(local, around, i, span[1])
          : i;
        if (end > i)
        {
          this->ProcessInsideCells<Write>(local, around, { i, end }, item, found, inside, position);
          i = end - 1;
          continue;
        }
        const RowCount before = position;
        const bool isTied = hasTies && around.HasTiedPoints(i, what.IsFlat) &&
          this->ProcessTies<Write>(local, around, i, item, found, position);
        if (!isTied && Write)
        {
          this->Writer.WriteCell(around, i, item, found, position);
        }
        else if (!isTied)
        {
          position.Simplices += found.Simplices.size();
          position.Triangles += this->Context.GenerateBoundaries ? found.Boundary.size() : 0;
        }
        if (!Write && position.Simplices != before.Simplices)
        {
          MarkOutput(local, { i, i + 1 }, 1);
        }
        else if (!Write && position.Triangles != before.Triangles)
        {
          MarkOutput(local, { i, i + 1 }, std::max<std::uint8_t>(local.OutputMarks[i], 2));
        }
      }
    }
  }

private:
  // Returns the type of cells that are passed through uncut. A voxel must be aligned with the
  // coordinate axes.
  static unsigned char GetInteriorCellType(vtkDataSet* input)
  {
    vtkImageData* image = vtkImageData::SafeDownCast(input);
    const bool isAlongAxes = image ? image->GetDirectionMatrix()->IsIdentity()
                                   : vtkRectilinearGrid::SafeDownCast(input) != nullptr;
    return isAlongAxes ? VTK_VOXEL : VTK_HEXAHEDRON;
  }

  void FillKeys(RowBuffers& local, const CellRow& around, const ExtractionValues::Item& item) const
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

  // Returns the end of the range of cells, starting at \a first, that are inside an interval,
  // finite and without ties.
  static vtkIdType FindInsideRangeEnd(
    const RowBuffers& local, const CellRow& around, vtkIdType first, vtkIdType last)
  {
    const vtkIdType end =
      around.IsFinite ? ExtractionKernels::FindChange(local.Keys.data(), first, last) : first + 1;
    if (!around.HasTies)
    {
      return end;
    }
    // A cell also uses the points of the next column, so a tie there affects the cell.
    const vtkIdType tie = ExtractionKernels::FindOddCode(around.Codes, first, end + 1);
    return tie > end ? end : std::max(first, tie - 1);
  }

  // Counts or writes cells inside an interval. Without ties, they have no boundary triangles.
  template <bool Write>
  void ProcessInsideCells(RowBuffers& local, const CellRow& around,
    const RowPoints::ColumnRange& cells, int item, const vtkIsotable::Case& found,
    RowWriter::InsideCell& inside, RowCount& position)
  {
    if (!Write)
    {
      position.Simplices += (cells.Last - cells.First) * found.Simplices.size();
      MarkOutput(local, cells, 1);
      return;
    }
    this->Writer.WriteInside(around, cells.First, cells.Last, item, found, inside, position);
  }

  // Records that cells have output.
  static void MarkOutput(RowBuffers& local, const RowPoints::ColumnRange& cells, std::uint8_t mark)
  {
    std::fill(
      local.OutputMarks.begin() + cells.First, local.OutputMarks.begin() + cells.Last, mark);
    const bool isFirst = local.OutputRange.First == local.OutputRange.Last;
    local.OutputRange = { isFirst ? cells.First : std::min(local.OutputRange.First, cells.First),
      isFirst ? cells.Last : std::max(local.OutputRange.Last, cells.Last) };
  }

  // Returns true if the interior filter excludes no corner of a cell.
  bool MayBeInterior(const CellRow& around, vtkIdType i) const
  {
    for (int v = 0; v < 8; ++v)
    {
      if (!this->Context.InteriorFilter->SatisfiesCriteria(
            this->Rows.GetVertex(around.FirstPoint + i, v)))
      {
        return false;
      }
    }
    return true;
  }

  // Counts or writes a cell that is passed through uncut.
  template <bool Write>
  void ProcessInterior(
    RowBuffers& local, const CellRow& around, vtkIdType i, int item, RowCount& position)
  {
    if (Write)
    {
      vtkIdType ids[8];
      for (int v = 0; v < 8; ++v)
      {
        // VTK_HEXAHEDRON orders the points around a face, VTK_VOXEL along the axes.
        const int corner = this->InteriorType == VTK_HEXAHEDRON ? v ^ ((v >> 1) & 1) : v;
        ids[v] = around.GetVertexId(i, corner);
        this->Writer.Use(ids[v]);
      }
      this->Mesh.WriteInteriorCell(position.Interior, 8 * position.Interior, this->InteriorType,
        ids, 8, item, around.FirstCell + i);
    }
    else
    {
      MarkOutput(local, { i, i + 1 }, 1);
    }
    ++position.Interior;
  }

  // Merges slots that are the same point because values equal isovalues, and counts or writes the
  // cell. Returns false, without output, if no slots have to be merged.
  template <bool Write>
  bool ProcessTies(RowBuffers& local, const CellRow& around, vtkIdType i, int item,
    const vtkIsotable::Case& found, RowCount& position)
  {
    const auto& what = this->Values.GetItems()[item];
    Code codes[8];
    around.GetCodes(i, codes);
    TieCaseCache::Tied& tied = local.TieCaseCache.Find(
      this->Table, this->Ranks, what, item, codes, found, this->Context.GenerateBoundaries);
    if (!tied.IsMerged)
    {
      return false;
    }
    if (Write)
    {
      this->Writer.WriteTiedCell(
        around, i, item, tied.Cut, position, local.TiedSimplices, local.TiedTriangles);
    }
    else
    {
      local.Report.CollapsedSimplices += tied.Cut.GetNumberOfCollapsedSimplices();
      position.Simplices += static_cast<vtkIdType>(tied.Cut.GetSimplices().size());
      position.Triangles += static_cast<vtkIdType>(tied.Cut.GetTriangles().size());
    }
    return true;
  }

  const ExtractionContext& Context;
  const ExtractionValues& Values;
  const vtkIsotable& Table;
  const vtkIsotable::RankArray& Ranks;
  const RowIndex& Rows;
  vtkIdType Nx;
  ExtractionMesh& Mesh;
  RowWriter Writer;
  // The case key of a cell inside an interval.
  Code KeyInside;
  unsigned char InteriorType;
};

}

#endif
