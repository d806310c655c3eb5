// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Mixed/MixedCases.h"

#include "Support/Images/ShadowCases.h"

#include "vtkCubeSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

namespace mixed
{
namespace
{
using reference::Double3;
using reference::MixedScene;
using reference::SceneSurface;
using Box = std::array<double, 6>;

constexpr double Floor = -0.6;

SceneSurface MakeSurface(vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  SceneSurface surface;
  surface.Actor = vtkSmartPointer<vtkActor>::New();
  surface.Actor->SetMapper(mapper);
  surface.Actor->GetProperty()->SetAmbient(0.0);
  surface.Actor->GetProperty()->SetDiffuse(1.0);
  surface.Actor->GetProperty()->SetSpecular(0.0);
  return surface;
}

SceneSurface MakeBox(const Box& bounds)
{
  vtkNew<vtkCubeSource> box;
  box->SetBounds(bounds.data());
  return MakeSurface(box);
}

/// Returns a sphere with about \a triangles triangles.
SceneSurface MakeSphere(const Double3& center, double radius, int triangles)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center[0], center[1], center[2]);
  sphere->SetRadius(radius);
  const int rows = std::max(static_cast<int>(std::sqrt(triangles / 4.0)), 6);
  sphere->SetPhiResolution(rows);
  sphere->SetThetaResolution(2 * rows);
  return MakeSurface(sphere);
}

SceneSurface MakeFloor(double height, double half)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-half, -half, height);
  plane->SetPoint1(half, -half, height);
  plane->SetPoint2(-half, half, height);
  return MakeSurface(plane);
}

/// Adds spheres on two circles around the center of \a bounds, and a plane below the spheres. The
/// spheres have about \a triangles triangles in total.
void AddSpheres(MixedScene& scene, const double bounds[6], int triangles)
{
  constexpr int count = 16;
  const double half = 0.5 * std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  const double center[2] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]) };
  const double radius = 0.2 * half;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / count;
    const double reach = (i % 2 == 0 ? 0.75 : 1.15) * half;
    scene.Surfaces.push_back(
      MakeSphere({ { center[0] + reach * std::cos(angle), center[1] + reach * std::sin(angle),
                   bounds[4] + radius } },
        radius, triangles / count));
  }
  SceneSurface floor = MakeFloor(bounds[4], 1.5 * half);
  floor.Actor->SetPosition(center[0], center[1], 0.0);
  scene.Surfaces.push_back(floor);
}
}

Case MakePosts(int pixels, int triangles)
{
  Case made;
  made.Name = "posts";
  made.Scene.Size = { { pixels, pixels } };
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(0.0, 0.0, 4.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.1);
  camera->SetClippingRange(0.5, 8.0);
  made.Scene.Camera = camera;
  made.LightPosition = { { -1.5, 0.4, 3.4 } };
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(23.0);
  light->SetPosition(made.LightPosition.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetShadowAttenuation(1.0F);
  made.Scene.Lights = { { light, {} } };
  made.Scene.Surfaces = { MakeFloor(Floor, 1.0), MakeBox({ { -0.8, -0.4, -0.3, 0.3, -0.4, 0.0 } }),
    MakeSphere({ { 0.1, 0.5, -0.1 } }, 0.25, triangles) };
  for (int i = 0; i < 9; ++i)
  {
    const double x = 0.1 + 0.2 * (i % 3);
    const double y = -0.7 + 0.25 * (i / 3);
    made.Scene.Surfaces.push_back(MakeBox({ { x, x + 0.04, y, y + 0.04, Floor, -0.2 } }));
  }
  return made;
}

Case MakeVolumeAmongSpheres(
  const std::string& name, const reference::ShadowScene& volume, int pixels, int triangles)
{
  Case made;
  made.Name = name;
  made.Scene.Size = { { pixels, pixels } };
  made.Scene.Volumes = { volume };
  const double* bounds = volume.Image->GetBounds();
  made.Scene.Camera = vtkSmartPointer<vtkCamera>::New();
  double center[3];
  volume.Image->GetCenter(center);
  const double reach = 2.2 * (bounds[1] - bounds[0]);
  made.Scene.Camera->SetFocalPoint(center);
  made.Scene.Camera->SetPosition(center[0], center[1] - reach, center[2] + 0.6 * reach);
  made.Scene.Camera->SetViewUp(0.0, 0.0, 1.0);
  made.Scene.Camera->SetClippingRange(0.1 * reach, 3.0 * reach);
  auto sun = reference::MakeDirectionalLight({ { 0.6, 0.3, -1.0 } });
  sun->SetIntensity(1.0);
  sun->SetShadowAttenuation(1.0F);
  sun->GetPosition(made.LightPosition.data());
  made.Scene.Lights = { { sun, {} } };
  AddSpheres(made.Scene, bounds, triangles);
  return made;
}
}
