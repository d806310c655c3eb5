// SPDX-License-Identifier: BSD-3-Clause
#ifndef HypercubePlate_h
#define HypercubePlate_h

#include "vtkSmartPointer.h" // for the source

class vtkAlgorithm;

namespace reference
{

/**
 * Returns a temporal source of a square plate of cells x cells x 1 unit cubes, centered at (0, 0,
 * 1/2). Its point array `f` is always 0. There are \a steps evenly spaced time steps from 0 to \a
 * duration.
 *
 * If \a isMoving, interior points move by (0.4, 0.25, 0) during this time. Without motion, even a
 * rendering that neglects the duration of 4-simplices would be uniform: on a static grid, every
 * 4-simplex of a constant hypercube projects to a complete tetrahedron, and four of them overlap
 * everywhere.
 */
vtkSmartPointer<vtkAlgorithm> MakeHypercubePlate(
  int cells, int steps, double duration, bool isMoving);

}

#endif
