// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_WholeParts_h
#define interlume_WholeParts_h

#include "Grid/WholeCells.h"
#include "Unstructured/UnstructuredCells.h"
#include "Unstructured/WholePolyhedra.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * @class   WholeParts
 * @brief   tells which cells of an unstructured grid are passed on whole, and as what
 *
 * It is empty for an extraction that keeps none. \a Stored is the type of the cell array's numbers.
 */
template <typename Stored, bool KeepsWhole>
struct WholeParts
{
  WholeParts(const ExtractionContext&, const UnstructuredCells<Stored>&) {}
};

template <typename Stored>
class WholeParts<Stored, true>
{
public:
  using Code = ExtractionValues::Code;
  using Item = ExtractionValues::Item;

  WholeParts(const ExtractionContext& context, const UnstructuredCells<Stored>& cells)
    : Whole(*context.Whole)
    , Cells(cells)
    , Polyhedra(context, cells)
  {
  }

  /// Finds the ranges of polyhedra; call it first. Returns false when the user aborted.
  bool FindRanges(const Code* codes, vtkIdType numberOfCells)
  {
    return this->Polyhedra.FindRanges(codes, numberOfCells, 0.05, 0.05);
  }

  bool IsPassed(vtkIdType cell) const { return this->Whole.IsPassed(cell); }
  vtkIdType GetFirstPassed() const { return this->Whole.GetFirstPassed(); }

  /// Returns whether a cell whose codes are least ... greatest is passed on whole. A tetrahedron is
  /// not: its case is that tetrahedron.
  bool IsWhole(vtkIdType cell, const Item& item, Code least, Code greatest) const
  {
    if (this->Whole.IsPart(cell))
    {
      return this->Polyhedra.IsInside(cell, item);
    }
    const CellCorners& corners = this->Cells.GetCorners(cell);
    if (corners.Shape == vtkIsotable::TETRAHEDRON || !item.IsInside(least, greatest))
    {
      return false;
    }
    vtkIdType ids[8];
    this->Cells.GetIds(cell, corners, ids);
    return std::all_of(ids, ids + corners.NumberOfCorners,
      [this](vtkIdType point) { return this->Whole.MayHave(point); });
  }

  /// Gives the points of a cell that is passed on whole, in their order in the input; none of a
  /// part of a polyhedron but the first. Returns its type.
  unsigned char GetPoints(vtkIdType cell, std::vector<vtkIdType>& points) const
  {
    if (this->IsPassed(cell))
    {
      this->Cells.GetStored(cell, points);
      return this->Cells.GetType(cell);
    }
    if (this->Whole.IsPart(cell))
    {
      points.clear();
      if (this->Whole.IsFirstPart(cell))
      {
        this->Polyhedra.GetPoints(cell, points);
      }
      return this->Polyhedra.GetType(cell);
    }
    this->Cells.GetStored(cell, points);
    const CellCorners& corners = this->Cells.GetCorners(cell);
    points.resize(corners.NumberOfCorners);
    return corners.Kind == CellCorners::LINEAR ? this->Cells.GetType(cell)
                                               : corners.GetLinearType();
  }

private:
  const WholeCells& Whole;
  const UnstructuredCells<Stored>& Cells;
  WholePolyhedra<Stored> Polyhedra;
};

}

#endif
