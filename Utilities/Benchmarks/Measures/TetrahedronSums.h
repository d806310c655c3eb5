// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedronSums_h
#define TetrahedronSums_h

#include "vtkType.h"

class vtkUnstructuredGrid;

/**
 * Volumes of the tetrahedra of a grid, added up. A tetrahedron is inverted when its signed volume
 * is below -1e-12 of the cube of its longest edge: what is flatter than rounding has no
 * orientation.
 */
struct TetrahedronSums
{
  vtkIdType Tetrahedra = 0;
  vtkIdType Inverted = 0;
  /// Signed, so that what an inverted one covers twice is taken off once.
  double Volume = 0.0;
  /// Volume of the inverted ones, positive.
  double InvertedVolume = 0.0;
  /// Every volume taken positive.
  double AbsoluteVolume = 0.0;

  double GetInvertedShare() const;
  double GetInvertedVolumeShare() const;
};

/**
 * The sums over the VTK_TETRA cells of \a grid.
 */
TetrahedronSums SumTetrahedra(vtkUnstructuredGrid* grid);

#endif
