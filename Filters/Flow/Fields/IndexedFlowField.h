// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_IndexedFlowField_h
#define interlume_IndexedFlowField_h

#include "Cells/Trilinear.h"
#include "Fields/FieldPartition.h"
#include "Fields/FlowField.h"

#include <algorithm>

namespace interlume
{

/**
 * @class   IndexedFlowField
 * @brief   field whose cells have indices (i, j, k): images, rectilinear and structured grids
 *
 * The local coordinates p are in [0,1]^3 along i, j and k. Faces 0 to 5 are -i, +i, -j, +j, -k, +k.
 * Indices start at 0, whatever the extent of the dataset.
 *
 * If only a partition of the grid is available, cell ids and indices refer to the full grid, and
 * point ids to the partition. Only available cells may be accessed.
 */
class IndexedFlowField : public FlowField
{
public:
  /// A cell, its first corner point, and its indices (i, j, k).
  struct CellLocation
  {
    vtkIdType Cell = 0;
    vtkIdType Point = 0;
    int Index[3] = { 0, 0, 0 };
  };

  bool IsCellIncluded(vtkIdType cell) const
  {
    return !this->HasExcludedCells() || FlowField::IsCellIncluded(this->GetLocalCellId(cell));
  }

  CellLocation GetCellLocation(const int index[3]) const
  {
    CellLocation location;
    location.Point = this->FirstPoint;
    for (int axis = 0; axis < 3; ++axis)
    {
      location.Index[axis] = index[axis];
      location.Cell += index[axis] * this->CellStrides[axis];
      location.Point += index[axis] * this->PointStrides[axis];
    }
    return location;
  }

  CellLocation GetCellLocation(vtkIdType cell) const
  {
    const int index[3] = { static_cast<int>(cell % this->Cells[0]),
      static_cast<int>(cell / this->CellStrides[1] % this->Cells[1]),
      static_cast<int>(cell / this->CellStrides[2]) };
    return this->GetCellLocation(index);
  }

  /// Returns the location of a cell from its id in the partition.
  CellLocation GetHeldCellLocation(vtkIdType cell) const
  {
    const int index[3] = { this->HeldFirst[0] + static_cast<int>(cell % this->HeldCells[0]),
      this->HeldFirst[1] + static_cast<int>(cell / this->HeldCells[0] % this->HeldCells[1]),
      this->HeldFirst[2] + static_cast<int>(cell / this->HeldCells[0] / this->HeldCells[1]) };
    return this->GetCellLocation(index);
  }

  /// Returns whether a face is on the boundary of the grid.
  bool IsOutside(const CellLocation& location, int face) const
  {
    const int axis = face >> 1;
    return location.Index[axis] == (face & 1 ? this->Cells[axis] - 1 : 0);
  }

  /// Returns whether this process traces streamlines in a cell.
  static constexpr bool IsHere(const CellLocation&) { return true; }

  /// Same as Step(), but moves only to cells in which this process traces streamlines.
  bool StepHere(CellLocation& location, int face) const { return this->Step(location, face); }

  /// Moves to the cell across a face. Returns false, without changes, if that cell does not exist
  /// or is excluded.
  bool Step(CellLocation& location, int face) const
  {
    if (this->IsOutside(location, face))
    {
      return false;
    }
    const int axis = face >> 1;
    const int step = face & 1 ? 1 : -1;
    const vtkIdType cell = location.Cell + step * this->CellStrides[axis];
    if (!this->IsCellIncluded(cell))
    {
      return false;
    }
    location.Cell = cell;
    location.Point += step * this->PointStrides[axis];
    location.Index[axis] += step;
    return true;
  }

  /**
   * Finds the cell at \a q, a position in units of cells along each axis, even if it is excluded,
   * and the local position. Positions up to \a slack outside the grid are moved to its boundary.
   * Returns false for positions farther outside.
   */
  bool FindIndex(const double q[3], const double slack[3], int index[3], double p[3]) const;

  /// Prefetches the vectors at the corners of the neighbor across a face that are not on the face.
  void Prefetch(const CellLocation& location, int face) const
  {
    this->ForEachNeighborCorner(
      location, face, [this](vtkIdType point) { this->PrefetchVector(point); });
  }

