// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedronSums_h
#define TetrahedronSums_h

#include "vtkType.h"

class vtkUnstructuredGrid;

/**
 * Numbers and volumes of tetrahedra. A tetrahedron counts as inverted if its signed volume is below
 * -1e-12 times the cube of its longest edge. The sign of smaller volumes depends on rounding.
 */
struct TetrahedronSums
{
  vtkIdType Tetrahedra = 0;
  vtkIdType Inverted = 0;
  /// Sum of the signed volumes. An inverted tetrahedron subtracts the volume in which its neighbors
  /// overlap.
  double Volume = 0.0;
  /// Sum of the absolute volumes of inverted tetrahedra.
  double InvertedVolume = 0.0;
  /// Sum of the absolute volumes of all tetrahedra.
  double AbsoluteVolume = 0.0;

  double GetInvertedFraction() const;
  double GetInvertedVolumeFraction() const;
};

/**
 * Returns the sums over the VTK_TETRA cells of \a grid.
 */
TetrahedronSums SumTetrahedra(vtkUnstructuredGrid* grid);

#endif
