// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_IndexedFlowField_h
#define interlume_IndexedFlowField_h

#include "Cells/Trilinear.h"
#include "Fields/FieldPart.h"
#include "Fields/FlowField.h"

#include <algorithm>

namespace interlume
{

/**
 * @class   IndexedFlowField
 * @brief   fields whose cells have the indices (i, j, k): images, rectilinear and structured grids
 *
 * p of a cell is in [0,1]^3 along i, j and k. Faces 0 to 5 are -i, +i, -j, +j, -k, +k. Indices
 * count from 0, whatever the extent.
 *
 * Where a part of the grid is held, cells and indices are those of the whole, points those of the
 * part, and only cells that are held may be asked for.
 */
class IndexedFlowField : public FlowField
{
public:
  /// A cell, and its first corner.
  struct Place
  {
    vtkIdType Cell = 0;
    vtkIdType Point = 0;
    int Index[3] = { 0, 0, 0 };
  };

  bool IsCellIncluded(vtkIdType cell) const
  {
    return !this->HasExcludedCells() || FlowField::IsCellIncluded(this->GetHeldCell(cell));
  }

  Place GetPlace(const int index[3]) const
  {
    Place place;
    place.Point = this->FirstPoint;
    for (int axis = 0; axis < 3; ++axis)
    {
      place.Index[axis] = index[axis];
      place.Cell += index[axis] * this->CellStrides[axis];
      place.Point += index[axis] * this->PointStrides[axis];
    }
    return place;
  }

  Place GetPlace(vtkIdType cell) const
  {
    const int index[3] = { static_cast<int>(cell % this->Cells[0]),
      static_cast<int>(cell / this->CellStrides[1] % this->Cells[1]),
      static_cast<int>(cell / this->CellStrides[2]) };
    return this->GetPlace(index);
  }

  /// Returns the cell with a number among those that are held.
  Place GetHeldPlace(vtkIdType cell) const
  {
    const int index[3] = { this->HeldFirst[0] + static_cast<int>(cell % this->HeldCells[0]),
      this->HeldFirst[1] + static_cast<int>(cell / this->HeldCells[0] % this->HeldCells[1]),
      this->HeldFirst[2] + static_cast<int>(cell / this->HeldCells[0] / this->HeldCells[1]) };
    return this->GetPlace(index);
  }

  /// Returns whether a face is on the outside of the grid.
  bool IsOutside(const Place& place, int face) const
  {
    const int axis = face >> 1;
    return place.Index[axis] == (face & 1 ? this->Cells[axis] - 1 : 0);
  }

  /// Returns whether streamlines may go on in a cell.
  static constexpr bool IsHere(const Place&) { return true; }

  /// Goes to the cell beyond a face, if streamlines may go on there, as Step does.
  bool StepHere(Place& place, int face) const { return this->Step(place, face); }

  /// Goes to the cell beyond a face. Returns false, and changes nothing, where no cell there is
  /// part of the field.
  bool Step(Place& place, int face) const
  {
    if (this->IsOutside(place, face))
    {
      return false;
    }
    const int axis = face >> 1;
    const int way = face & 1 ? 1 : -1;
    const vtkIdType cell = place.Cell + way * this->CellStrides[axis];
    if (!this->IsCellIncluded(cell))
    {
      return false;
    }
    place.Cell = cell;
    place.Point += way * this->PointStrides[axis];
    place.Index[axis] += way;
    return true;
  }

  /**
   * Finds the cell that \a q, in cells along each axis, is in, part of the field or not, and the
   * place there. A place up to \a slack beyond the grid's faces counts as on them. Returns false
   * beyond that.
   */
  bool FindIndex(const double q[3], const double slack[3], int index[3], double p[3]) const;

  /// Prefetches the vectors that the neighbour has and the cell has not.
  void Prefetch(const Place& place, int face) const
  {
    this->ForEachCornerBeyond(
      place, face, [this](vtkIdType point) { this->PrefetchVector(point); });
  }

  /// Returns a point of the cell by its corner of [0,1]^3, x fastest.
  vtkIdType GetCorner(const Place& place, int corner) const
  {
    return place.Point + this->CornerOffsets[corner];
  }
  void GetVectors(const Place& place, Trilinear& vectors) const
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->GetVector(this->GetCorner(place, corner), vectors.C[corner]);
      vectors.C[corner][3] = 0.0;
    }
  }
  /// Copies the corners' values to the first column; the others become 0.
  void GetValues(int array, const Place& place, Trilinear& values) const
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      values.Clear(corner);
      values.C[corner][0] = this->GetValue(array, this->GetCorner(place, corner));
    }
  }

  /// Computes the place on a face in parts of the grid.
  void GetParameters(const Place& place, int face, const double p[3], double uv[2]) const
  {
    int direction = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (axis != face >> 1)
      {
        const double part = (place.Index[axis] + p[axis]) / this->Cells[axis];
        uv[direction++] = std::min(std::max(part, 0.0), 1.0);
      }
    }
  }

protected:
  IndexedFlowField() = default;
  ~IndexedFlowField() = default;

  /// Takes the numbers of points, the arrays and the blanking, all but the geometry. Returns an
  /// error as Build does.
  Error BuildIndices(vtkDataSet* data, const int points[3], vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays, const StageProgress& progress,
    const FieldPart* part = nullptr);

  /// Counts the speeds in those points of the cells that \a isCounted is true of, by index.
  SpeedCount CountHeldSpeeds(const std::function<bool(const int index[3])>& isCounted) const;

  /// Finds the cell as FindIndex does. Where it is not part of the field, one that is and that
  /// shares the place is taken.
  bool Find(const double q[3], const double slack[3], Place& place, double p[3]) const;

  /// Calls visit(point) for those corners of a face's neighbour that are not on the face.
  template <typename Visitor>
  void ForEachCornerBeyond(const Place& place, int face, Visitor&& visit) const
  {
    if (!this->IsOutside(place, face))
    {
      for (const vtkIdType offset : this->OffsetsBeyond[face])
      {
        visit(place.Point + offset);
      }
    }
  }

  /// Gives the points of a cell by its number among those that are held.
  int GetHeldPoints(vtkIdType cell, vtkIdType* points) const;

  int Cells[3] = { 0, 0, 0 };
  vtkIdType CellStrides[3] = { 1, 0, 0 };
  vtkIdType PointStrides[3] = { 1, 0, 0 };

private:
  bool IsPart() const
  {
    return this->FirstPoint != 0 || this->Cells[0] != this->HeldCells[0] ||
      this->Cells[1] != this->HeldCells[1] || this->Cells[2] != this->HeldCells[2];
  }
  /// Returns the number of a cell among those that are held, which are the rows of the dataset.
  vtkIdType GetHeldCell(vtkIdType cell) const
  {
    return this->IsPart() ? this->GetHeldCell(this->GetPlace(cell)) : cell;
  }
  vtkIdType GetHeldCell(const Place& place) const;

  bool Settle(const double slack[3], Place& place, double p[3]) const;

  // The index of the first point that is held, the number of cells that are, and where the first
  // point of the whole grid would be among the points.
  int HeldFirst[3] = { 0, 0, 0 };
  int HeldCells[3] = { 0, 0, 0 };
  vtkIdType FirstPoint = 0;
  vtkIdType CornerOffsets[8] = { 0, 0, 0, 0, 0, 0, 0, 0 };
  /// Those of the corners that the neighbour beyond a face has and the cell has not.
  vtkIdType OffsetsBeyond[6][4] = {};
};

}

#endif