  /// Returns the point id of a corner of the cell. Corners are ordered with x varying fastest.
  vtkIdType GetCorner(const CellLocation& location, int corner) const
  {
    return location.Point + this->CornerOffsets[corner];
  }
  void GetVectors(const CellLocation& location, Trilinear& vectors) const
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->GetVector(this->GetCorner(location, corner), vectors.C[corner]);
      vectors.C[corner][3] = 0.0;
    }
  }
  /// Copies the values at the corners to the first column and clears the other columns.
  void GetValues(int array, const CellLocation& location, Trilinear& values) const
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      values.Clear(corner);
      values.C[corner][0] = this->GetValue(array, this->GetCorner(location, corner));
    }
  }

  /// Computes the position on a face as fractions of the grid's extent along the two axes parallel
  /// to the face.
  void GetParameters(const CellLocation& location, int face, const double p[3], double uv[2]) const
  {
    int direction = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (axis != face >> 1)
      {
        const double part = (location.Index[axis] + p[axis]) / this->Cells[axis];
        uv[direction++] = std::min(std::max(part, 0.0), 1.0);
      }
    }
  }

protected:
  IndexedFlowField() = default;
  ~IndexedFlowField() = default;

  /// Sets the dimensions, the arrays and the blanking, but not the geometry. Returns an error as
  /// Build() does.
  Error BuildTopologyAndArrays(vtkDataSet* data, const int points[3], vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays, const StageProgress& progress,
    const FieldPartition* part = nullptr);

  /// Collects the speeds at those points of the available cells for which isCounted(index) returns
  /// true. \a index contains the point's (i, j, k) in the full grid.
  SpeedCount CountLocalSpeeds(const std::function<bool(const int index[3])>& isCounted) const;

  /// Finds the cell as FindIndex() does. If that cell is excluded, finds an included cell with that
  /// position on its boundary.
  bool Find(const double q[3], const double slack[3], CellLocation& location, double p[3]) const;

  /// Calls visit(point) for the corners of the neighbor across a face that are not on the face.
  template <typename Visitor>
  void ForEachNeighborCorner(const CellLocation& location, int face, Visitor&& visit) const
  {
    if (!this->IsOutside(location, face))
    {
      for (const vtkIdType offset : this->NeighborOffsets[face])
      {
        visit(location.Point + offset);
      }
    }
  }

  /// Writes the point ids of a cell to \a points, given the cell id in the partition. Returns 8.
  int GetLocalCellPoints(vtkIdType cell, vtkIdType* points) const;

  int Cells[3] = { 0, 0, 0 };
  vtkIdType CellStrides[3] = { 1, 0, 0 };
  vtkIdType PointStrides[3] = { 1, 0, 0 };

private:
  bool IsPart() const
  {
    return this->FirstPoint != 0 || this->Cells[0] != this->HeldCells[0] ||
      this->Cells[1] != this->HeldCells[1] || this->Cells[2] != this->HeldCells[2];
  }
  /// Returns the id that a cell of the full grid has in the partition.
  vtkIdType GetLocalCellId(vtkIdType cell) const
  {
    return this->IsPart() ? this->GetLocalCellId(this->GetCellLocation(cell)) : cell;
  }
  vtkIdType GetLocalCellId(const CellLocation& location) const;

  bool FindIncludedNeighbor(const double slack[3], CellLocation& location, double p[3]) const;

  // (i, j, k) of the first available point, number of available cells along each axis, and the
  // point id that the first point of the full grid would have in the partition (0 or negative).
  int HeldFirst[3] = { 0, 0, 0 };
  int HeldCells[3] = { 0, 0, 0 };
  vtkIdType FirstPoint = 0;
  vtkIdType CornerOffsets[8] = { 0, 0, 0, 0, 0, 0, 0, 0 };
  /// For each face, the neighbor's corners that are not on the face, as offsets of their point ids
  /// from the current cell's first point.
  vtkIdType NeighborOffsets[6][4] = {};
};

}

#endif
