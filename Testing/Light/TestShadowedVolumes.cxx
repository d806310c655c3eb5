// SPDX-License-Identifier: BSD-3-Clause
// Several volumes in shared slices of vtkShadowedScenePass. They shadow each other and add up where
// they overlap. Images are compared with integration in double precision.
#include "Light/ShadowComparison.h"
#include "Support/Images/LightPoints.h"
#include "Support/Images/MixedScene.h"
#include "Support/Images/ReferenceMixedImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Checks/ReferenceReport.h"
#include "SceneStage.h"
#include "MixedSceneWindow.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace
{
using namespace reference;
using Box = std::array<double, 6>;

constexpr int Width = 40;

/// Returns a homogeneous medium with an extinction per unit length and a color. \a cells is the
/// number of voxels along x.
SceneVolume MakeMedium(const Box& box, double extinction, const Double3& color, int cells = 24)
{
  SceneVolume volume;
  volume.Image = vtkSmartPointer<vtkImageData>::New();
  const double spacing = (box[1] - box[0]) / cells;
  std::array<int, 3> points{};
  std::array<double, 3> steps{};
  for (int axis = 0; axis < 3; ++axis)
  {
    const double extent = box[2 * axis + 1] - box[2 * axis];
    points[axis] = std::max(static_cast<int>(std::lround(extent / spacing)), 1) + 1;
    steps[axis] = extent / (points[axis] - 1);
  }
  volume.Image->SetDimensions(points.data());
  volume.Image->SetOrigin(box[0], box[2], box[4]);
  volume.Image->SetSpacing(steps.data());
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  values->SetNumberOfTuples(volume.Image->GetNumberOfPoints());
  values->Fill(1.0);
  volume.Image->GetPointData()->SetScalars(values);
  volume.Property = vtkSmartPointer<vtkVolumeProperty>::New();
  vtkNew<vtkPiecewiseFunction> opacity;
  const double value = -std::expm1(-0.1 * extinction);
  opacity->AddPoint(0.0, value);
  opacity->AddPoint(2.0, value);
  volume.Property->SetScalarOpacity(opacity);
  volume.Property->SetScalarOpacityUnitDistance(0.1);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, color[0], color[1], color[2]);
  volume.Property->SetColor(colors);
  volume.Property->SetInterpolationTypeToLinear();
  volume.Property->SetAmbient(0.1);
  volume.Property->SetDiffuse(0.9);
  return volume;
}

vtkSmartPointer<vtkCamera> LookAlong(const Double3& direction, double scale = 0.9)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->SetParallelProjection(1);
  camera->SetParallelScale(scale);
  camera->SetPosition(-6.0 * direction[0], -6.0 * direction[1], -6.0 * direction[2]);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  const bool isAlongY = std::abs(direction[1]) > 0.9;
  camera->SetViewUp(0.0, isAlongY ? 0.0 : 1.0, isAlongY ? 1.0 : 0.0);
  camera->SetClippingRange(1.0, 12.0);
  return camera;
}

const Double3 WHITE{ { 1.0, 1.0, 1.0 } };
const Double3 RED{ { 1.0, 0.3, 0.2 } };
const Double3 BLUE{ { 0.2, 0.4, 1.0 } };

MixedScene MakeScene(
  const std::vector<SceneVolume>& volumes, const Double3& light, const Double3& view)
{
  MixedScene scene;
  scene.Volumes = volumes;
  scene.Lights.push_back({ MakeSun(light), {} });
  scene.Camera = LookAlong(view);
  scene.Size = { { Width, Width } };
  return scene;
}

/// Compares the frame with the reference, and with a frame in which the volumes are in reverse
/// order.
void TestScene(
  Check& check, const std::string& name, const MixedScene& scene, const ImageBound& bound)
{
  MixedSceneWindow pile(scene);
  const RgbaImage image = pile.Draw();
  const auto volumes = static_cast<int>(scene.Volumes.size());
  check.Equal(pile.GetReport()->GetCount("VolumesInSharedSlices"), volumes,
    name + ": volumes in shared slices");
  check.That(
    pile.GetReport()->GetText("SeparateVolumesReason").empty(), name + ": no separate volumes");
  check.Equal(pile.Mappers[0]->GetReport()->GetCount("LightBuffers"),
    static_cast<int>(scene.Lights.size()), name + ": one buffer per light");
  ExpectSimilar(check, name, image, MakeMixedImage(scene), bound);
  MixedSceneWindow reversed(scene, true);
  check.Near(CompareImages(image, reversed.Draw()).Max, 0.0, 1e-6,
    name + ": same image in reverse order", 1.0);
}

