// SPDX-License-Identifier: BSD-3-Clause
#ifndef TimeBoundary_h
#define TimeBoundary_h

#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

class vtkTimeVaryingIntervalVolume;

namespace gallery
{
/**
 * Returns the cells of port 1 of \a filter whose kind is one of \a kinds
 * (vtkTimeVaryingIntervalVolume::BoundaryKinds), with their points and point arrays. The cell array
 * `IntervalId` is the index of the kind in \a kinds, so that MakeVolumeOfIntervals() colors each
 * kind.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeTimeBoundary(
  vtkTimeVaryingIntervalVolume* filter, const std::vector<int>& kinds);
}

#endif
