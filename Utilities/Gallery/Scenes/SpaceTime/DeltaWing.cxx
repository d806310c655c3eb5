// SPDX-License-Identifier: BSD-3-Clause
// The vortices above a delta wing over time, and the boundaries of the vortices' volume in space
// and time.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"
#include "Gallery/TimeBoundary.h"
#include "Gallery/TimePanel.h"
#include "Gallery/Volumes.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkColor.h"
#include "vtkDeltaWingSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace gallery;

/// Colors of the background and of the wing.
const vtkColor3d SKY_COLOR(0.02, 0.035, 0.08);
const vtkColor3d WING_COLOR(0.14, 0.16, 0.22);

/// A boundary of a time-varying interval volume (vtkTimeVaryingIntervalVolume::BoundaryKinds), with
/// the caption and the appearance of its panel.
struct ShownBoundary
{
  int Kind;
  std::string Caption;
  IntervalLook Look;
};

/// Returns the vortices above a delta wing from time 0.65 to 1.85. Between these times, the spirals
/// rotate by 65 degrees, and the breakdown returns to its initial position.
vtkSmartPointer<vtkDeltaWingSource> MakeDeltaWingVortices(int steps)
{
  auto vortices = vtkSmartPointer<vtkDeltaWingSource>::New();
  vortices->SetNumberOfTimeSteps(steps);
  vortices->SetTimeRange(0.65, 1.85);
  return vortices;
}

/// Returns the wing under the vortices of MakeDeltaWingVortices(). It extends from its apex at the
/// origin to x = 1.
vtkSmartPointer<vtkActor> MakeDeltaWing(const vtkColor3d& color)
{
  vtkNew<vtkDeltaWingSource> vortices;
  const double halfSpan = std::tan(vtkMath::RadiansFromDegrees(90.0 - vortices->GetSweepAngle()));
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, -halfSpan, 0.0);
  points->InsertNextPoint(1.0, halfSpan, 0.0);
  vtkNew<vtkCellArray> triangle;
  triangle->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> wing;
  wing->SetPoints(points);
  wing->SetPolys(triangle);
  return MakeActor(MakeSurface(wing), color);
}

/// Adds a panel for each of the boundaries of the interval 0.35 to 0.6 of MakeDeltaWingVortices().
/// The boundaries consist of tetrahedra.
void ShowDeltaWingBoundaries(Stage& stage, const std::vector<ShownBoundary>& boundaries)
{
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, 0.35, 0.6);
  interval->GenerateTetrahedraOff();
  for (const ShownBoundary& boundary : boundaries)
  {
    interval->SetGenerateBoundary(boundary.Kind, true);
  }
  vtkSmartPointer<vtkDeltaWingSource> vortices = MakeDeltaWingVortices(2);
  vortices->SetDimensions(150, 170, 70);
  stage.Extract(interval, vortices);
  for (const ShownBoundary& boundary : boundaries)
  {
    Panel& panel = stage.AddPanel(boundary.Caption, { -0.7, 0.0, 1.0 });
    panel.Add(
      MakeVolumeOfIntervals(MakeTimeBoundary(interval, { boundary.Kind }), { boundary.Look }));
    panel.Add(MakeDeltaWing(WING_COLOR));
    panel.SetBackground(SKY_COLOR, { 0.08, 0.10, 0.16 });
  }
}

void BuildTimeDelta(gallery::Stage& stage)
{
  gallery::Panel& panel = gallery::AddTimePanel(stage, MakeDeltaWingVortices(6), 0.4, 1.1, 11.0);
  panel.SetBackground(SKY_COLOR);
  panel.Add(MakeDeltaWing(WING_COLOR));
  panel.LookFrom({ -0.3, -0.5, 1.0 }, { 0.0, 0.0, 1.0 });
}

const gallery::SceneRegistration timeDelta(
  { "time-delta", "3.22", "Vortices above a delta wing over six time steps",
    "The region where the pressure loss in two vortices, which break down to spirals, is above 0.4 "
    "at any time from the first to the last of six steps. Colors of all times are added: blue "
    "is covered early, orange to red late, and gray to white all the time, brighter where a vortex "
    "is thick. The spirals rotate, and both breakdowns end where they began. An analytic model "
    "replaces the data of the dissertation.",
    {}, &BuildTimeDelta });

void BuildTimeEndVolumes(gallery::Stage& stage)
{
  ShowDeltaWingBoundaries(stage,
    { { vtkTimeVaryingIntervalVolume::VOLUME_AT_START, "time 0.65",
        { gallery::IntervalColor(2), 16.0 } },
      { vtkTimeVaryingIntervalVolume::VOLUME_AT_END, "time 1.85",
        { gallery::IntervalColor(3), 16.0 } } });
}

const gallery::SceneRegistration timeEndVolumes({ "time-end-volumes", "3.29",
  "Interval volumes at the first and at the last time",
  "The vortices above a delta wing from 0.35 to 0.6 at two time steps. Both volumes are boundaries "
  "of the volume in space and time, extracted in the same pass. The spirals have rotated.",
  {}, &BuildTimeEndVolumes });

void BuildTimeIsosurfaces(gallery::Stage& stage)
{
  ShowDeltaWingBoundaries(stage,
    { { vtkTimeVaryingIntervalVolume::LOWER_SURFACE_IN_TIME,
        "the isosurface 0.35, time 0.65 to 1.85", { gallery::IntervalColor(0), 25.0 } },
      { vtkTimeVaryingIntervalVolume::UPPER_SURFACE_IN_TIME,
        "the isosurface 0.6, time 0.65 to 1.85", { gallery::IntervalColor(3), 25.0 } } });
}

const gallery::SceneRegistration timeIsosurfaces(
  { "time-isosurfaces", "3.28", "Two isosurfaces over all times between two steps",
    "The regions that the lower and the upper isosurface of the vortices above a delta wing sweep "
    "between two time steps: two further boundaries of the volume in space and time, rendered as "
    "volumes of one color. Where a surface does not move, it sweeps nothing.",
    {}, &BuildTimeIsosurfaces });
}
