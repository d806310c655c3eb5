// SPDX-License-Identifier: BSD-3-Clause
// A stream surface with line integral convolution (LIC), inside a translucent volume.

#include "Gallery/Look.h"
#include "Gallery/Props.h"
#include "Gallery/Scene.h"
#include "Gallery/Scenes/Flow/FlowScene.h"
#include "Gallery/Scenes/Flow/TexturedSurface.h"
#include "Gallery/Stage.h"
#include "Gallery/Volumes.h"

#include "vtkLinearSubdivisionFilter.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkFlowLIC.h"
#include "vtkImplicitFlowField.h"
#include "vtkNew.h"
#include "vtkTerminationPlane.h"

namespace
{
constexpr double Radius = 0.4;

/// Returns the flow, sampled on an image. The inflow value is the distance from the x axis.
vtkSmartPointer<vtkDataSet> MakeFlow(vtkAnalyticFlowSource* source)
{
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(-1.3, -1.0, -1.0);
  plane->SetPoint1(-1.3, 1.0, -1.0);
  plane->SetPoint2(-1.3, -1.0, 1.0);
  vtkNew<vtkImplicitFlowField> flow;
  flow->SetInputConnection(source->GetOutputPort());
  flow->AddTerminationSurface(plane);
  flow->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  flow->SetSampleDimensions(66, 39, 39);
  flow->SetSampleBounds(-1.3, 1.3, -0.76, 0.76, -0.76, 0.76);
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(flow->GetOutputPort());
  mapping->SetFormula(vtkInflowMapping::ALL, "2 * sqrt((u - 0.5)^2 + (v - 0.5)^2)");
  mapping->Update();
  return vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0));
}

void Build(gallery::Stage& stage)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::SPHERE);
  source->SetDimensions(85, 61, 61);
  source->SetBounds(-1.4, 1.4, -1.0, 1.0, -1.0, 1.0);
  source->SetRadius(Radius);
  const vtkSmartPointer<vtkDataSet> flow = MakeFlow(source);

  // Triangles must be smaller than the noise.
  vtkNew<vtkLinearSubdivisionFilter> small;
  small->SetInputData(gallery::MakeStreamSurface(flow, 0.3, 0.05, 3.5));
  small->SetNumberOfSubdivisions(2);
  vtkNew<vtkFlowLIC> lic;
  lic->SetInputConnection(small->GetOutputPort());
  lic->SetFieldConnection(source->GetOutputPort());
  lic->SetNoiseScale(0.022);
  lic->SetLength(0.25);
  lic->SetStepLength(0.011);
  lic->Update();
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 0.02, 0.12, 0.30);
  colors->AddRGBPoint(0.5, 0.20, 0.48, 0.72);
  colors->AddRGBPoint(1.0, 0.92, 0.98, 1.0);

  gallery::Panel& panel = stage.AddPanel("", { -0.55, -1.0, 0.45 });
  const vtkSmartPointer<vtkActor> surface = gallery::MakeColoredActor(
    vtkPolyData::SafeDownCast(lic->GetOutputDataObject(0)), "LIC", colors);
  gallery::ClipActor(surface, { 0.0, 0.8, -0.6 });
  panel.Add(surface);
  panel.Add(gallery::MakeSphere({ 0.0, 0.0, 0.0 }, Radius, gallery::IntervalColor(2)));
  panel.Add(gallery::MakeVolumeOfIntervals(
    gallery::MakeStreamVolume(flow, 0.3, 0.6, 0.05, 3.5), { { gallery::IntervalColor(0), 0.3 } }));
}

const gallery::SceneRegistration registration(
  { "stream-surface-lic", "4.6", "A stream surface with line integral convolution",
    "Flow around a sphere, from the left. The stream surface starts on a circle and passes close "
    "to the sphere. It is cut open. A convolution of 3D noise along streamlines colors its points. "
    "The streaks "
    "show the flow direction without any parameters of the surface. The flow volume of streamlines "
    "farther from the axis surrounds it.",
    {}, &Build });
}
