// SPDX-License-Identifier: BSD-3-Clause
#ifndef DeltaWing_h
#define DeltaWing_h

#include "Gallery/Volumes.h"

#include "vtkColor.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkActor;
class vtkDeltaWingSource;

namespace gallery
{
class Stage;

/**
 * The vortices above a delta wing at times 0.65 and 1.85. Between them the spirals turn by 65
 * degrees, and the breakdown comes back to where it was.
 */
vtkSmartPointer<vtkDeltaWingSource> MakeDeltaWingVortices();

/**
 * The wing under these vortices, from its apex at the origin to x = 1.
 */
vtkSmartPointer<vtkActor> MakeDeltaWing(const vtkColor3d& colour);

/**
 * A boundary of a time-varying interval volume: which of vtkTimeVaryingIntervalVolume's
 * BoundaryKinds, and how its panel looks.
 */
struct ShownBoundary
{
  int Kind;
  std::string Caption;
  IntervalLook Look;
};

/**
 * Adds a panel for each of the boundaries, which are tetrahedra, of the interval 0.35 to 0.6 of
 * these vortices.
 */
void ShowDeltaWingBoundaries(Stage& stage, const std::vector<ShownBoundary>& boundaries);
}

#endif
