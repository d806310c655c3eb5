// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellCorners_h
#define interlume_CellCorners_h

#include "vtkIsotable.h"
#include "vtkType.h"

namespace interlume
{

/**
 * @class   CellCorners
 * @brief   maps the corners of a VTK cell type to the vertices of an isotable
 */
class CellCorners
{
public:
  enum Support
  {
    LINEAR,
    /// The cell is treated as linear, using only its corner points.
    HIGHER_ORDER,
    /// The cell is two-dimensional. A polygon or a strip has no fixed number of corners, which is
    /// therefore 0.
    SURFACE,
    /// The cell has fewer than two dimensions.
    LOWER_DIMENSIONAL,
    /// The cell is a polyhedron, which is defined by its faces.
    POLYHEDRAL,
    UNSUPPORTED
  };

  Support Kind = UNSUPPORTED;
  vtkIsotable::Shapes Shape = vtkIsotable::TETRAHEDRON;
  int NumberOfCorners = 0;
  /// If true, corners 2 and 3, and 6 and 7, are swapped (VTK_HEXAHEDRON and VTK_QUAD order the
  /// corners of a quadrilateral cyclically).
  bool Turned = false;

  /// Returns whether an extraction from cells of the given dimension has a table for the cell.
  bool HasTable(int dimension = 3) const
  {
    return dimension == 2 ? this->Kind == SURFACE && this->NumberOfCorners > 0
                          : this->Kind == LINEAR || this->Kind == HIGHER_ORDER;
  }

  /// Returns whether the cell has fewer than three dimensions.
  bool IsLowerDimensional() const
  {
    return this->Kind == SURFACE || this->Kind == LOWER_DIMENSIONAL;
  }

  /// Returns the type of the linear cell that replaces a higher-order cell.
  unsigned char GetLinearType() const;

  static CellCorners Of(int cellType);
};

}

#endif
