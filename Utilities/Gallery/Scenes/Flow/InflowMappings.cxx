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
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int SIZE = 256;

/// Rates at which the air converges and rises, and turns in radians, per unit of time.
constexpr double CONVERGENCE = -0.2;
constexpr double RISE = 0.4;
constexpr double SWIRL = 0.5;

/// z of the inflow plane and of the top of the volume, and half the edge length of the plane.
constexpr double BOTTOM = 0.4;
constexpr double TOP = 1.7;
constexpr double HALF = 0.7;

/// Returns the strength of a spiral brush stroke with round ends, 0 to 1.
double Paint(double u, double v)
{
  constexpr int steps = 500;
  double nearest = 1.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double turns = 0.35 + 1.2 * i / steps;
    const double angle = 2.0 * vtkMath::Pi() * turns;
    nearest = std::min(nearest,
      std::hypot(
        u - 0.5 - 0.22 * turns * std::cos(angle), v - 0.5 - 0.22 * turns * std::sin(angle)));
  }
  return 1.0 / (1.0 + std::exp((nearest - 0.036) / 0.012));
}

/// Returns a square grid that turns and narrows like the flow, so that each of its upright lines is
/// a streamline and structures do not become narrower than its cells.
vtkSmartPointer<vtkStructuredGrid> MakeSamples()
{
  constexpr int across = 97;
  constexpr int upward = 41;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < upward; ++k)
  {
    const double time = std::log(TOP / BOTTOM) / RISE * k / (upward - 1.0);
    const double z = BOTTOM * std::exp(RISE * time);
    const double size = HALF * std::exp(CONVERGENCE * time);
    const double sine = std::sin(SWIRL * time);
    const double cosine = std::cos(SWIRL * time);
    for (int j = 0; j < across; ++j)
    {
      const double y = size * (2.0 * j / (across - 1.0) - 1.0);
      for (int i = 0; i < across; ++i)
      {
        const double x = size * (2.0 * i / (across - 1.0) - 1.0);
        points->InsertNextPoint(cosine * x - sine * y, sine * x + cosine * y, z);
      }
    }
  }
  auto samples = vtkSmartPointer<vtkStructuredGrid>::New();
  samples->SetDimensions(across, across, upward);
  samples->SetPoints(points);
  return samples;
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
  updraft->SetNodeRates(CONVERGENCE, CONVERGENCE, RISE);
  updraft->SetSwirl(SWIRL);
  const vtkSmartPointer<vtkTerminationPlane> plane =
    gallery::MakeInflowPlane({ 0.0, 0.0, BOTTOM }, { HALF, 0.0, 0.0 }, { 0.0, HALF, 0.0 });
  const vtkSmartPointer<vtkDataSet> flow =
    gallery::MakeImplicitFlow(updraft, { plane }, MakeSamples());
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
      mapping->AddRing(0, 0.5, 0.5, 0.12, 0.05);
      mapping->AddRing(0, 0.5, 0.5, 0.33, 0.05);
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
    extinction->AddPoint(0.3, 0.0);
    extinction->AddPoint(1.0, 7.0);
    panel.Add(gallery::MakeVolume(tetrahedra, "Inflow", colors, extinction));
    panel.Add(gallery::MakeTerminationActor(plane, MakeTexture(mapping, colors)));
  }
  stage.SetColorBar("inflow", colors, 0.0, 1.0);
}

const gallery::SceneRegistration registration(
  { "inflow-mappings", "4.4", "A function and a painted image on the inflow, with their volumes",
    "Two mappings on a square from which air rises, rotates and converges (velocity (-0.2 x, -0.2 "
    "y, 0.4 z) plus a swirl): a sum of two Gaussian rings, and a painted brush stroke. Each "
    "panel shows the stream volume of values above 0.3. Both use one implicit flow field.",
    {}, &Build });
}
