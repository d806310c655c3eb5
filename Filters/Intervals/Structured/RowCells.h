// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowCells_h
#define interlume_RowCells_h

#include "Cuts/ExtractionCell.h"
#include "Grid/WholeCells.h"
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
 * What a thread keeps for the cells of a row.
 */
struct RowBuffers : RowNotes
{
  RowPoints::Local Points;
  std::vector<ExtractionValues::Code> Columns;
  std::vector<ExtractionValues::Code> Keys;
  /// A mark for each cell of the row that gives simplices (1) or boundary triangles only (2).
  std::vector<std::uint8_t> Gave;
  /// The columns [first, last) of the row of cells that give output.
  RowPoints::ColumnRange Given = { 0, 0 };
  /// The cells that are visited.
  std::vector<ExtractionIndex::Span> Spans;
  bool HasTies = false;
};

/**
 * @class   RowCells
 * @brief   counts or writes what the cells of a row have of an item
 */
class RowCells
{
public:
  using Code = ExtractionValues::Code;

  /// All of these must outlive this; \a nx is the number of points of a row.
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
    , KeyInside(static_cast<Code>(ExtractionCell::GetKeyInside(8)))
    , InteriorType(GetTypeInRows(context.Input))
  {
  }

  RowWriter& GetWriter() { return this->Writer; }
  const RowWriter& GetWriter() const { return this->Writer; }

  /// Counts or writes the cells of \a local's spans, and moves \a place on.
  template <bool Write>
  void Process(RowBuffers& local, const CellRow& around, int item, RowCount& place)
  {
    RowWriter::CellInside inside;
    const auto& what = this->Values.GetItems()[item];
    this->FillKeys(local, around, what);
    const Code last = static_cast<Code>(this->Table.GetNumberOfCases() - 1);
    const bool hasTies = around.HasTies || what.IsFlat;
    const bool passesInterior = this->Context.Whole != nullptr;
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
          this->ProcessInterior<Write>(local, around, i, item, place);
          continue;
        }
        const vtkIsotable::Case& found = this->Table.GetCase(key);
        const vtkIdType end = key == this->KeyInside && !passesInterior && !what.IsFlat
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
          NoteGiven(local, { i, i + 1 }, 1);
        }
        else if (!Write && place.Triangles != before.Triangles)
        {
          NoteGiven(local, { i, i + 1 }, std::max<std::uint8_t>(local.Gave[i], 2));
        }
      }
    }
  }

private:
  // Returns the type of cells in rows that are passed on: a voxel lies along the axes of space.
  static unsigned char GetTypeInRows(vtkDataSet* input)
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

  // Returns the end of the cells from \a first on that are inside of an interval, finite and not
  // tied.
  static vtkIdType FindEndInside(
    const RowBuffers& local, const CellRow& around, vtkIdType first, vtkIdType last)
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
  void ProcessInside(RowBuffers& local, const CellRow& around, const RowPoints::ColumnRange& cells,
    int item, const vtkIsotable::Case& found, RowWriter::CellInside& inside, RowCount& place)
  {
    if (!Write)
    {
      place.Simplices += (cells.Last - cells.First) * found.Simplices.size();
      NoteGiven(local, cells, 1);
      return;
    }
    this->Writer.WriteInside(around, cells.First, cells.Last, item, found, inside, place);
  }

  // Notes that cells give output.
  static void NoteGiven(RowBuffers& local, const RowPoints::ColumnRange& cells, std::uint8_t mark)
  {
    std::fill(local.Gave.begin() + cells.First, local.Gave.begin() + cells.Last, mark);
    const bool isFirst = local.Given.First == local.Given.Last;
    local.Given = { isFirst ? cells.First : std::min(local.Given.First, cells.First),
      isFirst ? cells.Last : std::max(local.Given.Last, cells.Last) };
  }

  // Returns whether no criterion excludes a corner of a cell.
  bool MayBeInterior(const CellRow& around, vtkIdType i) const
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

  // Counts or writes a cell that is passed on.
  template <bool Write>
  void ProcessInterior(
    RowBuffers& local, const CellRow& around, vtkIdType i, int item, RowCount& place)
  {
    if (Write)
    {
      vtkIdType ids[8];
      for (int v = 0; v < 8; ++v)
      {
        // The points of a hexahedron go around its faces.
        const int corner = this->InteriorType == VTK_HEXAHEDRON ? v ^ ((v >> 1) & 1) : v;
        ids[v] = around.GetVertexId(i, corner);
        this->Writer.Use(ids[v]);
      }
      this->Mesh.WriteWhole(
        place.Interior, 8 * place.Interior, this->InteriorType, ids, 8, item, around.FirstCell + i);
    }
    else
    {
      NoteGiven(local, { i, i + 1 }, 1);
    }
    ++place.Interior;
  }

  // Cuts a case where values equal isovalues: slots that are one point are made one before the case
  // is cut. Returns false if none are.
  template <bool Write>
  bool ProcessTies(RowBuffers& local, const CellRow& around, vtkIdType i, int item,
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

  const ExtractionContext& Context;
  const ExtractionValues& Values;
  const vtkIsotable& Table;
  const vtkIsotable::RankArray& Ranks;
  const RowIndex& Rows;
  vtkIdType Nx;
  ExtractionMesh& Mesh;
  RowWriter Writer;
  // The key of a cell inside of an interval, and the type that it is passed on as.
  Code KeyInside;
  unsigned char InteriorType;
};

}

#endif
