// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingCells_h
#define interlume_TimeVaryingCells_h

#include "Output/ExtractionReport.h"
#include "Cuts/SlotTables.h"
#include "Grid/CellOrientation.h"
#include "Grid/CornerOrder.h"
#include "Grid/RowIndex.h"
#include "Pass/ExtractionContext.h"
#include "Pass/GhostCells.h"
#include "Scalars/ExtractionKernels.h"
#include "Scalars/RowKernels.h"
#include "TimeVarying/TimeStep.h"
#include "Unstructured/PointMarks.h"
#include "Unstructured/UnstructuredCells.h"

#include "vtkPointData.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/// A cell of a slab, with its corners at both time steps.
using TimeVaryingCell = TableCell<2>;

/**
 * Base class of TimeVaryingRows and TimeVaryingUnstructured. Determines which cells are skipped.
 * Ghost cells are not skipped if any value equals a bound, because they then affect the output on
 * the faces between pieces.
 */
class TimeVaryingCellsBase
{
public:
  /// Returns true if a cell that is not skipped belongs to another piece.
  bool IsDuplicate(vtkIdType cell) const
  {
    return GhostCells::IsGhost(*this->Steps[0], cell) || GhostCells::IsGhost(*this->Steps[1], cell);
  }

protected:
  TimeVaryingCellsBase(const TimeStep& first, const TimeStep& second)
    : Steps{ &first, &second }
    , IncludesDuplicates(first.HasTies() || second.HasTies())
  {
  }

  bool HasBlanking() const
  {
    return this->Steps[0]->HasBlanking() || this->Steps[1]->HasBlanking();
  }

  /// Returns true if a cell or one of its points is blanked at either step.
  bool IsBlanked(const TimeVaryingCell& cell) const
  {
    return std::any_of(this->Steps, this->Steps + 2,
      [this, &cell](const TimeStep* step)
      {
        return (this->IncludesDuplicates ? step->IsCellHidden(cell.Id)
                                         : step->IsCellBlanked(cell.Id)) ||
          std::any_of(cell.Ids, cell.Ids + cell.NumberOfCorners,
            [step](vtkIdType point) { return step->IsPointBlanked(point); });
      });
  }

  const TimeStep* Steps[2];
  bool IncludesDuplicates;
};

/**
 * @class   TimeVaryingRows
 * @brief   reads the cells of image data, rectilinear grids and structured grids
 */
class TimeVaryingRows : public TimeVaryingCellsBase
{
public:
  using Code = ExtractionValues::Code;

  TimeVaryingRows(const TimeStep& first, const TimeStep& second, const ExtractionValues& values)
    : TimeVaryingCellsBase(first, second)
    , Values(values)
    , Rows(first.GetDimensions())
    , CellsInRow(first.GetDimensions()[0] - 1)
    , RowsInLayer(first.GetDimensions()[1] - 1)
  {
  }

  void Read(vtkIdType id, TimeVaryingCell& cell) const
  {
    const vtkIdType row = id / this->CellsInRow;
    const vtkIdType point = this->Rows.GetFirstPoint(
                              this->Rows.GetRow(row % this->RowsInLayer, row / this->RowsInLayer)) +
      id % this->CellsInRow;
    cell.Id = id;
    for (int v = 0; v < 8; ++v)
    {
      cell.Ids[v] = this->Rows.GetVertex(point, v);
    }
  }

  /// Structured cells need no marks because the codes are read directly.
  bool MakeMarks(const ExtractionContext&) { return true; }
  void FreeMarks() {}
  std::size_t GetMarkBytes() const { return 0; }

  /// Appends the cells in [first, last) that an interval may intersect to \a near, and counts the
  /// skipped cells.
  void FindIntersectedCells(
    vtkIdType first, vtkIdType last, std::vector<vtkIdType>& near, ExtractionReport& report) const
  {
    constexpr vtkIdType blockSize = 512;
    Code minimum[blockSize + 1];
    Code maximum[blockSize + 1];
    Code all[blockSize];
    TimeVaryingCell cell;
    while (first < last)
    {
      this->Read(first, cell);
      const vtkIdType inRow = this->CellsInRow - first % this->CellsInRow;
      const vtkIdType number = std::min({ last - first, inRow, blockSize });
      const Code* rows[8];
      for (int row = 0; row < 8; ++row)
      {
        // At each step, a cell touches four rows of points. Row r contains corners 2r and 2r + 1.
        rows[row] = this->Steps[row / 4]->GetCodes() + cell.Ids[2 * (row % 4)];
      }
      RowKernels::FindRanges(rows, number, minimum, maximum, all);
      for (vtkIdType i = 0; i < number;)
      {
        const vtkIdType end = all[i] == ExtractionKernels::Mixed
          ? i + 1
          : ExtractionKernels::FindChange(all, i, number);
        const bool isNonFinite = maximum[i] == this->Values.GetNonFiniteCode();
        const bool mayIntersect = this->MayIntersect(minimum[i], maximum[i]);
        for (; i < end && (mayIntersect || isNonFinite || this->HasBlanking()); ++i)
        {
          this->Sort(first + i, mayIntersect, isNonFinite, near, report);
        }
        i = end;
      }
      first += number;
    }
  }

private:
  bool MayIntersect(Code minimum, Code maximum) const
  {
    const auto& items = this->Values.GetItems();
    return std::any_of(items.begin(), items.end(),
      [&](const ExtractionValues::Item& item)
      { return !this->Values.IsOutside(item, minimum, maximum); });
  }

