// SPDX-License-Identifier: BSD-3-Clause
// Checks the reference renderer for volumes and surfaces by closed forms: homogeneous smoke, shadow
// edges, penumbras, and surfaces in front of, inside, behind and between volumes.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Images/LightPoints.h"
#include "Support/Images/MixedScene.h"
#include "Support/Images/ReferenceMixedImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace
{

using namespace reference;

constexpr double Bound = 1e-6;
constexpr double Tau = 3.0;
constexpr int Width = 48;

vtkSmartPointer<vtkActor> MakeActor(vtkPolyDataAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->GetProperty()->SetAmbient(0.0);
  actor->GetProperty()->SetDiffuse(1.0);
  actor->GetProperty()->SetSpecular(0.0);
  return actor;
}

/// Creates the rectangle [x0, x1] x [-5, 5] at z = \a height.
vtkSmartPointer<vtkActor> MakePlate(double height, double x0 = -5.0, double x1 = 5.0)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x0, -5.0, height);
  plane->SetPoint1(x1, -5.0, height);
  plane->SetPoint2(x0, 5.0, height);
  plane->SetResolution(3, 2);
  return MakeActor(plane);
}

/// Returns a camera with parallel projection that looks down from z = \a height. The view is 2
/// units wide and 4 units deep.
vtkSmartPointer<vtkCamera> LookDown(double height)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetPosition(0.0, 0.0, height);
  camera->SetFocalPoint(0.0, 0.0, height - 1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
  camera->SetClippingRange(1e-6, 4.0);
  return camera;
}

/// Returns the x coordinate of the pixel centers of column \a i in the view of LookDown().
double GetX(int i)
{
  return 2.0 * (i + 0.5) / Width - 1.0;
}

MixedScene MakeScene(double height, vtkLight* light)
{
  MixedScene scene;
  scene.Camera = LookDown(height);
  scene.Size = { { Width, Width } };
  light->SetIntensity(1.0);
  scene.Lights.push_back({ light, {} });
  return scene;
}

/// Returns a homogeneous unit cube centered at the origin, with optical depth Tau along each edge.
SceneVolume MakeSmoke()
{
  SceneVolume smoke = MakeHomogeneousScene(4, Tau);
  return smoke;
}

void ExpectCenter(
  Check& check, const MixedScene& scene, double seen, double alpha, const std::string& what)
{
  const RgbaImage image = MakeMixedImage(scene);
  const double* pixel = image.At(Width / 2, Width / 2);
  check.Near(pixel[0], seen, Bound, what, 1.0);
  check.Near(pixel[3], alpha, Bound, what + ", alpha", 1.0);
}

/// A plate below a cube of smoke receives the fraction exp(-tau) of the light.
void TestSmokeShadow(Check& check)
{
  auto scene = MakeScene(-0.6, MakeDirectionalLight({ { 0.0, 0.0, -1.0 } }));
  scene.Surfaces.push_back({ MakePlate(-0.7), {} });
  scene.Volumes = { MakeSmoke() };
  ExpectCenter(check, scene, std::exp(-Tau), 1.0, "light through smoke");
  scene.Lights[0].Light->SetShadowAttenuation(0.25);
  ExpectCenter(check, scene, 0.75 + 0.25 * std::exp(-Tau), 1.0, "a quarter of the shadow strength");
  scene.Lights[0].Light->SetShadowAttenuation(1.0);
  const double pi = vtkMath::Pi();
  for (double degrees : { 5.0, 15.0 })
  {
    const double angle = degrees * pi / 180.0;
    scene.Lights[0].Light = MakeDirectionalLight({ { std::sin(angle), 0.0, -std::cos(angle) } });
    scene.Lights[0].Light->SetIntensity(1.0);
    ExpectCenter(check, scene, std::cos(angle) * std::exp(-Tau / std::cos(angle)), 1.0,
      "oblique light through smoke");
  }
  // Two cubes that overlap by a quarter. Their extinctions add up in the overlap.
  SceneVolume second = MakeSmoke();
  second.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  second.Matrix->SetElement(2, 3, 0.75);
  scene.Volumes.push_back(second);
  scene.Lights[0].Light = MakeDirectionalLight({ { 0.0, 0.0, -1.0 } });
  scene.Lights[0].Light->SetIntensity(1.0);
  ExpectCenter(check, scene, std::exp(-2.0 * Tau), 1.0, "light through two volumes");
  scene.Shadows = false;
  ExpectCenter(check, scene, 1.0, 1.0, "no shadows");
}

