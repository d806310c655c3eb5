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
 * The cells of port 1 of \a filter that are of one of \a kinds
 * (vtkTimeVaryingIntervalVolume::BoundaryKinds), with their points only and the point arrays. Cell
 * array `IntervalId` is the place of the kind among \a kinds, so that MakeVolumeOfIntervals() gives
 * each a colour.
 */
vtkSmartPointer<vtkUnstructuredGrid> MakeTimeBoundary(
  vtkTimeVaryingIntervalVolume* filter, const std::vector<int>& kinds);
}

#endif