  void Sort(vtkIdType id, bool mayIntersect, bool isNonFinite, std::vector<vtkIdType>& near,
    ExtractionReport& report) const
  {
    TimeVaryingCell cell;
    if (this->HasBlanking())
    {
      this->Read(id, cell);
      if (this->IsBlanked(cell))
      {
        ++report.BlankedCells;
        return;
      }
    }
    if (isNonFinite)
    {
      ++report.NonFiniteCells;
      return;
    }
    report.BlankedCells += this->IsDuplicate(id);
    if (mayIntersect)
    {
      near.push_back(id);
    }
  }

  const ExtractionValues& Values;
  RowIndex Rows;
  vtkIdType CellsInRow;
  vtkIdType RowsInLayer;
};

/**
 * @class   TimeVaryingUnstructured
 * @brief   reads the cells of an unstructured grid
 *
 * \a Stored is the integer type of the offsets and connectivity arrays.
 */
template <typename Stored>
class TimeVaryingUnstructured : public TimeVaryingCellsBase
{
public:
  TimeVaryingUnstructured(const TimeStep& first, const TimeStep& second,
    const ExtractionValues& values, const Stored* offsets, const Stored* ids)
    : TimeVaryingCellsBase(first, second)
    , Cells(first.GetUnstructuredGrid(), offsets, ids)
    , Order(first.GetGrid()->GetPointData())
    , Marks(values, first.GetNumberOfPoints())
  {
  }

  ///@{
  /// Compute and free the point marks that FindIntersectedCells() uses, and return their size in
  /// bytes. The mark of a point is the union of its marks at both steps. MakeMarks() returns false
  /// if the user aborted.
  bool MakeMarks(const ExtractionContext& context)
  {
    return context.Run(this->Steps[0]->GetNumberOfPoints(), 0.1, 0.2,
      [this](vtkIdType first, vtkIdType last)
      { this->Marks.Fill(this->Steps[0]->GetCodes(), this->Steps[1]->GetCodes(), first, last); });
  }
  void FreeMarks() { this->Marks.Free(); }
  std::size_t GetMarkBytes() const { return this->Marks.GetBytes(); }
  ///@}

  const CornerOrder& GetOrder() const { return this->Order; }

  void Read(vtkIdType id, TimeVaryingCell& cell) const
  {
    this->ReadAsStored(id, cell);
    cell.IsAscending = this->Order.IsAscending(cell.Ids, cell.NumberOfCorners);
    if (!cell.IsAscending)
    {
      this->Order.Turn(cell.Shape, cell.Ids);
      cell.IsAscending = this->Order.IsAscending(cell.Ids, cell.NumberOfCorners);
    }
  }

  void FindIntersectedCells(
    vtkIdType first, vtkIdType last, std::vector<vtkIdType>& near, ExtractionReport& report) const
  {
    if (this->Cells.IsUniform() && !this->HasBlanking())
    {
      this->Cells.ForEachMarkUnion(first, last, this->Marks.GetData(),
        [&](vtkIdType id, PointMarks::Mark all)
        {
          report.NonFiniteCells += PointMarks::IsNonFinite(all);
          if (this->Marks.MayIntersect(all))
          {
            near.push_back(id);
          }
        });
      return;
    }
    for (vtkIdType id = first; id < last; ++id)
    {
      if (this->MayIntersect(id, report))
      {
        near.push_back(id);
      }
    }
  }

private:
  void ReadAsStored(vtkIdType id, TimeVaryingCell& cell) const
  {
    const CellCorners& corners = this->Cells.GetCorners(id);
    cell.Id = id;
    cell.Shape = corners.Shape;
    cell.NumberOfCorners = corners.NumberOfCorners;
    this->Cells.GetIds(id, corners, cell.Ids);
  }

  bool MayIntersect(vtkIdType id, ExtractionReport& report) const
  {
    const CellCorners& corners = this->Cells.GetCorners(id);
    vtkIdType* reason = nullptr;
    PointMarks::Mark all = 0;
    if (corners.HasTable())
    {
      TimeVaryingCell cell;
      this->ReadAsStored(id, cell);
      all = this->Cells.GetMarks(id, corners.NumberOfCorners, this->Marks.GetData());
      reason = this->HasBlanking() && this->IsBlanked(cell) ? &report.BlankedCells
        : PointMarks::IsNonFinite(all)                      ? &report.NonFiniteCells
                                                            : nullptr;
    }
    else
    {
      reason =
        corners.IsLowerDimensional() ? &report.LowerDimensionalCells : &report.UnsupportedCells;
    }
    if (reason)
    {
      ++*reason;
      return false;
    }
    report.BlankedCells += this->IsDuplicate(id);
    report.LinearizedCells += corners.Kind == CellCorners::HIGHER_ORDER;
    return this->Marks.MayIntersect(all);
  }

  UnstructuredCells<Stored> Cells;
  CornerOrder Order;
  PointMarks Marks;
};

}

#endif
