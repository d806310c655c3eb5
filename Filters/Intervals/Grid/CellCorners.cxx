// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/CellCorners.h"

#include "vtkCellType.h"

namespace interlume
{

CellCorners CellCorners::Of(int cellType)
{
  constexpr Support linear = LINEAR;
  constexpr Support higher = HIGHER_ORDER;
  switch (cellType)
  {
    case VTK_TETRA:
      return { linear, vtkIsotable::TETRAHEDRON, 4, false };
    case VTK_PYRAMID:
      return { linear, vtkIsotable::PYRAMID, 5, false };
    case VTK_WEDGE:
      return { linear, vtkIsotable::WEDGE, 6, false };
    case VTK_VOXEL:
      return { linear, vtkIsotable::HEXAHEDRON, 8, false };
    case VTK_HEXAHEDRON:
      return { linear, vtkIsotable::HEXAHEDRON, 8, true };
    case VTK_QUADRATIC_TETRA:
    case VTK_HIGHER_ORDER_TETRAHEDRON:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return { higher, vtkIsotable::TETRAHEDRON, 4, false };
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_PYRAMID:
    case VTK_HIGHER_ORDER_PYRAMID:
    case VTK_LAGRANGE_PYRAMID:
    case VTK_BEZIER_PYRAMID:
      return { higher, vtkIsotable::PYRAMID, 5, false };
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_LINEAR_WEDGE:
    case VTK_BIQUADRATIC_QUADRATIC_WEDGE:
    case VTK_HIGHER_ORDER_WEDGE:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return { higher, vtkIsotable::WEDGE, 6, false };
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON:
    case VTK_HIGHER_ORDER_HEXAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      return { higher, vtkIsotable::HEXAHEDRON, 8, true };
    case VTK_POLYHEDRON:
    case VTK_PENTAGONAL_PRISM:
    case VTK_HEXAGONAL_PRISM:
      return { POLYHEDRAL, vtkIsotable::TETRAHEDRON, 0, false };
    case VTK_CONVEX_POINT_SET:
      return {};
    case VTK_TRIANGLE:
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_BIQUADRATIC_TRIANGLE:
    case VTK_HIGHER_ORDER_TRIANGLE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return { SURFACE, vtkIsotable::TRIANGLE, 3, false };
    case VTK_PIXEL:
      return { SURFACE, vtkIsotable::QUADRILATERAL, 4, false };
    case VTK_QUAD:
    case VTK_QUADRATIC_QUAD:
    case VTK_QUADRATIC_LINEAR_QUAD:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_HIGHER_ORDER_QUAD:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return { SURFACE, vtkIsotable::QUADRILATERAL, 4, true };
    case VTK_POLYGON:
    case VTK_QUADRATIC_POLYGON:
    case VTK_TRIANGLE_STRIP:
      return { SURFACE, vtkIsotable::TRIANGLE, 0, false };
    default:
      return { LOWER_DIMENSIONAL, vtkIsotable::TETRAHEDRON, 0, false };
  }
}

unsigned char CellCorners::GetLinearType() const
{
  switch (this->Shape)
  {
    case vtkIsotable::TETRAHEDRON:
      return VTK_TETRA;
    case vtkIsotable::PYRAMID:
      return VTK_PYRAMID;
    case vtkIsotable::WEDGE:
      return VTK_WEDGE;
    default:
      return VTK_HEXAHEDRON;
  }
}

}
