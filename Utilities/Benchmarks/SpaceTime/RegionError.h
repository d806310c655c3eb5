// SPDX-License-Identifier: BSD-3-Clause
#ifndef RegionError_h
#define RegionError_h

#include "Benchmarks/Data/MovingFields.h"

class vtkUnstructuredGrid;

namespace interval4d
{
/**
 * Errors of a region that consists of tetrahedra, relative to the analytic region of a moving field
 * at one time. The tetrahedra must have the field as a point array. Both errors are divided by the
 * volume of the analytic region.
 */
struct RegionError
{
  /// Volume between the surface of the tetrahedra and the analytic surface, to first order. The
  /// surface consists of the triangles whose three points all have the lower bound or all have the
  /// upper bound as their value.
  double SymmetricDifference = 0.0;
  /// Absolute error of the volume, which is computed as the sum of the signed volumes of all
  /// tetrahedra.
  double Volume = 0.0;
};

RegionError MeasureRegionError(
  const MovingField& field, double time, vtkUnstructuredGrid* tetrahedra);
}

#endif
