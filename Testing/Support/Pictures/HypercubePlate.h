// SPDX-License-Identifier: BSD-3-Clause
#ifndef HypercubePlate_h
#define HypercubePlate_h

#include "vtkSmartPointer.h" // for the source

class vtkAlgorithm;

namespace reference
{

/**
 * A temporal source of a square plate of cells x cells x 1 cubes of size 1, centred at (0, 0, 1/2),
 * whose point array `f` is 0 everywhere and always, at so many evenly spaced steps from 0 to
 * \a duration.
 *
 * \a isMoving: the points within the plate move by (0.4, 0.25, 0) meanwhile; its edges stay where
 * they are. (On a grid at rest every 4-simplex of a constant hypercube projects to a whole
 * tetrahedron, four on top of each other everywhere, and neglecting how long each lasts shows no
 * pattern.)
 */
vtkSmartPointer<vtkAlgorithm> MakeHypercubePlate(
  int cells, int steps, double duration, bool isMoving);

}

#endif