/// Tests a surface seen through smoke, and smoke in front of and behind a translucent surface.
void TestOrder(Check& check)
{
  auto scene = MakeScene(1.0, MakeDirectionalLight({ { 0.0, 0.0, -1.0 } }));
  scene.Volumes = { MakeSmoke() };
  // The light travels along the view direction, so that light scattered at depth t is attenuated by
  // exp(-2 t).
  const auto scattered = [](double depth) { return -0.5 * std::expm1(-2.0 * depth); };
  for (double height : { -0.7, -0.5, -0.3, 0.2, 0.5 })
  {
    const double depth = Tau * std::min(1.0, 0.5 - height);
    scene.Surfaces = { { MakePlate(height), {} } };
    ExpectCenter(check, scene, scattered(depth) + std::exp(-2.0 * depth), 1.0,
      "a plate at " + std::to_string(height));
  }
  const double opacity = 0.3;
  const double depth = 0.4 * Tau;
  scene.Surfaces = { { MakePlate(0.1), {} } };
  scene.Surfaces[0].Actor->GetProperty()->SetOpacity(opacity);
  const double before = std::exp(-2.0 * depth);
  const double behind = (1.0 - opacity) * (1.0 - opacity) * before * scattered(Tau - depth);
  ExpectCenter(check, scene, scattered(depth) + opacity * before + behind,
    1.0 - (1.0 - opacity) * std::exp(-Tau), "a translucent plate in smoke");

  // Two overlapping volumes, seen and lit from above.
  SceneVolume second = MakeSmoke();
  second.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  second.Matrix->SetElement(2, 3, -0.75);
  scene.Volumes.push_back(second);
  scene.Surfaces.clear();
  ExpectCenter(check, scene, scattered(2.0 * Tau), -std::expm1(-2.0 * Tau), "two volumes");
}

/// An opaque plate through the middle of the cube, seen from the side and lit from above.
void TestSurfaceInSmoke(Check& check)
{
  auto scene = MakeScene(0.0, MakeDirectionalLight({ { 0.0, 0.0, -1.0 } }));
  scene.Camera->SetPosition(0.0, -2.0, 0.0);
  scene.Camera->SetFocalPoint(0.0, 0.0, 0.0);
  scene.Camera->SetViewUp(0.0, 0.0, 1.0);
  scene.Volumes = { MakeSmoke() };
  scene.Surfaces = { { MakePlate(0.1), {} } };
  const RgbaImage image = MakeMixedImage(scene);
  for (int j = 0; j < Width; ++j)
  {
    const double z = GetX(j);
    const double light = z > 0.1 ? std::exp(-Tau * (0.5 - z)) : 0.0;
    const double expected = std::abs(z) < 0.5 ? light * -std::expm1(-Tau) : 0.0;
    check.Near(image.At(Width / 2, j)[0], expected, Bound, "z " + std::to_string(z), 1.0);
  }
  vtkNew<vtkPlane> cut;
  cut->SetNormal(1.0, 0.0, 0.0);
  cut->SetOrigin(1.0, 0.0, 0.0);
  scene.Surfaces[0].Actor->GetMapper()->AddClippingPlane(cut);
  check.Near(MakeMixedImage(scene).At(Width / 2, Width / 2)[0],
    std::exp(-Tau * (0.5 - GetX(Width / 2))) * -std::expm1(-Tau), Bound, "a clipped plate", 1.0);
}