/// Tests two boxes that are disjoint, overlap or are nested, with different lights and views.
void TestBoxes(Check& check)
{
  const Box lower{ { -0.5, 0.1, -0.3, 0.3, -0.5, -0.1 } };
  const Box upper{ { -0.2, 0.5, -0.25, 0.35, 0.05, 0.5 } };
  const Box half{ { -0.1, 0.5, -0.3, 0.3, -0.3, 0.1 } };
  const Box inner{ { -0.3, -0.1, -0.1, 0.1, -0.4, -0.2 } };
  const std::vector<std::tuple<std::string, Double3, Double3>> rays = {
    { "along", { { 0.0, 0.0, -1.0 } }, { { 0.0, 1.0, 0.0 } } },
    { "with the view", { { 0.1, 0.5, -1.0 } }, { { 0.0, 0.4, -1.0 } } },
    { "against the view", { { 0.2, -0.4, 1.0 } }, { { 0.1, 0.6, -1.0 } } },
    { "across", { { 1.0, 0.2, -0.7 } }, { { -0.3, 1.0, -0.2 } } },
  };
  const std::vector<std::pair<std::string, Box>> others = { { "disjoint", upper },
    { "overlapping", half }, { "inside", inner } };
  for (const auto& [position, box] : others)
  {
    for (const auto& [kind, light, view] : rays)
    {
      Double3 direction = view;
      vtkMath::Normalize(direction.data());
      const MixedScene scene =
        MakeScene({ MakeMedium(lower, 2.0, RED), MakeMedium(box, 3.0, BLUE) }, light, direction);
      // If view rays are parallel to faces, a few of them graze a face or a shadow boundary.
      const double largest = kind == "along" ? 0.2 : 0.04;
      TestScene(check, position + ", " + kind, scene, { largest, 0.0005 });
    }
  }
}

/// Draws a scene with the pass, after applying \a change if it is set.
RgbaImage Draw(const MixedScene& scene, const std::function<void(MixedSceneWindow&)>& change = {})
{
  MixedSceneWindow pile(scene);
  if (change)
  {
    change(pile);
  }
  return pile.Draw();
}

/// Returns a part of a cube of inhomogeneous smoke: a range of its 32 cells along x. The extinction
/// is scaled by \a fraction.
SceneVolume MakeSmoke(int first, int last, double fraction = 1.0)
{
  constexpr double extinction = 3.0;
  SceneVolume volume = MakeMedium({ { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } }, extinction, WHITE);
  const std::array<int, 3> points{ { last - first + 1, 33, 33 } };
  volume.Image->SetDimensions(points.data());
  volume.Image->SetSpacing(1.0 / 32, 1.0 / 32, 1.0 / 32);
  volume.Image->SetOrigin(first / 32.0 - 0.5, -0.5, -0.5);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  for (int k = 0; k < points[2]; ++k)
  {
    for (int j = 0; j < points[1]; ++j)
    {
      for (int i = first; i <= last; ++i)
      {
        values->InsertNextValue(
          0.5 + 0.5 * std::sin(0.4 * i) * std::cos(0.3 * j) * std::sin(0.2 * k));
      }
    }
  }
  volume.Image->GetPointData()->SetScalars(values);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(1.0, -std::expm1(-0.1 * extinction));
  volume.Property->SetScalarOpacity(opacity);
  volume.Property->SetScalarOpacityUnitDistance(0.1 / fraction);
  return volume;
}

/// Two halves look like the complete volume, without a seam, for any orientation of their common
/// face. Two volumes of half the density look like one volume, too.
void TestHalves(Check& check)
{
  const std::vector<std::tuple<std::string, Double3, Double3>> rays = {
    { "face along the light", { { 0.0, 0.3, -1.0 } }, { { 0.0, 1.0, -0.4 } } },
    { "light and view from different sides", { { 1.0, 0.1, -0.3 } }, { { -0.8, 0.5, -0.4 } } },
    { "light toward the camera", { { -1.0, 0.2, 0.3 } }, { { 0.9, 0.1, -0.2 } } },
  };
  for (const auto& [kind, light, view] : rays)
  {
    Double3 direction = view;
    vtkMath::Normalize(direction.data());
    const auto draw = [&, light = light](const std::vector<SceneVolume>& volumes)
    { return Draw(MakeScene(volumes, light, direction)); };
    const RgbaImage complete = draw({ MakeSmoke(0, 32) });
    ExpectSimilar(check, "two halves, " + kind, draw({ MakeSmoke(0, 16), MakeSmoke(16, 32) }),
      complete, { 0.0005, 5e-6 });
    ExpectSimilar(check, "two volumes of half the density, " + kind,
      draw({ MakeSmoke(0, 32, 0.5), MakeSmoke(0, 32, 0.5) }), complete, { 0.0008, 3e-5 });
  }
}

