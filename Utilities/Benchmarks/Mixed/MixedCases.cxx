// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Mixed/MixedCases.h"

#include "Benchmarks/Shadows/ShadowsScene.h"
#include "Support/Pictures/ShadowCases.h"

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
using reference::SceneVolume;
using Box = std::array<double, 6>;

constexpr double Floor = -0.6;
const Double3 SunDirection{ { 0.5, 0.0, -1.0 } };
const Double3 EyeDirection{ { 0.0, 0.7, -1.0 } };
const Box Slab{ { -0.8, 0.8, -0.8, 0.8, -0.15, 0.15 } };

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

/// Of about so many triangles.
SceneSurface MakeBall(const Double3& center, double radius, int triangles)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(center[0], center[1], center[2]);
  ball->SetRadius(radius);
  const int rows = std::max(static_cast<int>(std::sqrt(triangles / 4.0)), 6);
  ball->SetPhiResolution(rows);
  ball->SetThetaResolution(2 * rows);
  return MakeSurface(ball);
}

/// Larger than pictures, so that its edges are not what changes from view to view.
SceneSurface MakeFloor(double height = Floor, double half = 3.0)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-half, -half, height);
  plane->SetPoint1(half, -half, height);
  plane->SetPoint2(-half, half, height);
  return MakeSurface(plane);
}

/// Homogeneous, of optical depth 1 along z.
SceneVolume MakeSmoke(const Box& bounds, int cells)
{
  SceneVolume smoke = reference::MakeHomogeneousScene(cells, 1.0 / (bounds[5] - bounds[4]));
  smoke.Image->SetOrigin(bounds[0], bounds[2], bounds[4]);
  smoke.Image->SetSpacing((bounds[1] - bounds[0]) / cells, (bounds[3] - bounds[2]) / cells,
    (bounds[5] - bounds[4]) / cells);
  return smoke;
}

vtkSmartPointer<vtkLight> MakeLamp(const Double3& position, double cone)
{
  auto lamp = vtkSmartPointer<vtkLight>::New();
  lamp->SetLightTypeToSceneLight();
  lamp->PositionalOn();
  lamp->SetConeAngle(cone);
  lamp->SetPosition(position.data());
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetShadowAttenuation(1.0F);
  return lamp;
}

Case MakeCase(const std::string& name, int pixels, vtkLight* light, const Double3& eye)
{
  Case made;
  made.Name = name;
  made.Scene.Size = { { pixels, pixels } };
  made.Scene.Camera = LookAlong(eye);
  made.Scene.Lights.push_back({ light, {} });
  light->GetPosition(made.LightPosition.data());
  return made;
}

Case MakeSlab(const std::string& name, int pixels, vtkLight* light, const Double3& eye,
  const std::array<double, 2>& heights)
{
  Case made = MakeCase("slab-" + name, pixels, light, eye);
  made.Scene.Surfaces = { MakeFloor(),
    MakeBox({ { -0.3, 0.1, -0.2, 0.2, heights[0], heights[1] } }) };
  made.Scene.Volumes = { MakeSmoke(Slab, 16) };
  return made;
}

/// Balls in a circle around what is in the middle, on a plane as large as they need.
void AddBalls(MixedScene& scene, const double bounds[6], int triangles)
{
  constexpr int count = 16;
  const double half = 0.5 * std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  const double middle[2] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]) };
  const double radius = 0.2 * half;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / count;
    const double reach = (i % 2 == 0 ? 0.75 : 1.15) * half;
    scene.Surfaces.push_back(MakeBall({ { middle[0] + reach * std::cos(angle),
                                        middle[1] + reach * std::sin(angle), bounds[4] + radius } },
      radius, triangles / count));
  }
  SceneSurface floor = MakeFloor(bounds[4], 1.5 * half);
  floor.Actor->SetPosition(middle[0], middle[1], 0.0);
  scene.Surfaces.push_back(floor);
}

/// The volume of a scene of slices, seen as there, its longest axis up.
Case MakeAmongBalls(const shadows::Case& from, int pixels, int triangles, const std::string& name)
{
  Case made;
  made.Name = name;
  made.Scene.Size = { { pixels, pixels } };
  made.Scene.Volumes = { from.Scene };
  const double* bounds = from.Scene.Image->GetBounds();
  made.Scene.Camera = vtkSmartPointer<vtkCamera>::New();
  double center[3];
  from.Scene.Image->GetCenter(center);
  const double reach = 2.2 * (bounds[1] - bounds[0]);
  made.Scene.Camera->SetFocalPoint(center);
  made.Scene.Camera->SetPosition(center[0], center[1] - reach, center[2] + 0.6 * reach);
  made.Scene.Camera->SetViewUp(0.0, 0.0, 1.0);
  made.Scene.Camera->SetClippingRange(0.1 * reach, 3.0 * reach);
  made.Scene.Lights = { { MakeSun({ { 0.6, 0.3, -1.0 } }), {} } };
  made.Scene.Lights.front().Light->GetPosition(made.LightPosition.data());
  AddBalls(made.Scene, bounds, triangles);
  return made;
}
}

