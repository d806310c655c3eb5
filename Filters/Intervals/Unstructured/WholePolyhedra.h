// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_WholePolyhedra_h
#define interlume_WholePolyhedra_h

#include "Grid/WholeCells.h"
#include "Pass/ExtractionContext.h"
#include "Unstructured/UnstructuredCells.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <vector>

namespace interlume
{

/**
 * @class   WholePolyhedra
 * @brief   tells which polyhedra are wholly inside an interval, by the cells that stand for them
 *
 * A polyhedron goes by its own points; the mean that it is coned from is none of them. It is told
 * of as the first of its cells. \a Stored is the type of the cell array's numbers.
 */
template <typename Stored>
class WholePolyhedra
{
public:
  using Code = ExtractionValues::Code;
  using Item = ExtractionValues::Item;

  WholePolyhedra(const ExtractionContext& context, const UnstructuredCells<Stored>& cells)
    : Context(context)
    , Whole(*context.Whole)
    , Cells(cells)
    , NumberOfPoints(Whole.GetOriginal()->GetNumberOfPoints())
  {
  }

  /// Finds the range of codes of each polyhedron. Returns false when the user aborted.
  bool FindRanges(const Code* codes, vtkIdType numberOfCells, double from, double to)
  {
    if (!this->Whole.HasParts())
    {
      return true;
    }
    this->Ranges.Allocate(this->Whole.GetOriginal()->GetNumberOfCells());
    return this->Context.Run(numberOfCells, from, to,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType cell = first; cell < last; ++cell)
        {
          if (this->Whole.IsPart(cell) && this->Whole.IsFirstPart(cell))
          {
            this->Ranges[this->Whole.GetOriginal(cell)] = this->FindRange(codes, cell);
          }
        }
      });
  }

  bool IsInside(vtkIdType part, const Item& item) const
  {
    const Range& range = this->Ranges[this->Whole.GetOriginal(part)];
    return item.IsInside(range.Least, range.Greatest);
  }

  unsigned char GetType(vtkIdType part) const { return this->Whole.GetOriginalType(part); }

  /// Gives the points of the polyhedron whose first cell \a part is.
  void GetPoints(vtkIdType part, std::vector<vtkIdType>& points) const
  {
    points.clear();
    if (this->GetType(part) != VTK_POLYHEDRON)
    {
      // The order of a prism's points means something.
      vtkNew<vtkIdList> ids;
      this->Whole.GetOriginal()->GetCellPoints(this->Whole.GetOriginal(part), ids);
      points.assign(ids->begin(), ids->end());
      return;
    }
    this->ForEachPoint(part,
      [&points](vtkIdType id)
      {
        if (std::find(points.begin(), points.end(), id) == points.end())
        {
          points.push_back(id);
        }
      });
  }

private:
  struct Range
  {
    Code Least;
    Code Greatest;
  };

  // Visits the points of all cells of a polyhedron but the mean.
  template <typename Visitor>
  void ForEachPoint(vtkIdType part, Visitor&& visit) const
  {
    const vtkIdType end = this->Whole.GetEndOfParts(part);
    for (vtkIdType cell = part; cell < end; ++cell)
    {
      const CellCorners& corners = this->Cells.GetCorners(cell);
      vtkIdType ids[8];
      this->Cells.GetIds(cell, corners, ids);
      std::for_each_n(ids, corners.NumberOfCorners,
        [&](vtkIdType id)
        {
          if (id < this->NumberOfPoints)
          {
            visit(id);
          }
        });
    }
  }

  Range FindRange(const Code* codes, vtkIdType part) const
  {
    Range range{ ExtractionValues::NoCode, 0 };
    bool mayBeWhole = true;
    this->ForEachPoint(part,
      [&](vtkIdType id)
      {
        range.Least = std::min(range.Least, codes[id]);
        range.Greatest = std::max(range.Greatest, codes[id]);
        mayBeWhole = mayBeWhole && this->Whole.MayHave(id) && !this->Context.IsPointBlanked(id);
      });
    return mayBeWhole ? range : Range{ 0, ExtractionValues::NoCode };
  }

  const ExtractionContext& Context;
  const WholeCells& Whole;
  const UnstructuredCells<Stored>& Cells;
  vtkIdType NumberOfPoints;
  // The range of codes of each original cell that is a polyhedron.
  ExtractionBuffer<Range> Ranges;
};

}

#endif
