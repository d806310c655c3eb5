// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellCorners_h
#define interlume_CellCorners_h

#include "vtkIsotable.h"
#include "vtkType.h"

namespace interlume
{

/**
 * @class   CellCorners
 * @brief   which corners of a VTK cell are the vertices of an isotable
 */
class CellCorners
{
public:
  enum Support
  {
    LINEAR,
    /// The cell is taken by its corners.
    HIGHER_ORDER,
    LOWER_DIMENSIONAL,
    /// The cell needs its faces.
    POLYHEDRAL,
    UNSUPPORTED
  };

  Support Kind = UNSUPPORTED;
  vtkIsotable::Shapes Shape = vtkIsotable::TETRAHEDRON;
  int NumberOfCorners = 0;
  /// Whether corners 2 and 3, 6 and 7 change places (VTK_HEXAHEDRON goes around its faces).
  bool Turned = false;

  bool HasTable() const { return this->Kind == LINEAR || this->Kind == HIGHER_ORDER; }

  /// Returns the type of the linear cell that a cell of a higher order is taken for.
  unsigned char GetLinearType() const;

  static CellCorners Of(int cellType);
};

}

#endif
