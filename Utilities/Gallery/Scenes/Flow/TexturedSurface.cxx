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
#include "vtkPoints.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationCylinder.h"

#include <cmath>

namespace gallery
{
namespace
{
/// Returns points in rings around the bent axis of the tornado.
vtkSmartPointer<vtkStructuredGrid> MakeRings(vtkAnalyticFlowSource* tornado)
{
  constexpr int outward = 37;
  constexpr int around = 73;
  constexpr int upward = 41;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < upward; ++k)
  {
    const double height = 0.01 + 0.98 * k / (upward - 1);
    double axis[2];
    for (int i = 0; i < 2; ++i)
    {
      axis[i] = tornado->GetAxisTilt()[i] * (height - 0.5) +
        tornado->GetAxisBend()[i] * std::sin(vtkMath::Pi() * height);
    }
    for (int j = 0; j < around; ++j)
    {
      const double angle = 2.0 * vtkMath::Pi() * (j % (around - 1)) / (around - 1);
      for (int i = 0; i < outward; ++i)
      {
        const double radius = 0.06 * std::pow(1.02 / 0.06, static_cast<double>(i) / (outward - 1));
        points->InsertNextPoint(axis[0] + radius * std::cos(angle),
          axis[1] + radius * std::sin(angle), 2.0 * height - 1.0);
      }
    }
  }
  auto rings = vtkSmartPointer<vtkStructuredGrid>::New();
  rings->SetDimensions(outward, around, upward);
  rings->SetPoints(points);
  return rings;
}
}

MappedFlow MakeTornado(double time)
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
  flow->SetSampleData(MakeRings(tornado));
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

vtkSmartPointer<vtkStreamlineTexture> MakeStreamlines(int texels, const vtkColor3d& color)
{
  auto texture = vtkSmartPointer<vtkStreamlineTexture>::New();
  texture->SetNumberOfLines(128);
  texture->SetTexelsPerLine(texels);
  texture->SetLineColor(color[0], color[1], color[2]);
  return texture;
}

vtkSmartPointer<vtkStreamlineTexture> MakeTimelines(int texels, const vtkColor3d& color)
{
  vtkSmartPointer<vtkStreamlineTexture> texture = MakeStreamlines(texels, color);
  texture->SetDirection(vtkStreamlineTexture::T);
  texture->SetBackgroundColor(1.0, 1.0, 1.0, 0.0);
  return texture;
}

vtkSmartPointer<vtkActor> MakeLinedActor(vtkPolyData* surface, const vtkColor3d& color,
  vtkStreamlineTexture* streamlines, vtkStreamlineTexture* timelines)
{
  // The color of the actor is white and the texture provides the color of the surface, so that the
  // color of lines does not depend on it.
  vtkSmartPointer<vtkActor> actor = MakeActor(surface, { 1.0, 1.0, 1.0 });
  vtkStreamlineTexture* below = streamlines ? streamlines : timelines;
  below->SetBackgroundColor(color[0], color[1], color[2], 1.0);
  vtkStreamlineTexture::AddTo(actor, streamlines, timelines);
  return actor;
}

void CutOpen(vtkActor* actor, const std::array<double, 3>& normal)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(normal.data());
  actor->GetMapper()->AddClippingPlane(plane);
}
}
