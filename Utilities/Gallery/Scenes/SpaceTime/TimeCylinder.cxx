// SPDX-License-Identifier: BSD-3-Clause
// The wake of a tapered cylinder between two time steps, coloured by time.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/SpaceTime/TaperedCylinder.h"
#include "Gallery/Stage.h"
#include "Gallery/TimePanel.h"

#include "vtkActor.h"
#include "vtkTaperedCylinderSource.h"

namespace
{
void Build(gallery::Stage& stage)
{
  vtkSmartPointer<vtkTaperedCylinderSource> wake = gallery::MakeCylinderWake();
  gallery::Panel& panel = gallery::AddPanelInTime(stage, wake, 0.991, 0.995, 2.2);
  panel.Add(gallery::MakeCylinder(wake, { 0.3, 0.31, 0.33 }));
  panel.LookFrom({ -0.35, -1.0, 0.2 }, { -1.0, 0.0, 0.0 });
}

const gallery::SceneRegistration registration(
  { "time-cylinder", "3.24", "The wake of a tapered cylinder between two time steps",
    "Density from 0.991 to 0.995 in the vortices behind a tapered cylinder, which sheds faster "
    "where it is thin. All times between two steps are added up: the vortices leave green behind "
    "and go where it is red; yellow is what they share. Their lines slant, and tear where the "
    "frequency changes. A stand-in for the data of the source, with a formula.",
    {}, &Build });
}
