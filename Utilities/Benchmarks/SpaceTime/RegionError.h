// SPDX-License-Identifier: BSD-3-Clause
#ifndef RegionError_h
#define RegionError_h

#include "Benchmarks/Data/MovingFields.h"

class vtkUnstructuredGrid;

namespace interval4d
{
/**
 * Differences between tetrahedra, whose point array "f" is the field, and the analytic region of a
 * moving field at a time. Both differences are fractions of the volume of the analytic region.
 */
struct RegionError
{
  /// Volume between the surface of the tetrahedra and the analytic surface, to first order. The
  /// surface consists of the faces whose points all have the lower value or all have the upper
  /// value.
  double SymmetricDifference = 0.0;
  /// Error of the sum of signed volumes.
  double Volume = 0.0;
};

RegionError MeasureRegion(const MovingField& field, double time, vtkUnstructuredGrid* tetrahedra);
}

#endif
