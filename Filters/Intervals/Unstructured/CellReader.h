// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellReader_h
#define interlume_CellReader_h

#include "Cuts/SlotTables.h"
#include "Grid/CellOrientation.h"
#include "Grid/CornerOrder.h"
#include "Pass/ExtractionContext.h"
#include "Unstructured/PointMarks.h"
#include "Unstructured/UnstructuredCells.h"
#include "Unstructured/UnstructuredChunk.h"

#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace interlume
{

/**
 * @class   CellReader
 * @brief   reads the cells of an unstructured grid that an item may intersect
 *
 * \a Stored is the integer type of the offsets and connectivity arrays.
 */
template <typename Stored>
class CellReader
{
public:
  using Cell = TableCell<1>;
  using Code = ExtractionValues::Code;

  /// \a offsets and \a ids are the offsets and the connectivity of the cells of \a grid.
  CellReader(const ExtractionContext& context, vtkUnstructuredGrid* grid, const Stored* offsets,
    const Stored* ids)
    : Context(context)
    , Cells(grid, offsets, ids, context.Dimension)
    , Order(grid->GetPointData())
    , Orientation(grid)
    , NumberOfPoints(grid->GetNumberOfPoints())
    , Marks(*context.Values, grid->GetNumberOfPoints())
  {
  }

  const UnstructuredCells<Stored>& GetCells() const { return this->Cells; }
  const CornerOrder& GetOrder() const { return this->Order; }
  const PointMarks& GetMarks() const { return this->Marks; }
  const Code* GetCodes() const { return this->Codes.GetData(); }
  vtkIdType GetNumberOfPoints() const { return this->NumberOfPoints; }

  /// Computes the codes and marks of all points. Returns false if the user aborted.
  bool Classify(const ExtractionScalars& scalars)
  {
    this->Codes.Allocate(this->NumberOfPoints);
    return this->Context.Run(this->NumberOfPoints, 0.0, 0.05,
      [this, &scalars](vtkIdType first, vtkIdType last)
      {
        scalars.Classify(first, last - first, this->Codes.GetData() + first);
        this->Marks.Fill(this->Codes.GetData(), first, last);
      });
  }
  std::size_t GetBytes() const { return this->Codes.GetBytes() + this->Marks.GetBytes(); }
  void FreeCodesAndMarks()
  {
    this->Codes.Free();
    this->Marks.Free();
  }

  /// Finds the cells in [begin, end) that an item may intersect, and stores their offsets from \a
  /// begin in \a near. Cells from \a firstPassed on are always included, before the other cells of
  /// their run (see ExtractionIndex). Returns the number of cells found.
  int FindIntersectedCells(vtkIdType begin, vtkIdType end, vtkIdType firstPassed,
    std::uint16_t* near, ExtractionReport& report) const
  {
    constexpr vtkIdType run = ExtractionIndex::RunLength;
    const ExtractionIndex* const index = this->Context.Index;
    // If there is neither an index nor an interior filter, treat all cells as one run.
    const vtkIdType length = index || this->Context.InteriorFilter ? run : end - begin;
    int number = 0;
    for (vtkIdType first = begin; first < end; first += length)
    {
      if (!index || index->IsRunActive(first / run))
      {
        const vtkIdType last = std::min(first + length, end);
        report.CellsVisited += last - first;
        this->AppendNear(first, last, begin, firstPassed, near, number, report);
      }
    }
    return number;
  }

  /// Prefetches the coordinates of a cell's points.
  void Prefetch(vtkIdType id) const
  {
    if (!this->Context.KeepOrientation)
    {
      this->Cells.ForEachSecondPoint(
        id, [this](vtkIdType point) { this->Orientation.Prefetch(point); });
    }
  }

  /// Reads a cell without its codes.
  void Read(vtkIdType id, Cell& cell) const
  {
    if (this->ReadCorners(id, cell))
    {
      cell.IsAscending = this->Order.IsAscending(cell.Ids, cell.NumberOfCorners);
    }
  }

  /// Reads the point ids of a cell, unless \a cell already holds them.
  void ReadCornersIfNeeded(vtkIdType id, Cell& cell) const
  {
    if (id != cell.Id)
    {
      this->ReadCorners(id, cell);
    }
  }

  /// Reads the codes of a cell's corners. Returns their minimum and maximum.
  std::pair<Code, Code> ReadCodes(Cell& cell) const
  {
    Code minimum = std::numeric_limits<Code>::max();
    Code maximum = 0;
    for (int v = 0; v < cell.NumberOfCorners; ++v)
    {
      cell.Codes[v] = this->Codes[cell.Ids[v]];
      minimum = std::min(minimum, cell.Codes[v]);
      maximum = std::max(maximum, cell.Codes[v]);
    }
    return { minimum, maximum };
  }

  /// Returns true if a cell is left-handed.
  bool IsInverted(const Cell& cell) const
  {
    return this->Context.KeepOrientation ? cell.IsReflected
                                         : this->Orientation.IsInverted(cell.Shape, cell.Ids);
  }

  /// If \a hasOutput is true, counts a cell as a cell with output, and also as a folded cell if it
  /// is folded.
  void CountOutput(const Cell& cell, bool hasOutput, ExtractionReport& report) const
  {
    report.CellsWithOutput += hasOutput;
    report.FoldedCells += hasOutput && !this->Context.KeepOrientation &&
      this->Orientation.IsFolded(cell.Shape, cell.Ids);
  }

private:
  void AppendNear(vtkIdType first, vtkIdType last, vtkIdType begin, vtkIdType firstPassed,
    std::uint16_t* near, int& numberNear, ExtractionReport& report) const
  {
    const vtkIdType passed = std::max(first, firstPassed);
    for (vtkIdType id = passed; id < last; ++id)
    {
      near[numberNear++] = static_cast<std::uint16_t>(id - begin);
    }
    last = std::min(last, passed);
    if (!this->Cells.IsUniform() || this->Context.HasBlanking())
    {
      for (vtkIdType id = first; id < last; ++id)
      {
        near[numberNear] = static_cast<std::uint16_t>(id - begin);
        numberNear += this->Accept(id, report);
      }
      return;
    }
    int found = numberNear;
    vtkIdType nonFinite = 0;
    this->Cells.ForEachMarkUnion(first, last, this->Marks.GetData(),
      [&](vtkIdType id, PointMarks::Mark marks)
      {
        near[found] = static_cast<std::uint16_t>(id - begin);
        found += this->Marks.MayIntersect(marks);
        nonFinite += PointMarks::IsNonFinite(marks);
      });
    numberNear = found;
    report.NonFiniteCells += nonFinite;
  }

  bool IsBlanked(vtkIdType id, const CellCorners& corners) const
  {
    if (this->Context.IsCellSkipped(id))
    {
      return true;
    }
    vtkIdType ids[8];
    this->Cells.GetIds(id, corners, ids);
    return this->Context.PointGhosts &&
      std::any_of(ids, ids + corners.NumberOfCorners,
        [this](vtkIdType point) { return this->Context.IsPointBlanked(point); });
  }

  // Returns true if an item may intersect a cell and the cell can produce output. If the cell
  // cannot produce output, counts the reason.
  bool Accept(vtkIdType id, ExtractionReport& report) const
  {
    const CellCorners& corners = this->Cells.GetCorners(id);
    if (!this->Cells.HasTable(corners))
    {
      if (corners.Kind != CellCorners::SURFACE || !this->Context.IsMixed)
      {
        (corners.IsLowerDimensional() ? report.LowerDimensionalCells : report.UnsupportedCells) +=
          1;
      }
      return false;
    }
    if (this->Context.HasBlanking() && this->IsBlanked(id, corners))
    {
      ++report.BlankedCells;
      return false;
    }
    const PointMarks::Mark marks =
      this->Cells.GetMarks(id, corners.NumberOfCorners, this->Marks.GetData());
    if (PointMarks::IsNonFinite(marks))
    {
      ++report.NonFiniteCells;
      return false;
    }
    report.LinearizedCells += corners.Kind == CellCorners::HIGHER_ORDER;
    return this->Marks.MayIntersect(marks);
  }

  // Reads the point ids of a cell. If the ids are not in ascending order, rotates or reflects the
  // cell so that at least its first ids ascend. Returns true if the cell was reordered. IsAscending
  // is then false, even if all ids of the reordered cell ascend.
  bool ReadCorners(vtkIdType id, Cell& cell) const
  {
    const CellCorners& corners = this->Cells.GetCorners(id);
    cell.Id = id;
    cell.Shape = corners.Shape;
    cell.NumberOfCorners = corners.NumberOfCorners;
    this->Cells.GetIds(id, corners, cell.Ids);
    cell.IsAscending = this->Order.IsAscending(cell.Ids, cell.NumberOfCorners);
    cell.IsReflected = false;
    if (cell.IsAscending)
    {
      return false;
    }
    if (cell.Shape == vtkIsotable::TETRAHEDRON || cell.Shape == vtkIsotable::TRIANGLE)
    {
      cell.IsReflected = this->Order.IsOdd(cell.Ids, cell.NumberOfCorners);
    }
    this->Order.Turn(cell.Shape, cell.Ids);
    return true;
  }

  const ExtractionContext& Context;
  UnstructuredCells<Stored> Cells;
  CornerOrder Order;
  CellOrientation Orientation;
  vtkIdType NumberOfPoints;
  ExtractionBuffer<Code> Codes;
  PointMarks Marks;
};

}

#endif
