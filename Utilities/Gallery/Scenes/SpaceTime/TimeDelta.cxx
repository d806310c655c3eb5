// SPDX-License-Identifier: BSD-3-Clause
// The vortices above a delta wing between two time steps, coloured by time.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/SpaceTime/DeltaWing.h"
#include "Gallery/Stage.h"
#include "Gallery/TimePanel.h"

#include "vtkActor.h"
#include "vtkDeltaWingSource.h"

namespace
{
void Build(gallery::Stage& stage)
{
  gallery::Panel& panel =
    gallery::AddPanelInTime(stage, gallery::MakeDeltaWingVortices(), 0.35, 0.6, 8.0);
  panel.Add(gallery::MakeDeltaWing({ 0.2, 0.21, 0.23 }));
  panel.LookFrom({ -0.6, -0.8, 0.9 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration registration({ "time-delta", "3.22",
  "Vortices above a delta wing between two time steps",
  "Where the loss of pressure in two vortices, which break down to spirals, is from 0.35 to 0.6 at "
  "any time between two steps. Colours of all times are added up: green was left since the first "
  "step, red is new at the second, yellow stays. The spirals turn, and both breakdowns end where "
  "they began. A stand-in for the data of the source, with a formula.",
  {}, &Build });
}
