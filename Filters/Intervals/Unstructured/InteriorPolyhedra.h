// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InteriorPolyhedra_h
#define interlume_InteriorPolyhedra_h

#include "Grid/InteriorCellFilter.h"
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
 * @class   InteriorPolyhedra
 * @brief   finds polyhedra that are inside an interval
 *
 * A polyhedron is split into cells (its parts) that have the mean of its points as their common
 * apex. The test uses the points of the polyhedron only, not the mean. The first part represents
 * the polyhedron. \a Stored is the integer type of the offsets and connectivity arrays.
 */
template <typename Stored>
class InteriorPolyhedra
{
public:
  using Code = ExtractionValues::Code;
  using Item = ExtractionValues::Item;

  InteriorPolyhedra(const ExtractionContext& context, const UnstructuredCells<Stored>& cells)
    : Context(context)
    , Filter(*context.InteriorFilter)
    , Cells(cells)
    , NumberOfPoints(Filter.GetOriginal()->GetNumberOfPoints())
  {
  }

  /// Computes the range of codes of each polyhedron. Returns false if the user aborted.
  bool FindRanges(const Code* codes, vtkIdType numberOfCells, double from, double to)
  {
    if (!this->Filter.HasParts())
    {
      return true;
    }
    this->Ranges.Allocate(this->Filter.GetOriginal()->GetNumberOfCells());
    return this->Context.Run(numberOfCells, from, to,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType cell = first; cell < last; ++cell)
        {
          if (this->Filter.IsPart(cell) && this->Filter.IsFirstPart(cell))
          {
            this->Ranges[this->Filter.GetOriginal(cell)] = this->FindRange(codes, cell);
          }
        }
      });
  }

  bool IsInside(vtkIdType part, const Item& item) const
  {
    const Range& range = this->Ranges[this->Filter.GetOriginal(part)];
    return item.IsInside(range.Minimum, range.Maximum);
  }

  unsigned char GetType(vtkIdType part) const { return this->Filter.GetOriginalType(part); }

  /// Gets the points of the polyhedron whose first part is \a part.
  void GetPoints(vtkIdType part, std::vector<vtkIdType>& points) const
  {
    points.clear();
    if (this->GetType(part) != VTK_POLYHEDRON)
    {
      // The original cell is a pentagonal or hexagonal prism, whose type defines the order of its
      // points.
      vtkNew<vtkIdList> ids;
      this->Filter.GetOriginal()->GetCellPoints(this->Filter.GetOriginal(part), ids);
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
    Code Minimum;
    Code Maximum;
  };

  // Visits the points of all parts of a polyhedron, except the common apex.
  template <typename Visitor>
  void ForEachPoint(vtkIdType part, Visitor&& visit) const
  {
    const vtkIdType end = this->Filter.GetEndOfParts(part);
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
    bool mayBeInterior = true;
    this->ForEachPoint(part,
      [&](vtkIdType id)
      {
        range.Minimum = std::min(range.Minimum, codes[id]);
        range.Maximum = std::max(range.Maximum, codes[id]);
        mayBeInterior =
          mayBeInterior && this->Filter.SatisfiesCriteria(id) && !this->Context.IsPointBlanked(id);
      });
    return mayBeInterior ? range : Range{ 0, ExtractionValues::NoCode };
  }

  const ExtractionContext& Context;
  const InteriorCellFilter& Filter;
  const UnstructuredCells<Stored>& Cells;
  vtkIdType NumberOfPoints;
  // The range of codes of each polyhedron, indexed by original cell.
  ExtractionBuffer<Range> Ranges;
};

}

#endif
