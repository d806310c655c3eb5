// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RowIndex_h
#define interlume_RowIndex_h

#include "Grid/GridCellRange.h"

#include "vtkType.h"

#include <algorithm>
#include <array>

namespace interlume
{

/**
 * @class   RowIndex
 * @brief   64-bit index arithmetic of a structured (i, j, k) grid
 *
 * Points are numbered along i, then j, then k. The index of a row of points is j + k * nj, and that
 * of a row of cells is j + k * (nj - 1). The rows may be restricted to a window of the grid. Then
 * ids of points and cells, and indices along axes, refer to the grid, while rows, and j and k of a
 * row, refer to the window.
 */
class RowIndex
{
public:
  explicit RowIndex(const int dimensions[3])
    : RowIndex(dimensions, GridCellRange(dimensions))
  {
  }
  RowIndex(const int dimensions[3], const GridCellRange& window)
    : Nj(window.Last[1] - window.First[1] + 1)
    , Nk(window.Last[2] - window.First[2] + 1)
    , GridNi(dimensions[0])
    , GridNj(dimensions[1])
    , GridNk(dimensions[2])
    , First(window.First)
    , InverseNj(1.0 / static_cast<double>(std::max<vtkIdType>(Nj, 1)))
    , InverseGridNi(1.0 / static_cast<double>(std::max(dimensions[0], 1)))
    , InverseGridNj(1.0 / static_cast<double>(std::max(dimensions[1], 1)))
  {
  }

  vtkIdType GetNumberOfRows() const { return this->Nj * this->Nk; }
  vtkIdType GetRow(vtkIdType j, vtkIdType k) const { return j + k * this->Nj; }
  vtkIdType GetJ(vtkIdType row) const { return row - this->GetK(row) * this->Nj; }
  vtkIdType GetK(vtkIdType row) const { return Divide(row, this->Nj, this->InverseNj); }
  vtkIdType GetFirstPoint(vtkIdType row) const
  {
    const vtkIdType j = this->First[1] + this->GetJ(row);
    const vtkIdType k = this->First[2] + this->GetK(row);
    return this->First[0] + (j + k * this->GridNj) * this->GridNi;
  }

  /// Returns whether a row of cells starts at the row of points (j, k).
  bool HasCells(vtkIdType j, vtkIdType k) const { return j + 1 < this->Nj && k + 1 < this->Nk; }

  /// Returns the index, in the grid, of the row of cells that starts at the row of points (j, k).
  /// For the last rows of points, returns the preceding row of cells.
  vtkIdType GetCellRow(vtkIdType j, vtkIdType k) const
  {
    return this->First[1] + std::min(j, this->Nj - 2) +
      (this->First[2] + std::min(k, this->Nk - 2)) * (this->GridNj - 1);
  }
  vtkIdType GetFirstCell(vtkIdType j, vtkIdType k) const
  {
    return this->First[0] + this->GetCellRow(j, k) * (this->GridNi - 1);
  }

  /// Returns the difference between the ids of adjacent points along an axis.
  vtkIdType GetStep(int axis) const
  {
    return axis == 0 ? 1 : axis == 1 ? this->GridNi : this->GridNi * this->GridNj;
  }

  /// Returns the point id of \a vertex, 0 to 7 in the order of VTK_VOXEL, of the cell whose vertex
  /// 0 is \a point.
  vtkIdType GetVertex(vtkIdType point, int vertex) const
  {
    return point + (vertex & 1) + ((vertex >> 1) & 1) * this->GetStep(1) +
      (vertex >> 2) * this->GetStep(2);
  }

  std::array<int, 3> GetIjk(vtkIdType point) const
  {
    const vtkIdType row = Divide(point, this->GridNi, this->InverseGridNi);
    const vtkIdType k = Divide(row, this->GridNj, this->InverseGridNj);
    return { { static_cast<int>(point - row * this->GridNi),
      static_cast<int>(row - k * this->GridNj), static_cast<int>(k) } };
  }

  /// Returns the axis along which two neighbors differ, or 0 for equal points.
  int GetAxis(vtkIdType a, vtkIdType b) const
  {
    const vtkIdType step = a < b ? b - a : a - b;
    // An axis with one point must be skipped because its step may equal that of the next axis.
    return this->GridNk > 1 && step == this->GetStep(2) ? 2
      : this->GridNj > 1 && step == this->GetStep(1)    ? 1
                                                        : 0;
  }

private:
  // Computes a / b for 0 <= a < 2^51. A 64-bit integer division takes several times as long. The
  // rounded product may be one too small, but never too large.
  static vtkIdType Divide(vtkIdType a, vtkIdType b, double inverse)
  {
    const vtkIdType near = static_cast<vtkIdType>(static_cast<double>(a) * inverse);
    return near + (a - near * b >= b);
  }

  vtkIdType Nj;
  vtkIdType Nk;
  vtkIdType GridNi;
  vtkIdType GridNj;
  vtkIdType GridNk;
  std::array<vtkIdType, 3> First;
  double InverseNj;
  double InverseGridNi;
  double InverseGridNj;
};

}

#endif
