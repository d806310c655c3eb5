// SPDX-License-Identifier: BSD-3-Clause
// A travelling wave between two time steps, coloured by time.

#include "Gallery/Scene.h"
#include "Gallery/Scenes/SpaceTime/Wave.h"
#include "Gallery/Stage.h"
#include "Gallery/TimePanel.h"

#include "vtkAnalyticFieldSource.h"

namespace
{
void Build(gallery::Stage& stage)
{
  gallery::Panel& panel = gallery::AddPanelInTime(stage, gallery::MakeWave(), -0.15, 0.15, 1.1);
  panel.LookFrom({ 0.27, -1.0, 0.13 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration registration(
  { "wave-in-time", "3.20", "A wave between two time steps, coloured by time",
    "A sheet between two isovalues that follows a wave, 40 x 20 x 20 points and two time "
    "steps, over all times between them at once, seen along its crests. Green is where it "
    "was at first, red where it is at last, yellow where it is half of the time or all of "
    "it: the wave travels to the right. Colours of different times are added up.",
    {}, &Build });
}