/// A box casts a hard shadow; every pixel is checked.
void TestBoxShadow(Check& check)
{
  auto scene = MakeScene(0.05, MakeDirectionalLight({ { 1.0, 0.0, -1.0 } }));
  scene.Surfaces.push_back({ MakePlate(0.0), {} });
  vtkNew<vtkCubeSource> box;
  box->SetBounds(-0.5, -0.1, -0.3, 0.3, 0.1, 0.4);
  scene.Surfaces.push_back({ MakeActor(box), {} });
  const RgbaImage image = MakeMixedImage(scene);
  for (const auto& [j, i] : AllIndices(Width, Width))
  {
    // The light direction has equal components along x and -z.
    const double x = GetX(i);
    const bool isShadowed = x > -0.4 && x < 0.3 && std::abs(GetX(j)) < 0.3;
    check.Near(image.At(i, j)[0], isShadowed ? 0.0 : std::sqrt(0.5), Bound,
      "box, pixel " + std::to_string(i) + ", " + std::to_string(j), 1.0);
  }
}

/// Returns the visible fraction of a square light with edge length 1 behind a straight edge at
/// signed distance \a s from its center.
double GetSquareFraction(double s)
{
  return vtkMath::ClampValue(0.5 + s, 0.0, 1.0);
}

double GetRoundFraction(double s)
{
  const double x = vtkMath::ClampValue(2.0 * s, -1.0, 1.0);
  return 0.5 + (std::asin(x) + x * std::sqrt(1.0 - x * x)) / vtkMath::Pi();
}

/// A half plane at distance dz above a plate and z below a light of size L casts a penumbra of
/// width L dz / z.
void TestPenumbra(Check& check)
{
  const double size = 0.5;
  const double z = 1.0;
  for (double dz : { 0.05, 0.5, 2.0 })
  {
    for (bool isRound : { false, true })
    {
      const Double3 center = { { 0.0, 0.0, z + dz } };
      auto scene = MakeScene(0.5 * std::min(dz, 1.0), MakePositionalLight(center));
      const Double3 side = { { size, 0.0, 0.0 } };
      const Double3 up = { { 0.0, size, 0.0 } };
      scene.Lights[0].Points = isRound ? MakeEllipseLightPoints(center, side, up, 256)
                                       : MakeParallelogramLightPoints(center, side, up, 16);
      scene.Surfaces = { { MakePlate(0.0), {} } };
      const RgbaImage lit = MakeMixedImage(scene);
      scene.Surfaces.push_back({ MakePlate(dz, -5.0, 0.0), {} });
      const RgbaImage shadowed = MakeMixedImage(scene);
      for (int i = 0; i < Width; ++i)
      {
        const double s = GetX(i) * z / (size * dz);
        const double found = shadowed.At(i, Width / 2)[0] / lit.At(i, Width / 2)[0];
        check.Near(found, isRound ? GetRoundFraction(s) : GetSquareFraction(s),
          isRound ? 0.01 : 0.0021, "penumbra at " + std::to_string(s), 1.0);
      }
    }
  }
  // For a directional light, half the penumbra width is the distance times the tangent of the half
  // angle.
  auto scene = MakeScene(0.2, MakeDirectionalLight({ { 0.0, 0.0, -1.0 } }));
  scene.Lights[0].Points = MakeParallelogramLightPoints(
    { { 0.0, 0.0, 1.0 } }, { { size, 0.0, 0.0 } }, { { 0.0, size, 0.0 } }, 16);
  scene.Surfaces = { { MakePlate(0.0), {} }, { MakePlate(0.5, -5.0, 0.0), {} } };
  const RgbaImage image = MakeMixedImage(scene);
  for (int i = 0; i < Width; ++i)
  {
    check.Near(image.At(i, Width / 2)[0], GetSquareFraction(GetX(i) / (0.5 * size)), 0.0021,
      "penumbra of a directional light", 1.0);
  }
}

/// Tests a light sampled at two points of different colors. Where one point is hidden, the surface
/// has the color of the other.
void TestColoredPoints(Check& check)
{
  auto scene = MakeScene(0.2, MakePositionalLight({ { 0.0, 0.0, 1.0 } }));
  scene.Lights[0].Points = { { { { -0.5, 0.0, 1.0 } }, { { 2.0, 0.0, 0.0 } } },
    { { { 0.5, 0.0, 1.0 } }, { { 0.0, 2.0, 0.0 } } } };
  scene.Surfaces = { { MakePlate(0.0), {} }, { MakePlate(0.5, -5.0, 0.0), {} } };
  const RgbaImage image = MakeMixedImage(scene);
  const double* pixel = image.At(Width / 2 + 4, Width / 2);
  check.Near(pixel[0], 0.0, Bound, "red is shadowed", 1.0);
  const double x = GetX(Width / 2 + 4);
  const double y = GetX(Width / 2);
  check.Near(pixel[1], 1.0 / std::sqrt(1.0 + x * x + y * y), Bound, "green is visible", 1.0);
}

