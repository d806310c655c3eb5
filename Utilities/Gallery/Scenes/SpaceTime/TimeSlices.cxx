// SPDX-License-Identifier: BSD-3-Clause
// Slices of 4-simplices at two time steps and midway between them.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"

#include "vtkActor.h"
#include "vtkAnalyticFieldSource.h"
#include "vtkBoundingBox.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkSmartPointer.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkVector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
/// Returns the unit gradient of \a field, oriented away from its zero isosurface.
vtkVector3d GetNormal(const vtkAnalyticFieldSource* field, const vtkVector3d& at, double time)
{
  vtkVector3d point = at;
  const double value = field->Evaluate(point.GetData(), time);
  const double step = value > 0.0 ? 1e-4 : -1e-4;
  vtkVector3d normal;
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] += step;
    normal[axis] = field->Evaluate(point.GetData(), time) - value;
    point[axis] -= step;
  }
  return normal.Normalized();
}

/// Returns the side of \a bounds that contains all \a corners: 0 or 1 (perpendicular to x), 2 or 3
/// (perpendicular to y), or -1 if there is none.
int FindSide(const double bounds[6], const std::array<vtkVector3d, 3>& corners)
{
  for (int side = 0; side < 4; ++side)
  {
    if (std::all_of(corners.begin(), corners.end(),
          [bounds, side](const vtkVector3d& corner)
          { return std::abs(corner[side / 2] - bounds[side]) < 1e-4; }))
    {
      return side;
    }
  }
  return -1;
}

/// Returns the triangles of \a slice with normals of \a field, since normals of the very thin
/// triangles would be noisy. Where the sheet is cut off at the bounds along x and y, triangles have
/// the normals of the bounds.
vtkSmartPointer<vtkPolyData> ShadeByField(
  vtkPolyData* slice, const vtkAnalyticFieldSource* field, double time)
{
  double bounds[6];
  slice->GetBounds(bounds);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < slice->GetNumberOfCells(); ++cell)
  {
    std::array<vtkVector3d, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = vtkVector3d(slice->GetCell(cell)->GetPoints()->GetPoint(i));
    }
    const int side = FindSide(bounds, corners);
    vtkVector3d sideNormal(0.0, 0.0, 0.0);
    if (side >= 0)
    {
      sideNormal[side / 2] = side % 2 == 0 ? -1.0 : 1.0;
    }
    triangles->InsertNextCell(3);
    for (const vtkVector3d& corner : corners)
    {
      triangles->InsertCellPoint(points->InsertNextPoint(corner.GetData()));
      const vtkVector3d normal = side >= 0 ? sideNormal : GetNormal(field, corner, time);
      normals->InsertNextTuple(normal.GetData());
    }
  }
  auto shaded = vtkSmartPointer<vtkPolyData>::New();
  shaded->SetPoints(points);
  shaded->SetPolys(triangles);
  shaded->GetPointData()->SetNormals(normals);
  return shaded;
}

void Build(gallery::Stage& stage)
{
  const std::array<double, 3> times = { { 0.0, 0.25, 0.5 } };
  const std::array<const char*, 3> captions = { { "first step", "midway", "second step" } };
  vtkNew<vtkAnalyticFieldSource> wave;
  wave->SetFieldToWave();
  // The wave is linear in z and changes slowly along y, so it needs most points along x.
  wave->SetDimensions(1280, 32, 2);
  wave->SetBounds(-3.4, 3.4, -0.4, 0.4, -0.7, 0.7);
  wave->SetTimeRange(times.front(), times.back());
  wave->SetNumberOfTimeSteps(2);
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, -0.15, 0.15);
  interval->GenerateTetrahedraOff();
  interval->GenerateSimplicesOn();
  stage.Extract(interval, wave);
  vtkUnstructuredGrid* simplices =
    vtkUnstructuredGrid::SafeDownCast(interval->GetOutputDataObject(2));
  // Upright at a crest of the first step, in front of the sheet.
  vtkNew<vtkCubeSource> marker;
  marker->SetBounds(0.09, 0.11, -0.43, -0.41, -0.65, 0.65);
  marker->Update();
  stage.SetColumns(1);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    gallery::Panel& panel = stage.AddPanel(captions[i], { 0.08, -1.0, 0.4 });
    panel.Frame(vtkBoundingBox(-3.4, 3.4, -0.4, 0.4, -0.55, 0.55));
    panel.SetAmbientOcclusion(0.0);
    vtkNew<vtkSimplexTimeSlice> slice;
    slice->SetTime(times[i]);
    vtkSmartPointer<vtkPolyData> sheet =
      ShadeByField(gallery::MakeSurface(stage.Extract(slice, simplices)), wave, times[i]);
    panel.Add(gallery::MakeActor(marker->GetOutput(), gallery::TextColor()));
    vtkSmartPointer<vtkActor> actor =
      gallery::MakeActor(sheet, gallery::IntervalColor(static_cast<int>(i) + 1));
    actor->GetProperty()->SetAmbient(0.35);
    panel.Add(actor);
  }
}

const gallery::SceneRegistration registration(
  { "time-slices", "3.11", "One interval at two time steps and between them",
    "A sheet that follows a traveling wave. Its 4-simplices between two time steps, sliced at the "
    "first step, midway and at the second step. A post marks a crest of the first step, from which "
    "the crests move to the right. Slices at any time between the steps need no new extraction.",
    {}, &Build });
}
