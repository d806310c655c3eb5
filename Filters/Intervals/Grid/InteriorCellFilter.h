// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_InteriorCellFilter_h
#define interlume_InteriorCellFilter_h

#include "Common/GridCells.h"
#include "Grid/CellCorners.h"

#include "vtkDataSet.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

class vtkDataArray;

namespace interlume
{

/**
 * Data on interior cells that each pass reads and then updates for the next pass. The first pass
 * extracts the intervals, and each further pass applies one criterion.
 */
struct InteriorCellPass
{
  /// One mark per input point of the first pass: 0 if a criterion excludes the point. Empty if
  /// there are no criteria, and in further passes.
  std::vector<unsigned char> Points;
  /// Index of the first interior cell in the output of the previous pass, where interior cells come
  /// last; -1 in the first pass.
  vtkIdType First = -1;
  /// For each boundary triangle of that output, the interior cell of which it is a face, or -1.
  /// Empty if no triangle is a face of an interior cell.
  std::vector<vtkIdType> TriangleInteriorCells;

  /// Excludes the points that do not satisfy a criterion. Call it once per criterion.
  void ExcludePointsOutside(vtkDataArray* array, double lower, double upper);
};

/**
 * @class   InteriorCellFilter
 * @brief   selects input cells that may be copied as interior cells
 *
 * Each pass after the first copies the interior cells of the previous pass unchanged, since they
 * satisfy all criteria.
 */
class InteriorCellFilter
{
public:
  /**
   * \a original is the input of the filter. If its polyhedra were replaced with cells that have
   * isotables, \a originals maps each cell to its original cell; otherwise it is null.
   */
  InteriorCellFilter(
    vtkDataSet* original, const std::vector<vtkIdType>* originals, const InteriorCellPass& pass);

  /// Returns whether a cell was an interior cell in the previous pass.
  bool IsPassedThrough(vtkIdType cell) const { return cell >= this->FirstPassed; }
  vtkIdType GetFirstPassedCell() const { return this->FirstPassed; }

  /// Returns whether cells with this point may be interior.
  bool SatisfiesCriteria(vtkIdType point) const { return !this->Marks || this->Marks[point] != 0; }

  /// The following functions describe cells that replace polyhedra.
  vtkDataSet* GetOriginal() const { return this->Original; }
  bool HasParts() const { return this->Types != nullptr; }
  vtkIdType GetOriginal(vtkIdType cell) const { return (*this->Originals)[cell]; }
  unsigned char GetOriginalType(vtkIdType cell) const
  {
    return this->Types->GetValue(this->GetOriginal(cell));
  }
  bool IsPart(vtkIdType cell) const
  {
    return this->HasParts() &&
      CellCorners::Of(this->GetOriginalType(cell)).Kind == CellCorners::POLYHEDRAL;
  }
  /// Returns the cell after the last one that replaces the same polyhedron.
  vtkIdType GetEndOfParts(vtkIdType cell) const;
  bool IsFirstPart(vtkIdType cell) const
  {
    return cell == 0 || this->GetOriginal(cell - 1) != this->GetOriginal(cell);
  }

private:
  vtkDataSet* Original;
  const std::vector<vtkIdType>* Originals;
  // Types of the original cells, if some were replaced.
  vtkSmartPointer<GridCells::Types> Types;
  const unsigned char* Marks;
  vtkIdType FirstPassed;
};

}

#endif
