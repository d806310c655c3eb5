// SPDX-License-Identifier: BSD-3-Clause
// Slices of 4-simplices at two time steps and midway between them.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkNew.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include <array>

namespace
{
void Build(gallery::Stage& stage)
{
  const std::array<double, 3> times = { { 0.0, 0.25, 0.5 } };
  const std::array<const char*, 3> captions = { { "time step 0", "between, at 0.25",
    "time step 0.5" } };
  vtkNew<vtkAnalyticFieldSource> wave;
  wave->SetFieldToWave();
  wave->SetDimensions(44, 55, 27);
  wave->SetBounds(-1.0, 1.0, -1.25, 1.25, -0.6, 0.6);
  wave->SetTimeRange(times.front(), times.back());
  wave->SetNumberOfTimeSteps(2);
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, -0.15, 0.15);
  interval->GenerateTetrahedraOff();
  interval->GenerateSimplicesOn();
  stage.Extract(interval, wave);
  vtkUnstructuredGrid* simplices =
    vtkUnstructuredGrid::SafeDownCast(interval->GetOutputDataObject(2));
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    gallery::Panel& panel = stage.AddPanel(captions[i], { 0.55, -1.0, 1.0 });
    vtkNew<vtkSimplexTimeSlice> slice;
    slice->SetTime(times[i]);
    panel.Add(gallery::MakeActor(gallery::MakeSurface(stage.Extract(slice, simplices), 80.0),
      gallery::IntervalColor(static_cast<int>(i) + 1)));
  }
}

const gallery::SceneRegistration registration(
  { "time-slices", "3.11", "One interval at two time steps and between them",
    "A sheet that follows a traveling wave. Its 4-simplices between two time steps, sliced at the "
    "first step, midway and at the second step: the crests move to the right. Slices at any time "
    "between the steps need no new extraction.",
    {}, &Build });
}
