// SPDX-License-Identifier: BSD-3-Clause
// The wake of a tapered cylinder over time: colored by time, and at two times.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/TimeBoundary.h"
#include "Gallery/TimePanel.h"
#include "Gallery/Volumes.h"

#include "vtkActor.h"
#include "vtkColor.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkTaperedCylinderSource.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"

namespace
{
using namespace gallery;

/// Returns the wake of a tapered cylinder at times 0 and 0.6, on 80 x 80 x 40 points.
vtkSmartPointer<vtkTaperedCylinderSource> MakeCylinderWake()
{
  auto wake = vtkSmartPointer<vtkTaperedCylinderSource>::New();
  wake->SetDimensions(80, 80, 40);
  wake->SetNumberOfTimeSteps(2);
  wake->SetTimeRange(0.0, 0.6);
  return wake;
}

/// Returns the cylinder: surface i = 0 of the grid of \a wake, which must be up to date.
vtkSmartPointer<vtkActor> MakeCylinder(vtkTaperedCylinderSource* wake, const vtkColor3d& color)
{
  return MakeActor(MakeWall(wake->GetOutput(), 0, 0), color);
}

void BuildTimeCylinder(gallery::Stage& stage)
{
  vtkSmartPointer<vtkTaperedCylinderSource> wake = MakeCylinderWake();
  gallery::Panel& panel = gallery::AddPanelInTime(stage, wake, 0.991, 0.995, 2.2);
  panel.Add(MakeCylinder(wake, { 0.3, 0.31, 0.33 }));
  panel.LookFrom({ -0.35, -1.0, 0.2 }, { -1.0, 0.0, 0.0 });
}

const gallery::SceneRegistration timeCylinder(
  { "time-cylinder", "3.24", "The wake of a tapered cylinder between two time steps",
    "Density from 0.991 to 0.995 in the vortices behind a tapered cylinder, which sheds faster "
    "where it is thin. All times between two steps are added: the vortices leave the green region "
    "and move to the red one; yellow is in both. The vortex lines are slanted and break where the "
    "frequency changes. An analytic model replaces the data of the dissertation.",
    {}, &BuildTimeCylinder });

void BuildTimePriority(gallery::Stage& stage)
{
  vtkSmartPointer<vtkTaperedCylinderSource> wake = MakeCylinderWake();
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, 0.991, 0.995);
  interval->GenerateTetrahedraOff();
  const int start = vtkTimeVaryingIntervalVolume::VOLUME_AT_START;
  const int end = vtkTimeVaryingIntervalVolume::VOLUME_AT_END;
  interval->SetGenerateBoundary(start, true);
  interval->SetGenerateBoundary(end, true);
  stage.Extract(interval, wake);
  vtkSmartPointer<vtkUnstructuredGrid> both = gallery::MakeTimeBoundary(interval, { start, end });

  const vtkVector3d from(0.3, -1.0, 0.35);
  gallery::Panel& later = stage.AddPanel("time 0.6 over time 0", from);
  gallery::Panel& earlier = stage.AddPanel("time 0 over time 0.6", from);
  const vtkColor3d yellow = gallery::IntervalColor(2);
  const vtkColor3d red = gallery::IntervalColor(3);
  for (gallery::Panel* panel : { &later, &earlier })
  {
    vtkSmartPointer<vtkVolume> volume =
      gallery::MakeVolumeOfIntervals(both, { { yellow, 6.0 }, { red, 6.0 } });
    vtkTimeWeightedTetrahedraMapper* mapper = gallery::GetMapper(volume);
    mapper->SetBlendModeToPriority();
    mapper->SetLayerPriority(0, panel == &later ? 0.0 : 2.0);
    mapper->SetLayerPriority(1, 1.0);
    panel->Add(volume);
    panel->Add(MakeCylinder(wake, gallery::Pencil()));
  }
  stage.SetColorKey("", { { yellow, "time 0" }, { red, "time 0.6" } });
}

const gallery::SceneRegistration timePriority(
  { "time-priority", "3.30", "Interval volumes at two times, each over the other",
    "The vortices behind a tapered cylinder at two times in one view, yellow before red. One of "
    "the two is drawn over the other regardless of depth, by priority instead of distance. Compare "
    "with the image of all times between them.",
    {}, &BuildTimePriority });
}
