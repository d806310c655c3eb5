// SPDX-License-Identifier: BSD-3-Clause
// Intervals of two-dimensional cells: triangles in each interval, and contour lines between them.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Stage.h"

#include "vtkActor.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{
constexpr int NUMBER = 4;

void AddValues(vtkDataSet* data)
{
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    double x[3];
    data->GetPoint(point, x);
    values->InsertNextValue(
      0.5 + 0.25 * std::sin(4.0 * x[0] + x[2]) + 0.25 * std::cos(3.0 * x[1] - 4.0 * x[0] * x[1]));
  }
  data->GetPointData()->SetScalars(values);
}

vtkSmartPointer<vtkPolyData> MakePolygons(vtkDataSet* cells)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(cells);
  surface->Update();
  return surface->GetOutput();
}

void AddBands(gallery::Panel& panel, vtkDataSet* data)
{
  AddValues(data);
  vtkNew<vtkIntervalVolume> intervals;
  intervals->SetInputData(data);
  intervals->GenerateBoundariesOn();
  for (int i = 0; i < NUMBER; ++i)
  {
    intervals->SetInterval(i, static_cast<double>(i) / NUMBER, static_cast<double>(i + 1) / NUMBER);
  }
  intervals->Update();
  auto* triangles = vtkUnstructuredGrid::SafeDownCast(intervals->GetOutputDataObject(0));
  for (int i = 0; i < NUMBER; ++i)
  {
    vtkSmartPointer<vtkActor> actor =
      gallery::MakeActor(MakePolygons(gallery::SelectTriangles(triangles, "IntervalId", i)),
        gallery::IntervalColor(i));
    actor->GetProperty()->EdgeVisibilityOn();
    panel.Add(actor);
  }
  // Tubes, since parts of lines would be behind the triangles.
  vtkNew<vtkTubeFilter> lines;
  lines->SetInputData(MakePolygons(vtkDataSet::SafeDownCast(intervals->GetOutputDataObject(1))));
  lines->SetRadius(0.005 * data->GetLength());
  lines->SetNumberOfSides(12);
  lines->CappingOn();
  lines->Update();
  panel.Add(gallery::MakeActor(lines->GetOutput(), gallery::TextColor()));
}

void Build(gallery::Stage& stage)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(22, 17, 1);
  image->SetSpacing(0.1, 0.1, 0.1);
  gallery::Panel& flat = stage.AddPanel("an image");
  flat.LookFrom({ 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0 });
  AddBands(flat, image);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(26);
  sphere->SetPhiResolution(18);
  sphere->Update();
  AddBands(stage.AddPanel("a sphere"), sphere->GetOutput());
}

const gallery::SceneRegistration registration(
  { "interval-surfaces", "3.1", "Adjacent intervals of functions on an image and on a sphere",
    "The pixels of an image and the triangles of a sphere are cut into triangles in four adjacent "
    "intervals, with contour lines between them. The triangles of all intervals tile the surface.",
    {}, &Build });
}
