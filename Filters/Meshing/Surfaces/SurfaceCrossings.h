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
 * @brief   where triangles of a surface pass through each other
 *
 * An edge crosses a triangle where its ends lie on two sides of the triangle's plane and the line
 * through it passes inside of the three edges: five signs of determinants, each taken for certain
 * only beyond the bound of its rounding (Shewchuk, Adaptive Precision Floating-Point Arithmetic,
 * 1997, error bound A of orient3d). So nothing is found that is not there; what touches, lies in
 * one plane or shares a point is left to TetGen, whose versions differ: 1.6 may run without end on
 * a surface that crosses itself.
 */
class SurfaceCrossings
{
public:
  /// Finds the input cells of triangles that cross others, each once, in order.
  static std::vector<vtkIdType> FindCells(const ClosedSurface& surface);
};

}

#endif
