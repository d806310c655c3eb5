// SPDX-License-Identifier: BSD-3-Clause
// Two mappings on the inflow, a function and a painted image, and their stream volumes.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/FlowTextures.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkFlowVolume.h"
#include "vtkInflowMapping.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int SIZE = 256;

/// Returns the strength of a spiral brush stroke, 0 to 1.
double Paint(double u, double v)
{
  const double x = u - 0.5;
  const double y = v - 0.5;
  const double turns = std::atan2(y, x) / 6.283185307179586;
  double nearest = 1.0;
  for (int round = 0; round < 3; ++round)
  {
    const double angle = turns + round;
    if (angle >= 0.35 && angle <= 1.55)
    {
      nearest = std::min(nearest, std::abs(std::hypot(x, y) - 0.22 * angle));
    }
  }
  return 1.0 / (1.0 + std::exp((nearest - 0.03) / 0.006));
}

vtkSmartPointer<vtkImageData> MakeImage(double (*value)(double u, double v))
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(SIZE, SIZE, 1);
  image->AllocateScalars(VTK_DOUBLE, 1);
  for (int j = 0; j < SIZE; ++j)
  {
    for (int i = 0; i < SIZE; ++i)
    {
      image->SetScalarComponentFromDouble(i, j, 0, 0, value(i / (SIZE - 1.0), j / (SIZE - 1.0)));
    }
  }
  return image;
}

/// Returns the values of a mapping as a texture.
vtkSmartPointer<vtkTexture> MakeTexture(vtkInflowMapping* mapping, vtkScalarsToColors* colors)
{
  vtkNew<vtkImageData> values;
  values->SetDimensions(SIZE, SIZE, 1);
  values->AllocateScalars(VTK_DOUBLE, 1);
  for (int j = 0; j < SIZE; ++j)
  {
    for (int i = 0; i < SIZE; ++i)
    {
      values->SetScalarComponentFromDouble(
        i, j, 0, 0, mapping->Evaluate(0, (i + 0.5) / SIZE, (j + 0.5) / SIZE));
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(values);
  texture->SetLookupTable(colors);
  texture->SetColorModeToMapScalars();
  texture->InterpolateOn();
  return texture;
}

void Build(gallery::Stage& stage)
{
  const vtkSmartPointer<vtkAnalyticFlowSource> updraft = gallery::MakeAnalyticFlow(
    vtkAnalyticFlowSource::NODE, { { 9, 9, 9 }, { -0.9, 0.9, -0.9, 0.9, 0.3, 1.8 } });
  updraft->SetNodeRates(-0.2, -0.2, 0.4);
  updraft->SetSwirl(0.5);
  const vtkSmartPointer<vtkTerminationPlane> plane =
    gallery::MakeInflowPlane({ 0.0, 0.0, 0.4 }, { 0.7, 0.0, 0.0 }, { 0.0, 0.7, 0.0 });
  const gallery::FlowGrid samples = { { 73, 73, 49 }, { -0.7, 0.7, -0.7, 0.7, 0.4, 1.7 } };
  const vtkSmartPointer<vtkDataSet> flow = gallery::MakeImplicitFlow(updraft, { plane }, samples);
  const vtkSmartPointer<vtkColorTransferFunction> colors =
    gallery::MakeColorMap(gallery::Map::Inferno, 0.0, 1.0);
  const vtkSmartPointer<vtkImageData> painted = MakeImage(&Paint);
  for (const bool isPainted : { false, true })
  {
    vtkNew<vtkInflowMapping> mapping;
    if (isPainted)
    {
      mapping->SetImage(0, painted);
    }
    else
    {
      mapping->AddRing(0, 0.5, 0.5, 0.0, 0.1);
      mapping->AddRing(0, 0.5, 0.5, 0.33, 0.06);
    }
    mapping->SetInputData(flow);
    mapping->Update();
    vtkNew<vtkFlowVolume> filter;
    filter->SetInterval(0, 0.3, 2.0);
    vtkSmartPointer<vtkUnstructuredGrid> tetrahedra =
      stage.Extract(filter, mapping->GetOutputDataObject(0));

    gallery::Panel& panel =
      stage.AddPanel(isPainted ? "a painted image" : "a function", { -0.3, -1.0, 0.75 });
    panel.SetBackground(gallery::DarkBackground());
    vtkNew<vtkPiecewiseFunction> extinction;
    extinction->AddPoint(0.3, 1.5);
    extinction->AddPoint(1.0, 7.0);
    panel.Add(gallery::MakeVolume(tetrahedra, "Inflow", colors, extinction));
    panel.Add(gallery::MakeTerminationActor(plane, MakeTexture(mapping, colors)));
  }
  stage.SetColorBar("inflow", colors, 0.0, 1.0);
}

const gallery::SceneRegistration registration(
  { "inflow-mappings", "4.4", "A function and a painted image on the inflow, with their volumes",
    "Two mappings on a square from which air rises, rotates and converges (velocity (-0.2 x, -0.2 "
    "y, 0.4 z) plus a swirl): a sum of two Gaussian rings, and an image painted with a brush. Each "
    "panel shows the stream volume of values above 0.3. Both use one implicit flow field.",
    {}, &Build });
}
