// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Flow/TexturedSurface.h"

#include "Gallery/Props.h"
#include "Gallery/Scenes/Flow/FlowScene.h"

#include "vtkDataSetSurfaceFilter.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationCylinder.h"

#include <cmath>

namespace gallery
{
MappedFlow MakeTornado(double time, int fineness)
{
  vtkNew<vtkAnalyticFlowSource> tornado;
  tornado->SetField(vtkAnalyticFlowSource::TORNADO);
  tornado->SetDimensions(49, 49, 49);
  tornado->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  tornado->SetCoreRadius(0.3);
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->SetPoint1(0.0, 0.0, -1.0);
  cylinder->SetPoint2(0.0, 0.0, 1.0);
  cylinder->SetRadius(0.9);
  vtkNew<vtkImplicitFlowField> flow;
  flow->SetInputConnection(tornado->GetOutputPort());
  flow->AddTerminationSurface(cylinder);
  flow->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  flow->SetSampleData(MakeRings(tornado,
    { { 36 * fineness + 1, 72 * fineness + 1, 40 * fineness + 1 }, { -0.98, 0.98 }, { 0.0, 1.0 },
      [](double outward, double) { return 0.06 * std::pow(17.0, outward); } }));
  flow->SetMaximumTime(time);
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(flow->GetOutputPort());
  mapping->SetFormula(vtkInflowMapping::ALL, "v");
  mapping->Update();
  return { vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0)), mapping, cylinder,
    2.0 * vtkMath::Pi() * cylinder->GetRadius() };
}

vtkSmartPointer<vtkPolyData> MakeStreamSurface(
  vtkDataSet* samples, double inflow, double start, double end)
{
  vtkNew<vtkFlowVolume> filter;
  filter->SetInputData(samples);
  filter->SetStreamSurface(0, inflow);
  filter->SetTimeRange(start, end);
  filter->GenerateStreamSurfacesOn();
  filter->GenerateNormalsOn();
  vtkNew<vtkDataSetSurfaceFilter> triangles;
  triangles->SetInputConnection(filter->GetOutputPort(STREAM_SURFACES));
  triangles->Update();
  return triangles->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeTexturedSurface(
  const MappedFlow& flow, double inflow, double start, double end, double period)
{
  vtkNew<vtkStreamSurfaceParameters> parameters;
  parameters->SetInputData(MakeStreamSurface(flow.Samples, inflow, start, end));
  parameters->SetMapping(flow.Mapping);
  parameters->AddTerminationSurface(flow.Surface, 0);
  for (const std::array<double, 3>& start : flow.StartPoints)
  {
    parameters->AddStartPoint(start[0], start[1], start[2]);
  }
  parameters->SetLengthScale(1.0 / flow.Length);
  parameters->SetTimeScale(1.0 / period);
  parameters->Update();
  return parameters->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> MakeStreamVolume(
  vtkDataSet* samples, double lower, double upper, double start, double end)
{
  vtkNew<vtkFlowVolume> filter;
  filter->SetInputData(samples);
  filter->SetInterval(0, lower, upper);
  filter->SetTimeRange(start, end);
  filter->Update();
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkSmartPointer<vtkStreamlineTexture> MakeArcLengthTexture(
  int texels, const vtkColor3d& color, int lines)
{
  auto texture = vtkSmartPointer<vtkStreamlineTexture>::New();
  texture->SetNumberOfLines(lines);
  texture->SetTexelsPerLine(texels);
  texture->SetLineColor(color[0], color[1], color[2]);
  return texture;
}

vtkSmartPointer<vtkStreamlineTexture> MakeTimelineTexture(
  int texels, const vtkColor3d& color, int lines)
{
  vtkSmartPointer<vtkStreamlineTexture> texture = MakeArcLengthTexture(texels, color, lines);
  texture->SetDirection(vtkStreamlineTexture::T);
  texture->SetBackgroundColor(1.0, 1.0, 1.0, 0.0);
  return texture;
}

vtkSmartPointer<vtkActor> MakeActorWithLines(vtkPolyData* surface, const vtkColor3d& color,
  vtkStreamlineTexture* streamlines, vtkStreamlineTexture* timelines)
{
  // The actor is white and the texture provides the color of the surface, so that this color does
  // not tint the lines.
  vtkSmartPointer<vtkActor> actor = MakeActor(surface, { 1.0, 1.0, 1.0 });
  vtkStreamlineTexture* below = streamlines ? streamlines : timelines;
  below->SetBackgroundColor(color[0], color[1], color[2], 1.0);
  vtkStreamlineTexture::AddTo(actor, streamlines, timelines);
  return actor;
}

void ClipActor(vtkActor* actor, const std::array<double, 3>& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(normal.data());
  actor->GetMapper()->AddClippingPlane(plane);
}
}
