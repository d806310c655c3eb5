// SPDX-License-Identifier: BSD-3-Clause
// Slices of 4-simplices at two time steps and midway between them.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkVector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
/// Replaces the normals of the upper and the lower side of a slice by those of the field. The other
/// sides, where the sheet is cut off along x and y, keep the normals of their triangles.
void SetFieldNormals(vtkPolyData* slice, const vtkAnalyticFieldSource* field, double time)
{
  const double step = 1e-4;
  vtkDataArray* normals = slice->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < slice->GetNumberOfPoints(); ++i)
  {
    if (std::max(std::abs(normals->GetComponent(i, 0)), std::abs(normals->GetComponent(i, 1))) >
      0.99)
    {
      continue;
    }
    vtkVector3d point(slice->GetPoint(i));
    const double side = field->Evaluate(point.GetData(), time) > 0.0 ? 1.0 : -1.0;
    vtkVector3d normal;
    for (int axis = 0; axis < 3; ++axis)
    {
      vtkVector3d next = point;
      next[axis] += side * step;
      normal[axis] = field->Evaluate(next.GetData(), time) - field->Evaluate(point.GetData(), time);
    }
    normal.Normalize();
    normals->SetTuple(i, normal.GetData());
  }
}

void Build(gallery::Stage& stage)
{
  const std::array<double, 3> times = { { 0.0, 0.25, 0.5 } };
  const std::array<const char*, 3> captions = { { "time step 0", "between, at 0.25",
    "time step 0.5" } };
  vtkNew<vtkAnalyticFieldSource> wave;
  wave->SetFieldToWave();
  // The wave is linear in z and changes slowly along y.
  wave->SetDimensions(320, 12, 8);
  wave->SetBounds(-3.4, 3.4, -0.65, 0.65, -0.7, 0.7);
  wave->SetTimeRange(times.front(), times.back());
  wave->SetNumberOfTimeSteps(2);
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInterval(0, -0.15, 0.15);
  interval->GenerateTetrahedraOff();
  interval->GenerateSimplicesOn();
  stage.Extract(interval, wave);
  vtkUnstructuredGrid* simplices =
    vtkUnstructuredGrid::SafeDownCast(interval->GetOutputDataObject(2));
  stage.SetColumns(1);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    gallery::Panel& panel = stage.AddPanel(captions[i], { 0.08, -1.0, 0.65 });
    panel.SetAmbientOcclusion(0.0);
    vtkNew<vtkSimplexTimeSlice> slice;
    slice->SetTime(times[i]);
    vtkSmartPointer<vtkPolyData> sheet =
      gallery::MakeSurface(stage.Extract(slice, simplices), 60.0);
    SetFieldNormals(sheet, wave, times[i]);
    panel.Add(gallery::MakeActor(sheet, gallery::IntervalColor(static_cast<int>(i) + 1)));
  }
}

const gallery::SceneRegistration registration(
  { "time-slices", "3.11", "One interval at two time steps and between them",
    "A sheet that follows a traveling wave. Its 4-simplices between two time steps, sliced at the "
    "first step, midway and at the second step: the crests move to the right. Slices at any time "
    "between the steps need no new extraction.",
    {}, &Build });
}