/// Tests the shading of a sphere with a specular term and position-dependent colors, with and
/// without mirroring the actor.
void TestShading(Check& check)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.6);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  auto scene = MakeScene(1.0, MakeDirectionalLight({ { -0.6, 0.0, -0.8 } }));
  scene.Surfaces.push_back({ MakeActor(sphere), {} });
  scene.Surfaces[0].Actor->GetProperty()->SetAmbient(0.1);
  scene.Surfaces[0].Actor->GetProperty()->SetSpecular(0.5);
  scene.Surfaces[0].Actor->GetProperty()->SetSpecularPower(4.0);
  scene.Surfaces[0].Color = [](const Double3& x) { return Double3{ { 1.0, 0.5, x[2] } }; };
  for (double mirror : { 1.0, -1.0 })
  {
    scene.Surfaces[0].Actor->SetScale(1.0, mirror, 1.0);
    const RgbaImage image = MakeMixedImage(scene);
    for (int i = Width / 4; i < 3 * Width / 4; ++i)
    {
      const double x = GetX(i);
      const double y = GetX(Width / 2);
      const double height = std::sqrt(0.36 - x * x - y * y);
      const double cosine = std::max((0.6 * x + 0.8 * height) / 0.6, 0.0);
      const double glint = std::max(2.0 * cosine * height / 0.6 - 0.8, 0.0);
      const double diffuse = 0.1 + cosine;
      const double specular = cosine > 0.0 ? 0.5 * std::pow(glint, 4.0) : 0.0;
      const double* pixel = image.At(i, Width / 2);
      check.Near(pixel[0], diffuse + specular, 2e-3, "sphere, full color", 1.0);
      check.Near(pixel[1], 0.5 * diffuse + specular, 2e-3, "sphere, half color", 1.0);
      check.Near(pixel[2], height * diffuse + specular, 2e-3, "sphere, color by height", 1.0);
    }
  }
  scene.Surfaces[0].Actor->SetTexture(vtkNew<vtkTexture>());
  bool isRejected = false;
  try
  {
    MakeMixedImage(scene);
  }
  catch (const std::invalid_argument&)
  {
    isRejected = true;
  }
  check.That(isRejected, "a texture is rejected");
}

void TestThreads(Check& check)
{
  auto scene = MakeScene(1.0, MakePositionalLight({ { 0.3, 0.2, 2.0 } }));
  scene.Size = { { 16, 16 } };
  scene.Lights[0].Points =
    MakeEllipseLightPoints({ { 0.3, 0.2, 2.0 } }, { { 0.5, 0.0, 0.0 } }, { { 0.0, 0.5, 0.0 } }, 5);
  scene.Volumes = { reference::MakeScene(
    MakeImage(8, MakeSphere(0.2, 0.45)), MakeTranslucentProperty(0.3, true)) };
  scene.Surfaces = { { MakePlate(-0.2), {} }, { MakePlate(0.1, -5.0, 0.0), {} } };
  scene.Surfaces[1].Actor->GetProperty()->SetOpacity(0.5);
  std::vector<double> first;
  for (int threads : { 1, 2, 8 })
  {
    SetThreads(threads);
    const std::vector<double> values = MakeMixedImage(scene).Values;
    first = first.empty() ? values : first;
    check.That(
      values == first, "the result is identical with " + std::to_string(threads) + " threads");
  }
}

}

int TestReferenceMixed(int, char*[])
{
  return RunChecks({ TestSmokeShadow, TestOrder, TestSurfaceInSmoke, TestBoxShadow, TestPenumbra,
    TestColoredPoints, TestShading, TestThreads });
}
