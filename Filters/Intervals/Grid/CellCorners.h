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
    LOWER_DIMENSIONAL,
    /// The cell is a polyhedron, which is defined by its faces.
    POLYHEDRAL,
    UNSUPPORTED
  };

  Support Kind = UNSUPPORTED;
  vtkIsotable::Shapes Shape = vtkIsotable::TETRAHEDRON;
  int NumberOfCorners = 0;
  /// If true, corners 2 and 3, and 6 and 7, are swapped (VTK_HEXAHEDRON orders the corners of a
  /// quadrilateral cyclically).
  bool Turned = false;

  bool HasTable() const { return this->Kind == LINEAR || this->Kind == HIGHER_ORDER; }

  /// Returns the type of the linear cell that replaces a higher-order cell.
  unsigned char GetLinearType() const;

  static CellCorners Of(int cellType);
};

}

#endif
