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

/// Bounds of the density in the vortices.
constexpr double LOWER = 0.97;
constexpr double UPPER = 0.994;

/// Returns the wake of a tapered cylinder from time 0 to \a end, up to \a distance from the
/// cylinder's axis.
vtkSmartPointer<vtkTaperedCylinderSource> MakeCylinderWake(double end, int steps, double distance)
{
  auto wake = vtkSmartPointer<vtkTaperedCylinderSource>::New();
  wake->SetDimensions(80, 80, 48);
  wake->SetOuterRadius(distance);
  wake->SetNumberOfTimeSteps(steps);
  wake->SetTimeRange(0.0, end);
  return wake;
}

/// Looks at the wake from the side, with the cylinder at the top.
void LookAtWake(Panel& panel)
{
  panel.LookFrom({ -0.5, -1.0, 0.2 }, { -1.0, 0.0, 0.0 });
}

/// Returns the cylinder: surface i = 0 of the grid of \a wake, which must be up to date.
vtkSmartPointer<vtkActor> MakeCylinder(vtkTaperedCylinderSource* wake, const vtkColor3d& color)
{
  return MakeActor(MakeGridSurface(wake->GetOutput(), 0, 0), color);
}

void BuildTimeCylinder(gallery::Stage& stage)
{
  vtkSmartPointer<vtkTaperedCylinderSource> wake = MakeCylinderWake(0.9, 6, 9.0);
  gallery::Panel& panel = gallery::AddTimePanel(stage, wake, LOWER, UPPER, 1.8);
  panel.SetBackground({ 0.03, 0.025, 0.05 });
  panel.Add(MakeCylinder(wake, { 0.6, 0.61, 0.64 }));
  LookAtWake(panel);
  panel.Frame(vtkBoundingBox(-0.5, 5.2, -0.5, 0.5, 0.2, 10.4));
}

const gallery::SceneRegistration timeCylinder(
  { "time-cylinder", "3.24", "The wake of a tapered cylinder over six time steps",
    "Density below 0.994 in the vortices behind a tapered cylinder, which sheds faster where it is "
    "thin. All times from the first to the last of six steps are added: the vortices leave the "
    "blue region and move to the orange one; white is covered most of the time. The vortex "
    "lines are slanted and break where the frequency changes. An analytic model replaces the data "
    "of the dissertation.",
    {}, &BuildTimeCylinder });

void BuildTimePriority(gallery::Stage& stage)
{
  vtkSmartPointer<vtkTaperedCylinderSource> wake = MakeCylinderWake(0.6, 2, 14.0);
  wake->SetDimensions(110, 110, 64);
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, LOWER, UPPER);
  interval->GenerateTetrahedraOff();
  const int start = vtkTimeVaryingIntervalVolume::VOLUME_AT_START;
  const int end = vtkTimeVaryingIntervalVolume::VOLUME_AT_END;
  interval->SetGenerateBoundary(start, true);
  interval->SetGenerateBoundary(end, true);
  stage.Extract(interval, wake);
  vtkSmartPointer<vtkUnstructuredGrid> both = gallery::MakeTimeBoundary(interval, { start, end });

  gallery::Panel& later = stage.AddPanel("time 0.6 over time 0");
  gallery::Panel& earlier = stage.AddPanel("time 0 over time 0.6");
  LookAtWake(later);
  earlier.ShareCamera(later);
  const vtkColor3d yellow = gallery::IntervalColor(2);
  const vtkColor3d red = gallery::IntervalColor(3);
  for (gallery::Panel* panel : { &later, &earlier })
  {
    vtkSmartPointer<vtkVolume> volume =
      gallery::MakeVolumeOfIntervals(both, { { yellow, 2.2 }, { red, 2.2 } });
    vtkTimeWeightedTetrahedraMapper* mapper = gallery::GetMapper(volume);
    mapper->SetBlendModeToPriority();
    mapper->SetLayerPriority(0, panel == &later ? 0.0 : 2.0);
    mapper->SetLayerPriority(1, 1.0);
    panel->Add(volume);
    panel->Add(MakeCylinder(wake, { 0.6, 0.61, 0.64 }));
    // The wake extends past the edges of the panels.
    panel->SetBackground({ 0.05, 0.045, 0.07 }, { 0.03, 0.025, 0.05 });
    panel->Frame(vtkBoundingBox(-0.5, 8.4, -0.5, 0.5, 0.8, 10.0));
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