/// Two dense halves in optically thick slabs. The half that is closer to the light must be drawn
/// first.
void TestThickHalves(Check& check)
{
  constexpr double extinction = 8.0;
  const Box left{ { -0.5, 0.0, -0.3, 0.3, -0.3, 0.3 } };
  const Box right{ { 0.0, 0.5, -0.3, 0.3, -0.3, 0.3 } };
  const Box complete{ { -0.5, 0.5, -0.3, 0.3, -0.3, 0.3 } };
  for (const double side : { -1.0, 1.0 })
  {
    Double3 view{ { 0.7 * side, 0.3, -0.7 } };
    vtkMath::Normalize(view.data());
    const auto draw = [&](const std::vector<SceneVolume>& volumes)
    {
      return Draw(MakeScene(volumes, { { side, 0.1, -0.4 } }, view),
        [](MixedSceneWindow& pile)
        {
          for (vtkShadowedSliceMapper* mapper : pile.Mappers)
          {
            mapper->SetSliceSpacing(0.12);
            mapper->SetLightBufferSize(128);
          }
        });
    };
    ExpectSimilar(check, "thick halves, light from " + std::to_string(-side),
      draw({ MakeMedium(left, extinction, WHITE, 12), MakeMedium(right, extinction, WHITE, 12) }),
      draw({ MakeMedium(complete, extinction, WHITE, 24) }), { 0.065, 0.00045 });
  }
}

/// For two volumes of different colors at the same position, the error decreases with the slice
/// spacing.
void TestRefinement(Check& check)
{
  const Box box{ { -0.5, 0.5, -0.4, 0.4, -0.3, 0.3 } };
  const MixedScene scene = MakeScene({ MakeMedium(box, 4.0, RED), MakeMedium(box, 6.0, BLUE) },
    { { 0.3, 0.2, -1.0 } }, { { 0.0, 0.6, -0.8 } });
  const RgbaImage expected = MakeMixedImage(scene);
  double last = 1.0;
  for (const double spacing : { 0.16, 0.08, 0.04, 0.02 })
  {
    const RgbaImage found = Draw(scene,
      [spacing](MixedSceneWindow& pile)
      {
        for (vtkShadowedSliceMapper* mapper : pile.Mappers)
        {
          mapper->SetSliceSpacing(spacing);
        }
      });
    const ImageError error = CompareImages(found, expected);
    std::cout << "spacing " << spacing << ": " << error << std::endl;
    check.That(error.Mean < last, "spacing " + std::to_string(spacing) + ": the error decreases");
    last = error.Mean;
  }
  check.Near(last, 0.0, 0.001, "two volumes at the same position", 1.0);
}

/// Tests point lights outside, between and inside the volumes.
void TestPointLights(Check& check)
{
  const SceneVolume left = MakeMedium({ { -0.6, -0.1, -0.3, 0.3, -0.3, 0.3 } }, 3.0, RED);
  const SceneVolume right = MakeMedium({ { 0.1, 0.6, -0.3, 0.3, -0.3, 0.3 } }, 3.0, BLUE);
  for (const auto& [name, position, bound] :
    { std::tuple<std::string, Double3, ImageBound>{
        "light outside", { { -1.5, 0.4, 0.8 } }, { 0.03, 0.0003 } },
      { "light between", { { 0.0, 0.05, 0.1 } }, { 0.03, 0.0004 } },
      { "light inside", { { -0.3, 0.05, 0.1 } }, { 0.03, 0.0004 } } })
  {
    MixedScene scene = MakeScene({ left, right }, { { 0.0, 0.0, -1.0 } }, { { 0.0, 0.6, -0.8 } });
    scene.Lights[0].Light = MakePointLight(position, { { 0.0, 0.0, 0.0 } });
    TestScene(check, name, scene, bound);
  }
}

