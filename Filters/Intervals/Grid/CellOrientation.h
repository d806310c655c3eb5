// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellOrientation_h
#define interlume_CellOrientation_h

#include "Common/Prefetch.h"
#include "Grid/RowIndex.h"

#include "vtkDataSet.h"
#include "vtkIsotable.h"

#include <array>

class vtkPoints;

namespace interlume
{

/**
 * @class   CellOrientation
 * @brief   determines whether a cell's vertices are in left-handed order
 *
 * Uses the sign of the Jacobian at the center of the cell. All cells of image data and rectilinear
 * grids have the same sign. A degenerate cell counts as right-handed.
 */
class CellOrientation
{
public:
  explicit CellOrientation(vtkDataSet* input);

  /// Returns whether the orientation may differ between cells, so that IsInverted needs the points.
  bool IsPerCell() const { return this->Points != nullptr; }

  /// Prefetches the coordinates of a point that will be used soon.
  void Prefetch(vtkIdType point) const
  {
    if (this->Floats)
    {
      interlume::Prefetch::Read(this->Floats + 3 * point);
    }
    else if (this->Doubles)
    {
      interlume::Prefetch::Read(this->Doubles + 3 * point);
    }
  }

  /// Returns whether a cell is left-handed. \a points are in the vertex order of vtkIsotable.
  bool IsInverted(vtkIsotable::Shapes shape, const vtkIdType* points) const
  {
    return this->GetSign(shape, points) < 0;
  }

  /// Returns whether the cell of a structured grid whose vertex 0 is \a point is left-handed.
  bool IsInverted(const RowIndex& rows, vtkIdType point) const
  {
    if (!this->Points)
    {
      return this->AllInverted;
    }
    return this->IsInverted(vtkIsotable::HEXAHEDRON, GetVertices(rows, point).data());
  }

  /// Returns whether a cell is folded: its Jacobian is positive at some corners and negative at
  /// others. For example, a hexahedron with the point order of a voxel is folded and intersects
  /// itself.
  bool IsFolded(vtkIsotable::Shapes shape, const vtkIdType* points) const
  {
    return this->Points && shape != vtkIsotable::TETRAHEDRON && this->IsCellFolded(shape, points);
  }

  /// Returns whether the cell of a structured grid whose vertex 0 is \a point is folded.
  bool IsFolded(const RowIndex& rows, vtkIdType point) const
  {
    return this->Points &&
      this->IsCellFolded(vtkIsotable::HEXAHEDRON, GetVertices(rows, point).data());
  }

  /// Returns 1 for a right-handed, -1 for a left-handed and 0 for a degenerate cell.
  int GetSign(vtkIsotable::Shapes shape, const vtkIdType* points) const
  {
    return this->Points ? this->GetCellSign(shape, points) : this->AllInverted ? -1 : 1;
  }

private:
  static std::array<vtkIdType, 8> GetVertices(const RowIndex& rows, vtkIdType point)
  {
    std::array<vtkIdType, 8> vertices;
    for (int v = 0; v < 8; ++v)
    {
      vertices[v] = rows.GetVertex(point, v);
    }
    return vertices;
  }

  bool IsCellFolded(vtkIsotable::Shapes shape, const vtkIdType* points) const;
  int GetCellSign(vtkIsotable::Shapes shape, const vtkIdType* points) const;

  vtkPoints* Points = nullptr;
  const float* Floats = nullptr;
  const double* Doubles = nullptr;
  bool AllInverted = false;
};

}

#endif
