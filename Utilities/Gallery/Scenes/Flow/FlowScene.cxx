// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/Scenes/Flow/FlowScene.h"

#include "Gallery/Look.h"
#include "Gallery/Panel.h"
#include "Gallery/Props.h"
#include "Gallery/Volumes.h"

#include "vtkAlgorithm.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkIntervalVolume.h"
#include "vtkLight.h"
#include "vtkLineSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkStructuredGrid.h"
#include "vtkTerminationSurfaceSource.h"
#include "vtkTexture.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkTubeFilter.h"

#include <cmath>

namespace gallery
{
namespace
{
/// Returns a filter whose samples the caller must set.
vtkSmartPointer<vtkImplicitFlowField> MakeFlowFilter(
  vtkAlgorithm* field, const std::vector<vtkTerminationSurface*>& surfaces, double time)
{
  auto flow = vtkSmartPointer<vtkImplicitFlowField>::New();
  flow->SetInputConnection(field->GetOutputPort());
  for (vtkTerminationSurface* surface : surfaces)
  {
    flow->AddTerminationSurface(surface);
  }
  flow->SetMaximumTime(time);
  return flow;
}
}

vtkSmartPointer<vtkAnalyticFlowSource> MakeAnalyticFlow(int field, const FlowGrid& grid)
{
  auto source = vtkSmartPointer<vtkAnalyticFlowSource>::New();
  source->SetField(field);
  const std::array<int, 3>& dimensions = grid.Dimensions;
  source->SetDimensions(dimensions[0], dimensions[1], dimensions[2]);
  source->SetBounds(grid.Bounds.data());
  return source;
}

std::array<double, 3> GetVortexAxisPoint(vtkAnalyticFlowSource* vortex, double z)
{
  const double height = z / vortex->GetHeight() + 0.5;
  std::array<double, 3> point = { { 0.0, 0.0, z } };
  for (int i = 0; i < 2; ++i)
  {
    point[static_cast<std::size_t>(i)] = vortex->GetAxisTilt()[i] * (height - 0.5) +
      vortex->GetAxisBend()[i] * std::sin(vtkMath::Pi() * height);
  }
  return point;
}

vtkSmartPointer<vtkStructuredGrid> MakeRings(vtkAnalyticFlowSource* vortex, const RingGrid& grid)
{
  const std::array<int, 3>& n = grid.Dimensions;
  const auto interpolate = [](const std::array<double, 2>& ends, int i, int number)
  { return ends[0] + (ends[1] - ends[0]) * i / (number - 1); };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < n[2]; ++k)
  {
    const double z = interpolate(grid.Heights, k, n[2]);
    const std::array<double, 3> axis =
      vortex ? GetVortexAxisPoint(vortex, z) : std::array<double, 3>{ { 0.0, 0.0, z } };
    for (int j = 0; j < n[1]; ++j)
    {
      const double angle = 2.0 * vtkMath::Pi() * interpolate(grid.Turns, j, n[1]);
      for (int i = 0; i < n[0]; ++i)
      {
        const double radius = grid.Radius(i / (n[0] - 1.0), z);
        points->InsertNextPoint(
          axis[0] + radius * std::cos(angle), axis[1] + radius * std::sin(angle), z);
      }
    }
  }
  auto rings = vtkSmartPointer<vtkStructuredGrid>::New();
  rings->SetDimensions(n[0], n[1], n[2]);
  rings->SetPoints(points);
  return rings;
}

vtkSmartPointer<vtkStructuredGrid> MakeArcs(
  const std::array<int, 3>& dimensions, const std::array<double, 2>& turns)
{
  const auto getRadius = [](double outward, double z)
  {
    constexpr double end = 0.55;
    const double height = 0.003 + 0.577 * std::pow(outward, 1.5);
    const double radius = 0.5 * (end * end / height + height);
    return std::sqrt(radius * radius - z * z) - (radius - height);
  };
  return MakeRings(nullptr, { dimensions, { { -0.5, 0.5 } }, turns, getRadius });
}

vtkSmartPointer<vtkAnalyticFlowSource> MakeUprightHurricane()
{
  const vtkSmartPointer<vtkAnalyticFlowSource> hurricane = MakeAnalyticFlow(
    vtkAnalyticFlowSource::HURRICANE, { { 45, 45, 19 }, { -1.3, 1.3, -1.3, 1.3, -0.5, 0.5 } });
  hurricane->SetHeight(1.0);
  hurricane->SetMaximumWind(0.5);
  hurricane->SetUpdraft(0.5);
  hurricane->SetAxisTilt(0.0, 0.0);
  hurricane->SetAxisBend(0.0, 0.0);
  return hurricane;
}

vtkSmartPointer<vtkDataSet> MakeImplicitFlow(vtkAlgorithm* field,
  const std::vector<vtkTerminationSurface*>& surfaces, const FlowGrid& samples, double time)
{
  const vtkSmartPointer<vtkImplicitFlowField> flow = MakeFlowFilter(field, surfaces, time);
  flow->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  const std::array<int, 3>& dimensions = samples.Dimensions;
  flow->SetSampleDimensions(dimensions[0], dimensions[1], dimensions[2]);
  flow->SetSampleBounds(samples.Bounds.data());
  flow->Update();
  return vtkDataSet::SafeDownCast(flow->GetOutputDataObject(0));
}