/// A point light inside smoke above a floor. The slice plane through the light intersects the
/// floor. Light rays that are almost parallel to the slices leave the smoke before they reach the
/// next slab.
void TestPointLightAboveFloor(Check& check)
{
  const Double3 black{ { 0.0, 0.0, 0.0 } };
  for (const double height : { 0.1, 0.3 })
  {
    for (const bool isHomogeneous : { false, true })
    {
      const SceneVolume smoke = isHomogeneous
        ? MakeMedium({ { -0.6, 0.6, -0.5, 0.5, -0.3, 0.4 } }, 3.0, black)
        : MakeSmoke(0, 32);
      MixedScene scene = MakeScene({ smoke }, { { 0.0, 0.0, -1.0 } }, { { 0.0, 0.6, -0.8 } });
      scene.Size = { { 96, 96 } };
      scene.Lights[0].Light =
        MakePointLight({ { 0.1, 0.05, -0.2 + height } }, { { 0.0, 0.0, -1.0 } });
      scene.Surfaces.push_back(
        { MakeRectangle({ { -0.5, -0.5, -0.2 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }),
          {} });
      const std::string name = std::string(isHomogeneous ? "homogeneous" : "inhomogeneous") +
        " smoke, light " + std::to_string(height) + " above a floor";
      const ImageBound bound = isHomogeneous ? ImageBound{ 1e-4, 1e-5 } : ImageBound{ 0.025, 3e-4 };
      ExpectSimilar(check, name, Draw(scene), MakeMixedImage(scene), bound);
    }
  }
}

/// Tests pairs of volumes in which one volume has a feature that the other lacks.
void TestFeatures(Check& check)
{
  const Box lower{ { -0.5, 0.1, -0.3, 0.3, -0.5, -0.1 } };
  const Box upper{ { -0.2, 0.5, -0.25, 0.35, -0.2, 0.5 } };
  const Double3 light{ { 0.1, 0.3, -1.0 } };
  const Double3 view{ { 0.0, 0.6, -0.8 } };
  SceneVolume colored = MakeMedium(upper, 3.0, BLUE);
  colored.TransmissionColor = vtkSmartPointer<vtkColorTransferFunction>::New();
  colored.TransmissionColor->AddRGBPoint(0.0, 0.1, 0.5, 0.9);
  TestScene(check, "colored transmission",
    MakeScene({ MakeMedium(lower, 2.0, RED), colored }, light, view), { 0.04, 0.0003 });

  SceneVolume clipped = MakeMedium(upper, 3.0, BLUE);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(-1.0, 0.3, 0.2);
  plane->SetOrigin(0.2, 0.0, 0.0);
  clipped.ClippingPlanes = { vtkSmartPointer<vtkPlane>(plane) };
  SceneVolume cropped = MakeMedium(lower, 2.0, RED);
  cropped.CroppingFlags = VTK_CROP_SUBVOLUME;
  cropped.CroppingPlanes = { { -0.4, 0.0, -0.2, 0.1, -0.4, -0.2 } };
  TestScene(
    check, "clipped and cropped", MakeScene({ clipped, cropped }, light, view), { 0.04, 0.0003 });

  SceneVolume rotated = MakeMedium(upper, 3.0, BLUE);
  rotated.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(35.0, 1.0, 0.4, 0.2);
  transform->Scale(0.8, 1.2, -0.7);
  rotated.Matrix->DeepCopy(transform->GetMatrix());
  rotated.Property->SetShade(1);
  TestScene(check, "rotated, mirrored and shaded",
    MakeScene({ MakeMedium(lower, 2.0, RED), rotated }, light, view), { 0.04, 0.0003 });

  MixedScene several =
    MakeScene({ MakeMedium(lower, 2.0, RED), MakeMedium(upper, 3.0, BLUE),
                MakeMedium({ { -0.7, 0.7, -0.7, 0.7, -0.7, 0.7 } }, 0.5, WHITE) },
      light, view);
  several.Size = { { 28, 28 } };
  several.Lights.push_back({ MakeSun({ { -1.0, 0.2, 0.4 } }), {} });
  several.Lights[0].Light->SetIntensity(0.6);
  several.Lights[1].Light->SetIntensity(0.4);
  TestScene(check, "three volumes, two lights", several, { 0.04, 0.0003 });
}

vtkSmartPointer<vtkLight> MakeRoundLight(const Double3& position, double diameter)
{
  vtkNew<vtkAreaLight> areaLight;
  areaLight->SetLightTypeToSceneLight();
  areaLight->SetPositional(true);
  areaLight->SetPosition(position.data());
  areaLight->SetFocalPoint(0.0, 0.0, 0.0);
  areaLight->SetConeAngle(180.0);
  areaLight->SetShadowAttenuation(1.0F);
  areaLight->SetShape(vtkAreaLight::ROUND);
  areaLight->SetSize(diameter, diameter);
  return vtkSmartPointer<vtkLight>(areaLight);
}

/// Two halves of a volume transmit the same fraction of a round light as the complete volume, also
/// to surfaces inside and behind them.
void TestSoftHalves(Check& check)
{
  const auto draw = [](const std::vector<SceneVolume>& volumes)
  {
    MixedScene scene = MakeScene(volumes, { { 0.0, 0.0, -1.0 } }, { { 0.0, 0.6, -0.8 } });
    scene.Lights[0].Light = MakeRoundLight({ { 0.4, 0.3, 2.0 } }, 0.6);
    for (const double height : { -0.9, 0.0 })
    {
      const double size = height < -0.5 ? 2.0 : 0.6;
      scene.Surfaces.push_back({ MakeRectangle({ { -0.5 * size, -0.5 * size, height } },
                                   { { size, 0.0, 0.0 } }, { { 0.0, size, 0.0 } }),
        {} });
    }
    return Draw(scene);
  };
  ExpectSimilar(check, "two halves, round light and surfaces",
    draw({ MakeSmoke(0, 16), MakeSmoke(16, 32) }), draw({ MakeSmoke(0, 32) }), { 0.0003, 2e-6 });
}

/// Checks the sample layers of a round light above two volumes.
void TestSoftShadows(Check& check)
{
  MixedScene scene = MakeScene({ MakeMedium({ { -0.5, 0.2, -0.3, 0.3, -0.5, -0.1 } }, 2.0, RED),
                                 MakeMedium({ { -0.2, 0.3, -0.25, 0.3, -0.2, 0.4 } }, 4.0, BLUE) },
    { { 0.0, 0.0, -1.0 } }, { { 0.0, 0.6, -0.8 } });
  const Double3 position{ { 0.4, 0.3, 2.0 } };
  constexpr double diameter = 0.8;
  Double3 axis = position;
  vtkMath::Normalize(axis.data());
  Double3 side;
  Double3 up;
  vtkMath::Perpendiculars(axis.data(), side.data(), up.data(), 0.0);
  vtkMath::MultiplyScalar(side.data(), diameter);
  vtkMath::MultiplyScalar(up.data(), diameter);
  scene.Size = { { 20, 20 } };
  scene.Lights = { { MakeRoundLight(position, diameter),
    MakeEllipseLightPoints(position, side, up, 40) } };
  MixedSceneWindow pile(scene);
  const RgbaImage image = pile.Draw();
  vtkInterlumeReport* report = pile.Mappers[1]->GetReport();
  check.Equal(report->GetCount("LightLayers"), 8, "soft shadows: layers for both volumes");
  check.Equal(report->GetCount("LightBuffers"), 1, "soft shadows: one buffer");
  check.Equal(report->GetCount("AreaLightsWithHardShadows"), 0, "soft shadows: no hard shadows");
  const RgbaImage expected = MakeMixedImage(scene);
  ExpectSimilar(check, "soft shadows", image, expected, { 0.02, 0.0002 });
  scene.Lights[0].Points.clear();
  const ImageError hard = CompareImages(MakeMixedImage(scene), expected);
  std::cout << "hard shadows instead: " << hard << std::endl;
  check.That(hard.Mean > 0.0005, "soft shadows: penumbras are visible");
}

/// Tests opaque boxes, whose faces are inside slabs, and the shadows that they cast on each other.
void TestSharp(Check& check)
{
  const SceneVolume lower = MakeMedium({ { -0.5, 0.3, -0.3, 0.3, -0.5, -0.2 } }, 80.0, RED);
  const SceneVolume upper = MakeMedium({ { -0.2, 0.5, -0.15, 0.25, 0.1, 0.4 } }, 80.0, BLUE);
  const SceneVolume smoke = MakeMedium({ { -0.6, 0.6, -0.4, 0.4, -0.3, 0.0 } }, 1.0, WHITE);
  const Double3 view{ { 0.1, 0.6, -0.8 } };
  TestScene(check, "opaque boxes", MakeScene({ lower, upper }, { { 0.2, 0.3, -1.0 } }, view),
    { 0.4, 0.0008 });
  TestScene(check, "opaque boxes in smoke",
    MakeScene({ lower, upper, smoke }, { { 0.2, 0.3, -1.0 } }, view), { 0.2, 0.0005 });
}

/// Tests surfaces in front of, between, inside and behind two volumes.
void TestSurfaces(Check& check)
{
  const SceneVolume lower = MakeMedium({ { -0.5, 0.1, -0.3, 0.3, -0.5, -0.1 } }, 2.0, RED);
  const SceneVolume upper = MakeMedium({ { -0.2, 0.5, -0.25, 0.35, -0.2, 0.4 } }, 3.0, BLUE);
  MixedScene scene = MakeScene({ lower, upper }, { { 0.3, 0.2, -1.0 } }, { { 0.0, 0.6, -0.8 } });
  scene.Surfaces.push_back(
    { MakeRectangle({ { -1.0, -1.0, -0.55 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }), {} });
  scene.Surfaces.push_back({ MakeBox({ { -0.1, 0.2, -0.5, 0.1, -0.4, 0.1 } }), {} });
  TestScene(check, "surfaces", scene, { 0.15, 0.0005 });
}

/// If the settings of volumes in shared slices differ, the pass uses the finest slice spacing, the
/// largest light buffer and the smallest image sample distance.
void TestSettings(Check& check)
{
  const MixedScene scene =
    MakeScene({ MakeMedium({ { -0.5, 0.1, -0.3, 0.3, -0.5, -0.1 } }, 2.0, RED),
                MakeMedium({ { -0.2, 0.5, -0.2, 0.3, 0.1, 0.4 } }, 3.0, BLUE) },
      { { 0.3, 0.2, -1.0 } }, { { 0.0, 0.6, -0.8 } });
  MixedSceneWindow pile(scene);
  vtkShadowedSliceMapper* first = pile.Mappers[0];
  vtkShadowedSliceMapper* second = pile.Mappers[1];
  const auto draw = [&]() -> vtkInterlumeReport*
  {
    pile.Draw();
    check.Equal(pile.GetReport()->GetCount("VolumesInSharedSlices"), 2, "settings: shared slices");
    return second->GetReport();
  };
  first->SetSliceSpacing(0.1);
  second->SetSliceSpacing(0.03);
  first->SetLightBufferSize(96);
  second->SetLightBufferSize(160);
  check.That(draw()->GetNumber("SliceSpacing") <= 0.03 &&
      second->GetReport()->GetNumber("SliceSpacing") > 0.025,
    "settings: the finest spacing");
  check.Equal(
    second->GetReport()->GetCount("LightBufferSize"), 160, "settings: the largest buffer");
  check.Equal(second->GetReport()->GetCount("LightChannels"), 1, "settings: one channel");
  first->SetLightBufferSize(0);
  second->SetLightBufferSize(304);
  check.Equal(draw()->GetCount("LightBufferSize"), 304, "settings: at least the explicit size");
  second->SetLightBufferSize(0);
  second->SetSliceSpacing(0.0);
  check.That(draw()->GetNumber("SliceSpacing") < 0.02, "settings: the automatic spacing is finer");
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.2, 0.5, 0.8);
  first->SetTransmissionColor(color);
  check.Equal(draw()->GetCount("LightChannels"), 3, "settings: three channels");
  check.That(second->GetReport()->GetText("Features").find("transmission") != std::string::npos,
    "settings: the other volume also has colored light");
  first->SetImageSampleDistance(4.0);
  second->SetImageSampleDistance(2.0);
  check.Near(draw()->GetNumber("ImageSampleDistance"), 2.0, 1e-12,
    "settings: the smallest image sample distance", 1.0);

  // The memory limit suffices for separate volumes with small buffers, but not for shared slices.
  first->SetLightBufferSize(32);
  second->SetLightBufferSize(32);
  second->SetMaximumTextureMemory(
    first->GetReport()->GetNumber("TextureBytes") + second->GetReport()->GetNumber("TextureBytes"));
  pile.Draw();
  check.Equal(pile.GetReport()->GetCount("VolumesInSharedSlices"), 0, "memory: separate");
  check.That(pile.GetReport()->GetText("SeparateVolumesReason").find("MaximumTextureMemory") !=
      std::string::npos,
    "memory: the report contains the reason");
  check.Equal(pile.GetReport()->GetCount("Volumes"), 2, "memory: both are drawn");
}

/// Tests volumes that the pass draws separately, and a single volume.
void TestSeparate(Check& check)
{
  const SceneVolume large = MakeMedium({ { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 } }, 1.0, RED);
  const SceneVolume small =
    MakeMedium({ { 0.6, 0.601, -0.0005, 0.0005, 0.0, 0.001 } }, 100.0, BLUE);
  const Double3 light{ { 0.3, 0.2, -1.0 } };
  const Double3 view{ { 0.0, 0.6, -0.8 } };
  MixedSceneWindow pile(MakeScene({ large, small }, light, view));
  pile.Draw();
  check.Equal(pile.GetReport()->GetCount("VolumesInSharedSlices"), 0, "1 to 1000: separate");
  check.That(pile.GetReport()->GetText("SeparateVolumesReason").find("slices") != std::string::npos,
    "1 to 1000: the report contains the reason");

  // A single volume above a floor is not drawn in shared slices. Its image does not depend on other
  // volumes that were drawn earlier.
  MixedScene single = MakeScene({ large }, light, view);
  single.Surfaces.push_back(
    { MakeRectangle({ { -1.0, -1.0, -0.55 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }), {} });
  MixedScene both = single;
  both.Volumes.push_back(MakeMedium({ { 0.2, 0.6, -0.2, 0.2, 0.0, 0.6 } }, 3.0, BLUE));
  MixedSceneWindow one(single);
  const RgbaImage single1 = one.Draw();
  const auto expected = CopyReport(one.Mappers[0]->GetReport());
  check.Equal(
    one.GetReport()->GetCount("VolumesInSharedSlices"), 0, "one volume: no shared slices");
  MixedSceneWindow two(both);
  const RgbaImage shared = two.Draw();
  check.Equal(two.GetReport()->GetCount("VolumesInSharedSlices"), 2, "two volumes: shared slices");
  check.That(CompareImages(single1, shared).Max > 0.01, "two volumes: a different image");
  two.Volumes[1]->VisibilityOff();
  check.Near(
    CompareImages(two.Draw(), single1).Max, 0.0, 0.0, "one hidden volume: identical image");
  vtkInterlumeReport* report = two.Mappers[0]->GetReport();
  check.Equal(
    two.GetReport()->GetCount("VolumesInSharedSlices"), 0, "one hidden volume: no shared slices");
  check.Equal(report->GetCount("ImagePasses"), expected->GetCount("ImagePasses"),
    "one hidden volume: image passes");
  check.Equal(report->GetCount("LightPasses"), expected->GetCount("LightPasses"),
    "one hidden volume: light passes");
  check.Equal(report->GetCount("LightBufferBytes"), expected->GetCount("LightBufferBytes"),
    "one hidden volume: light buffers");
  check.Equal(report->GetCount("ImageBufferBytes"), expected->GetCount("ImageBufferBytes"),
    "one hidden volume: image buffers");
  check.That(report->GetText("Features") == expected->GetText("Features"),
    "one hidden volume: shader features");
  two.Volumes[1]->VisibilityOn();
  check.Near(CompareImages(two.Draw(), shared).Max, 0.0, 0.0, "visible again: identical image");
  two.Mappers[1]->ShadowsOff();
  two.Draw();
  check.Equal(two.GetReport()->GetCount("VolumesInSharedSlices"), 0, "shadows off: separate");
  vtkNew<vtkImageData> buffer;
  check.That(two.Mappers[0]->ReadLightBuffer(two.Stage.GetRenderer(), both.Lights[0].Light, buffer),
    "the light buffer of one volume");
  two.Mappers[1]->ShadowsOn();
  two.Draw();
  check.That(two.Mappers[1]->ReadLightBuffer(two.Stage.GetRenderer(), both.Lights[0].Light, buffer),
    "the light buffer of two volumes");
}
}

int TestShadowedVolumes(int, char*[])
{
  Check check;
  TestBoxes(check);
  TestHalves(check);
  TestThickHalves(check);
  TestRefinement(check);
  TestPointLights(check);
  TestPointLightAboveFloor(check);
  TestFeatures(check);
  TestSoftShadows(check);
  TestSoftHalves(check);
  TestSharp(check);
  TestSettings(check);
  TestSeparate(check);
  TestSurfaces(check);
  return check.Result();
}
