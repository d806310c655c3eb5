// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceCrossings_h
#define interlume_SurfaceCrossings_h

#include "vtkType.h"

#include <vector>

namespace interlume
{

class ClosedSurface;

/**
 * @class   SurfaceCrossings
 * @brief   finds triangles of a surface that pass through each other
 *
 * An edge crosses a triangle if its ends are on different sides of the triangle's plane and the
 * line through the edge passes inside the triangle's three edges. This test requires the signs of
 * five determinants. A sign is used only if the determinant exceeds its rounding error bound (J. R.
 * Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
 * Discrete & Computational Geometry 18, 1997, bound A of orient3d). Therefore there are no false
 * positives. Triangles that touch, are coplanar or share a point are left to TetGen. Crossings are
 * checked here because TetGen 1.6 may not terminate on a surface that intersects itself.
 */
class SurfaceCrossings
{
public:
  /// Returns the input cells of crossing triangles, sorted and without duplicates.
  static std::vector<vtkIdType> FindCells(const ClosedSurface& surface);
};

}

#endif
