// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/SpaceTime/DeltaWing.h"

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Stage.h"
#include "Gallery/TimeBoundary.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDeltaWingSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"

#include <cmath>

namespace gallery
{
vtkSmartPointer<vtkDeltaWingSource> MakeDeltaWingVortices()
{
  auto vortices = vtkSmartPointer<vtkDeltaWingSource>::New();
  vortices->SetNumberOfTimeSteps(2);
  vortices->SetTimeRange(0.65, 1.85);
  return vortices;
}

vtkSmartPointer<vtkActor> MakeDeltaWing(const vtkColor3d& colour)
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
  return MakeActor(MakeSurface(wing), colour);
}

void ShowDeltaWingBoundaries(Stage& stage, const std::vector<ShownBoundary>& boundaries)
{
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, 0.35, 0.6);
  interval->GenerateTetrahedraOff();
  for (const ShownBoundary& boundary : boundaries)
  {
    interval->SetGenerateBoundary(boundary.Kind, true);
  }
  stage.Extract(interval, MakeDeltaWingVortices());
  Panel* first = nullptr;
  for (const ShownBoundary& boundary : boundaries)
  {
    Panel& panel = stage.AddPanel(boundary.Caption);
    if (first)
    {
      panel.LookAs(*first);
    }
    else
    {
      first = &panel;
      panel.LookFrom({ -0.85, -0.25, 1.0 }, { 0.0, 0.0, 1.0 });
    }
    panel.Add(
      MakeVolumeOfIntervals(MakeTimeBoundary(interval, { boundary.Kind }), { boundary.Look }));
    panel.Add(MakeDeltaWing(Pencil()));
  }
}
}
