// SPDX-License-Identifier: BSD-3-Clause
// Two isosurfaces over all times between two steps.

#include "Gallery/Look.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/SpaceTime/DeltaWing.h"
#include "Gallery/Stage.h"

#include "vtkTimeVaryingIntervalVolume.h"

namespace
{
void Build(gallery::Stage& stage)
{
  gallery::ShowDeltaWingBoundaries(stage,
    { { vtkTimeVaryingIntervalVolume::LOWER_SURFACE_IN_TIME,
        "the isosurface 0.35, time 0.65 to 1.85", { gallery::IntervalColour(0), 25.0 } },
      { vtkTimeVaryingIntervalVolume::UPPER_SURFACE_IN_TIME,
        "the isosurface 0.6, time 0.65 to 1.85", { gallery::IntervalColour(3), 25.0 } } });
}

const gallery::SceneRegistration registration(
  { "time-isosurfaces", "3.28", "Two isosurfaces over all times between two steps",
    "What the lower and the upper isosurface of the vortices above a delta wing sweep while they "
    "move "
    "from one time step to the next: two further boundaries of the volume in space and time, drawn "
    "as "
    "ordinary volumes of one colour. Where a surface stands still, nothing is swept.",
    {}, &Build });
}