vtkSmartPointer<vtkCamera> LookAlong(const Double3& direction)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  const double length = vtkMath::Norm(direction.data());
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(
    -4.0 * direction[0] / length, -4.0 * direction[1] / length, -4.0 * direction[2] / length);
  const bool isLevel = std::abs(direction[2]) < 0.9 * length;
  camera->SetViewUp(0.0, isLevel ? 0.0 : 1.0, isLevel ? 1.0 : 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.1);
  camera->SetClippingRange(0.5, 8.0);
  return camera;
}

vtkSmartPointer<vtkLight> MakeSun(const Double3& direction)
{
  vtkSmartPointer<vtkLight> sun = reference::MakeDirectionalLight(direction);
  sun->SetIntensity(1.0);
  sun->SetShadowAttenuation(1.0F);
  return sun;
}

std::vector<Case> MakeSlabs(int pixels)
{
  const auto sun = []() { return MakeSun(SunDirection); };
  const std::array<double, 2> below{ { Floor, -0.3 } };
  std::vector<Case> cases = { MakeSlab("behind", pixels, sun(), EyeDirection, below),
    MakeSlab("within", pixels, sun(), EyeDirection, { { -0.1, 0.1 } }),
    MakeSlab("across", pixels, sun(), EyeDirection, { { -0.3, 0.3 } }),
    MakeSlab("before", pixels, sun(), EyeDirection, { { 0.25, 0.5 } }),
    MakeSlab("against", pixels, MakeSun({ { 0.4, -1.0, -0.8 } }), { { 0.0, 1.0, -0.6 } },
      { { -0.1, 0.1 } }),
    MakeSlab("lamp", pixels, MakeLamp({ { -1.5, 0.0, 3.0 } }, 180.0), EyeDirection, below),
    MakeSlab("two", pixels, sun(), EyeDirection, below) };
  cases.back().Scene.Volumes.push_back(MakeSmoke({ { -0.5, 0.9, -0.6, 0.6, 0.0, 0.4 } }, 16));
  return cases;
}

Case MakePosts(int pixels, int triangles)
{
  Case made =
    MakeCase("posts", pixels, MakeLamp({ { -1.5, 0.4, 3.4 } }, 23.0), { { 0.0, 0.0, -1.0 } });
  made.Scene.Surfaces = { MakeFloor(Floor, 1.0), MakeBox({ { -0.8, -0.4, -0.3, 0.3, -0.4, 0.0 } }),
    MakeBall({ { 0.1, 0.5, -0.1 } }, 0.25, triangles) };
  for (int i = 0; i < 9; ++i)
  {
    const double x = 0.1 + 0.2 * (i % 3);
    const double y = -0.7 + 0.25 * (i / 3);
    made.Scene.Surfaces.push_back(MakeBox({ { x, x + 0.04, y, y + 0.04, Floor, -0.2 } }));
  }
  return made;
}

Case MakeBonsaiAmongBalls(int pixels, int step, int triangles)
{
  return MakeAmongBalls(shadows::MakeBonsai(step, step), pixels, triangles, "bonsai");
}

Case MakeSmokeAmongBalls(int pixels, int points, int triangles)
{
  return MakeAmongBalls(shadows::MakeSmoke(points), pixels, triangles, "smoke");
}

std::vector<Case> MakeTurned(int pixels, int points)
{
  const auto sun = []() { return MakeSun({ { 0.5, 0.2, -1.0 } }); };
  std::vector<Case> cases = { MakeSlab("across", pixels, sun(), EyeDirection, { { -0.3, 0.3 } }) };
  cases.front().Name = "slab";

  cases.push_back(MakeCase("ball-in-smoke", pixels, sun(), EyeDirection));
  cases.back().Scene.Surfaces = { MakeFloor(-0.5), MakeBall({ { -0.2, 0.1, 0.0 } }, 0.2, 2000),
    MakeBox({ { 0.3, 0.5, -0.5, 0.1, -0.5, 0.4 } }) };
  cases.back().Scene.Volumes = { MakeSmoke({ { -0.5, 0.5, -0.4, 0.4, -0.3, 0.3 } }, points) };

  cases.push_back(MakeCase("rod-in-rings", pixels, sun(), EyeDirection));
  cases.back().Scene.Surfaces = { MakeFloor(-1.0),
    MakeBox({ { -0.9, 0.9, -0.05, 0.05, -0.05, 0.05 } }) };
  cases.back().Scene.Volumes = { shadows::MakeRings(points).Scene };

  cases.push_back(MakeSlab("two", pixels, sun(), EyeDirection, { { Floor, -0.3 } }));
  cases.back().Name = "two-slabs";
  cases.back().Scene.Volumes.push_back(MakeSmoke({ { -0.5, 0.9, -0.6, 0.6, 0.0, 0.4 } }, 16));

  cases.push_back(MakeBonsaiAmongBalls(pixels, std::max(256 / points, 1), 8000));
  return cases;
}
}