vtkSmartPointer<vtkDataSet> MakeImplicitFlow(vtkAlgorithm* field,
  const std::vector<vtkTerminationSurface*>& surfaces, vtkDataSet* samples, double time)
{
  const vtkSmartPointer<vtkImplicitFlowField> flow = MakeFlowFilter(field, surfaces, time);
  flow->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  flow->SetSampleData(samples);
  flow->Update();
  return vtkDataSet::SafeDownCast(flow->GetOutputDataObject(0));
}

vtkSmartPointer<vtkDataSet> MapInflow(vtkDataSet* flow, const std::string& formula)
{
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputData(flow);
  mapping->SetFormula(vtkInflowMapping::ALL, formula.c_str());
  mapping->Update();
  return vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0));
}

vtkSmartPointer<vtkTerminationPlane> MakeInflowPlane(const std::array<double, 3>& center,
  const std::array<double, 3>& u, const std::array<double, 3>& v)
{
  double corners[3][3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    corners[0][i] = center[i] - u[i] - v[i];
    corners[1][i] = center[i] + u[i] - v[i];
    corners[2][i] = center[i] - u[i] + v[i];
  }
  auto plane = vtkSmartPointer<vtkTerminationPlane>::New();
  plane->SetOrigin(corners[0]);
  plane->SetPoint1(corners[1]);
  plane->SetPoint2(corners[2]);
  return plane;
}

vtkSmartPointer<vtkUnstructuredGrid> GetFlowSurface(vtkFlowVolume* filter, int port, int id)
{
  return SelectTriangles(vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port)),
    port == STREAM_SURFACES ? "StreamSurfaceId" : "TimeSurfaceId", id);
}

vtkSmartPointer<vtkUnstructuredGrid> GetSmoothFlowSurface(vtkFlowVolume* filter, int port, int id)
{
  vtkSmartPointer<vtkUnstructuredGrid> surface = GetFlowSurface(filter, port, id);
  SetGradientNormals(surface->GetPointData(), vtkIntervalVolume::LOWER_SIDE);
  return surface;
}

vtkSmartPointer<vtkActor> MakeFlowActor(vtkUnstructuredGrid* surface, const vtkColor3d& color)
{
  vtkNew<vtkDataSetSurfaceFilter> triangles;
  triangles->SetInputData(surface);
  triangles->Update();
  return MakeActor(triangles->GetOutput(), color);
}

vtkSmartPointer<vtkActor> MakeFlowActor(vtkUnstructuredGrid* surface, vtkTexture* texture)
{
  vtkSmartPointer<vtkActor> actor = MakeFlowActor(surface, vtkColor3d(1.0, 1.0, 1.0));
  actor->SetTexture(texture);
  return actor;
}

vtkSmartPointer<vtkActor> MakeTerminationActor(vtkTerminationSurface* surface, vtkTexture* texture)
{
  vtkNew<vtkTerminationSurfaceSource> source;
  source->SetSurface(surface);
  source->SetResolutionU(128);
  source->SetResolutionV(128);
  source->Update();
  vtkSmartPointer<vtkActor> actor = MakeActor(source->GetOutput(), { 1.0, 1.0, 1.0 });
  actor->SetTexture(texture);
  return actor;
}

vtkSmartPointer<vtkActor> MakeSphere(
  const std::array<double, 3>& center, double radius, const vtkColor3d& color)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center[0], center[1], center[2]);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  sphere->Update();
  return MakeActor(sphere->GetOutput(), color);
}

vtkSmartPointer<vtkActor> MakePillar(
  double radius, double bottom, double top, const vtkColor3d& color)
{
  vtkNew<vtkLineSource> axis;
  axis->SetPoint1(0.0, 0.0, bottom);
  axis->SetPoint2(0.0, 0.0, top);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(axis->GetOutputPort());
  tube->SetRadius(radius);
  tube->SetNumberOfSides(96);
  tube->CappingOn();
  tube->Update();
  return MakeActor(MakeSurface(tube->GetOutput()), color);
}

void LightFromAllSides(Panel& panel)
{
  panel.SetLights({ MakeCameraLight(-0.7, 0.9, 1.0, 0.6), MakeCameraLight(1.2, 0.2, 0.9, 0.35),
    MakeCameraLight(0.0, -1.0, 0.7, 0.5), MakeCameraLight(0.0, 0.0, 1.0, 0.5) });
}

void SetTexturedBoundary(vtkVolume* volume, vtkUnstructuredGrid* surfaces, const char* ids,
  const std::vector<vtkSmartPointer<vtkTexture>>& textures)
{
  SetBoundary(volume, surfaces, { 1.0, 1.0, 1.0 }, 1.0);
  vtkTimeWeightedTetrahedraMapper* mapper = GetMapper(volume);
  mapper->SetBoundaryIdArrayName(ids);
  vtkNew<vtkProperty> hidden;
  hidden->SetOpacity(0.0);
  for (int i = 0; i < static_cast<int>(textures.size()); ++i)
  {
    vtkTexture* texture = textures[static_cast<std::size_t>(i)];
    texture ? mapper->SetBoundaryTexture(i, texture) : mapper->SetBoundaryProperty(i, hidden);
  }
}
}
