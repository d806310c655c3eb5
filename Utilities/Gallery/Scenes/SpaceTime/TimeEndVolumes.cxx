// SPDX-License-Identifier: BSD-3-Clause
// The interval volumes at the first and at the last time of a time-varying interval volume.

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
    { { vtkTimeVaryingIntervalVolume::VOLUME_AT_START, "time 0.65",
        { gallery::IntervalColour(2), 25.0 } },
      { vtkTimeVaryingIntervalVolume::VOLUME_AT_END, "time 1.85",
        { gallery::IntervalColour(3), 25.0 } } });
}

const gallery::SceneRegistration registration(
  { "time-end-volumes", "3.29", "Interval volumes at the first and at the last time",
    "The vortices above a delta wing from 0.35 to 0.6 at both ends of the time between two steps, "
    "boundaries of the volume in space and time that come with it in the same pass. The spirals "
    "have turned.",
    {}, &Build });
}
