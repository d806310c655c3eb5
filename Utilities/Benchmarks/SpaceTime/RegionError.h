// SPDX-License-Identifier: BSD-3-Clause
#ifndef RegionError_h
#define RegionError_h

#include "Benchmarks/Data/MovingFields.h"

class vtkUnstructuredGrid;

namespace interval4d
{
/**
 * How far tetrahedra with the field as the point array "f" are from the analytic region of a moving
 * field at a time. Both are shares of that region's volume.
 */
struct RegionError
{
  /// The volume between the surface of the tetrahedra, which is the faces all of whose points have
  /// the lower or all the upper value, and the analytic surface; to first order.
  double SymmetricDifference = 0.0;
  /// Of the sum of signed volumes.
  double Volume = 0.0;
};

RegionError MeasureRegion(const MovingField& field, double time, vtkUnstructuredGrid* tetrahedra);
}

#endif
