// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_WholeCells_h
#define interlume_WholeCells_h

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
 * What one pass that keeps whole cells is told, and leaves for the pass of the next criterion.
 */
struct WholePass
{
  /// A mark for each point of the first pass's input, 0 where a criterion leaves it out; empty
  /// where there are no criteria.
  std::vector<unsigned char> Points;
  /// The first whole cell of the pass before, which are the last ones of its output; -1 in the
  /// first pass.
  vtkIdType First = -1;
  /// For each boundary triangle the whole cell of the same output that it is a face of, or -1;
  /// empty where no triangle is one.
  std::vector<vtkIdType> TriangleWholes;

  /// Marks the points of \a input that are outside of a criterion; call once for each.
  void Exclude(vtkDataArray* array, double lower, double upper);
};

/**
 * @class   WholeCells
 * @brief   which cells of an extraction's input may be passed on whole
 *
 * A further pass gets the whole cells of the one before as they were, and passes them on: they are
 * within all criteria.
 */
class WholeCells
{
public:
  /**
   * \a original is the input as it came. Where its polyhedra are replaced by cells with tables,
   * \a originals has for each of these the cell that it comes from; else it is null.
   */
  WholeCells(vtkDataSet* original, const std::vector<vtkIdType>* originals, const WholePass& pass);

  /// Returns whether a cell was whole in the pass before.
  bool IsPassed(vtkIdType cell) const { return cell >= this->FirstPassed; }
  vtkIdType GetFirstPassed() const { return this->FirstPassed; }

  /// Returns whether cells with this point may be whole.
  bool MayHave(vtkIdType point) const { return !this->Marks || this->Marks[point] != 0; }

  /// The following tell of cells that stand for polyhedra.
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
  /// Returns the cell after the last one that stands for the same polyhedron.
  vtkIdType GetEndOfParts(vtkIdType cell) const;
  bool IsFirstPart(vtkIdType cell) const
  {
    return cell == 0 || this->GetOriginal(cell - 1) != this->GetOriginal(cell);
  }

private:
  vtkDataSet* Original;
  const std::vector<vtkIdType>* Originals;
  // The types of the original cells, where some of them have parts.
  vtkSmartPointer<GridCells::Types> Types;
  const unsigned char* Marks;
  vtkIdType FirstPassed;
};

}

#endif
