// SPDX-License-Identifier: BSD-3-Clause
// Several volumes in one set of slices by vtkShadowedScenePass, which shadow each other and are
// mixed where they overlap: against integration in double precision.
#include "Light/ShadowComparison.h"
#include "Support/Pictures/LightPoints.h"
#include "Support/Pictures/MixedScene.h"
#include "Support/Pictures/ReferenceMixedPicture.h"
#include "Support/Pictures/ShadowCases.h"
#include "Support/Checks/ReferenceReport.h"
#include "SceneStage.h"
#include "VolumePile.h"

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

/// Homogeneous matter of an extinction per unit and a colour, in so many voxels along x.
SceneVolume MakeMatter(const Box& box, double extinction, const Double3& color, int cells = 24)
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

/// Compares the picture with the reference, and with that of the volumes in the opposite order.
void TestScene(
  Check& check, const std::string& name, const MixedScene& scene, const PictureBound& bound)
{
  VolumePile pile(scene);
  const RgbaPicture picture = pile.Draw();
  const auto volumes = static_cast<int>(scene.Volumes.size());
  check.Near(pile.GetReport()->GetNumber("VolumesInSharedSlices"), volumes, 0.0,
    name + ": volumes together");
  check.That(
    pile.GetReport()->GetText("SeparateVolumesReason").empty(), name + ": nothing is apart");
  check.Near(pile.Mappers[0]->GetReport()->GetNumber("LightBuffers"),
    static_cast<int>(scene.Lights.size()), 0.0, name + ": one buffer for each light");
  ExpectAlike(check, name, picture, MakeMixedPicture(scene), bound);
  VolumePile reversed(scene, true);
  check.Near(ComparePictures(picture, reversed.Draw()).Max, 0.0, 1e-6,
    name + ": the order of adding volumes", 1.0);
}

/// Two boxes for light and views of all kinds: apart, half in each other, one in the other.
void TestBoxes(Check& check)
{
  const Box lower{ { -0.5, 0.1, -0.3, 0.3, -0.5, -0.1 } };
  const Box upper{ { -0.2, 0.5, -0.25, 0.35, 0.05, 0.5 } };
  const Box half{ { -0.1, 0.5, -0.3, 0.3, -0.3, 0.1 } };
  const Box inner{ { -0.3, -0.1, -0.1, 0.1, -0.4, -0.2 } };
  const std::vector<std::tuple<std::string, Double3, Double3>> rays = {
    { "along", { { 0.0, 0.0, -1.0 } }, { { 0.0, 1.0, 0.0 } } },
    { "with the eye", { { 0.1, 0.5, -1.0 } }, { { 0.0, 0.4, -1.0 } } },
    { "against the eye", { { 0.2, -0.4, 1.0 } }, { { 0.1, 0.6, -1.0 } } },
    { "across", { { 1.0, 0.2, -0.7 } }, { { -0.3, 1.0, -0.2 } } },
  };
  const std::vector<std::pair<std::string, Box>> others = { { "apart", upper },
    { "overlapping", half }, { "inside", inner } };
  for (const auto& [place, box] : others)
  {
    for (const auto& [kind, light, view] : rays)
    {
      Double3 direction = view;
      vtkMath::Normalize(direction.data());
      const MixedScene scene =
        MakeScene({ MakeMatter(lower, 2.0, RED), MakeMatter(box, 3.0, BLUE) }, light, direction);
      // Single pixels look along a face of a box, or of its shadow.
      const double largest = kind == "along" ? 0.2 : 0.04;
      TestScene(check, place + ", " + kind, scene, { largest, 0.0005 });
    }
  }
}

/// The picture of a scene by the pass, with settings of its own.
RgbaPicture Draw(const MixedScene& scene, const std::function<void(VolumePile&)>& change = {})
{
  VolumePile pile(scene);
  if (change)
  {
    change(pile);
  }
  return pile.Draw();
}

/// A share of smoke whose density changes from place to place, in the cells from one to another
/// along x, of a cube of 32.
SceneVolume MakeSmoke(int first, int last, double share = 1.0)
{
  constexpr double extinction = 3.0;
  SceneVolume volume = MakeMatter({ { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 } }, extinction, WHITE);
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
  volume.Property->SetScalarOpacityUnitDistance(0.1 / share);
  return volume;
}

/// Two halves are the whole, without a seam, wherever their common face turns.
void TestHalves(Check& check)
{
  const std::vector<std::tuple<std::string, Double3, Double3>> rays = {
    { "face along the light", { { 0.0, 0.3, -1.0 } }, { { 0.0, 1.0, -0.4 } } },
    { "light and eye from different sides", { { 1.0, 0.1, -0.3 } }, { { -0.8, 0.5, -0.4 } } },
    { "light towards the eye", { { -1.0, 0.2, 0.3 } }, { { 0.9, 0.1, -0.2 } } },
  };
  for (const auto& [kind, light, view] : rays)
  {
    Double3 direction = view;
    vtkMath::Normalize(direction.data());
    const auto draw = [&, light = light](const std::vector<SceneVolume>& volumes)
    { return Draw(MakeScene(volumes, light, direction)); };
    const RgbaPicture whole = draw({ MakeSmoke(0, 32) });
    ExpectAlike(check, "two halves, " + kind, draw({ MakeSmoke(0, 16), MakeSmoke(16, 32) }), whole,
      { 0.0005, 5e-6 });
    ExpectAlike(check, "two of half the density, " + kind,
      draw({ MakeSmoke(0, 32, 0.5), MakeSmoke(0, 32, 0.5) }), whole, { 0.0008, 3e-5 });
  }
}

/// Halves of solid matter in thick slabs: the half that the light meets first is drawn first.
void TestThickHalves(Check& check)
{
  constexpr double extinction = 8.0;
  const Box left{ { -0.5, 0.0, -0.3, 0.3, -0.3, 0.3 } };
  const Box right{ { 0.0, 0.5, -0.3, 0.3, -0.3, 0.3 } };
  const Box whole{ { -0.5, 0.5, -0.3, 0.3, -0.3, 0.3 } };
  for (const double side : { -1.0, 1.0 })
  {
    Double3 view{ { 0.7 * side, 0.3, -0.7 } };
    vtkMath::Normalize(view.data());
    const auto draw = [&](const std::vector<SceneVolume>& volumes)
    {
      return Draw(MakeScene(volumes, { { side, 0.1, -0.4 } }, view),
        [](VolumePile& pile)
        {
          for (vtkShadowedSliceMapper* mapper : pile.Mappers)
          {
            mapper->SetSliceSpacing(0.12);
            mapper->SetLightBufferSize(128);
          }
        });
    };
    ExpectAlike(check, "thick halves, light from " + std::to_string(-side),
      draw({ MakeMatter(left, extinction, WHITE, 12), MakeMatter(right, extinction, WHITE, 12) }),
      draw({ MakeMatter(whole, extinction, WHITE, 24) }), { 0.065, 0.00045 });
  }
}

/// The error of volumes of two colours at the same place, which falls with the spacing.
void TestRefinement(Check& check)
{
  const Box box{ { -0.5, 0.5, -0.4, 0.4, -0.3, 0.3 } };
  const MixedScene scene = MakeScene({ MakeMatter(box, 4.0, RED), MakeMatter(box, 6.0, BLUE) },
    { { 0.3, 0.2, -1.0 } }, { { 0.0, 0.6, -0.8 } });
  const RgbaPicture expected = MakeMixedPicture(scene);
  double last = 1.0;
  for (const double spacing : { 0.16, 0.08, 0.04, 0.02 })
  {
    const RgbaPicture found = Draw(scene,
      [spacing](VolumePile& pile)
      {
        for (vtkShadowedSliceMapper* mapper : pile.Mappers)
        {
          mapper->SetSliceSpacing(spacing);
        }
      });
    const PictureError error = ComparePictures(found, expected);
    std::cout << "spacing " << spacing << ": " << error << std::endl;
    check.That(error.Mean < last, "spacing " + std::to_string(spacing) + ": the error falls");
    last = error.Mean;
  }
  check.Near(last, 0.0, 0.001, "two volumes at the same place", 1.0);
}

/// Lamps beside, between and in the volumes.
void TestLamps(Check& check)
{
  const SceneVolume left = MakeMatter({ { -0.6, -0.1, -0.3, 0.3, -0.3, 0.3 } }, 3.0, RED);
  const SceneVolume right = MakeMatter({ { 0.1, 0.6, -0.3, 0.3, -0.3, 0.3 } }, 3.0, BLUE);
  for (const auto& [name, place, bound] :
    { std::tuple<std::string, Double3, PictureBound>{
        "lamp aside", { { -1.5, 0.4, 0.8 } }, { 0.03, 0.0003 } },
      { "lamp between", { { 0.0, 0.05, 0.1 } }, { 0.03, 0.0004 } },
      { "lamp within", { { -0.3, 0.05, 0.1 } }, { 0.03, 0.0004 } } })
  {
    MixedScene scene = MakeScene({ left, right }, { { 0.0, 0.0, -1.0 } }, { { 0.0, 0.6, -0.8 } });
    scene.Lights[0].Light = MakeLamp(place, { { 0.0, 0.0, 0.0 } });
    TestScene(check, name, scene, bound);
  }
}

/// A lamp inside smoke above a floor that the plane through the lamp along the slices intersects.
/// Rays along the slices leave the smoke before they reach a slab.
void TestLampAboveFloor(Check& check)
{
  const Double3 black{ { 0.0, 0.0, 0.0 } };
  for (const double height : { 0.1, 0.3 })
  {
    for (const bool isFlat : { false, true })
    {
      const SceneVolume smoke =
        isFlat ? MakeMatter({ { -0.6, 0.6, -0.5, 0.5, -0.3, 0.4 } }, 3.0, black) : MakeSmoke(0, 32);
      MixedScene scene = MakeScene({ smoke }, { { 0.0, 0.0, -1.0 } }, { { 0.0, 0.6, -0.8 } });
      scene.Size = { { 96, 96 } };
      scene.Lights[0].Light = MakeLamp({ { 0.1, 0.05, -0.2 + height } }, { { 0.0, 0.0, -1.0 } });
      scene.Surfaces.push_back(
        { MakeRectangle({ { -0.5, -0.5, -0.2 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }),
          {} });
      const std::string name = std::string(isFlat ? "even" : "uneven") + " smoke, lamp " +
        std::to_string(height) + " above a floor";
      const PictureBound bound = isFlat ? PictureBound{ 1e-4, 1e-5 } : PictureBound{ 0.025, 3e-4 };
      ExpectAlike(check, name, Draw(scene), MakeMixedPicture(scene), bound);
    }
  }
}

/// Features of one volume beside another without them.
void TestFeatures(Check& check)
{
  const Box lower{ { -0.5, 0.1, -0.3, 0.3, -0.5, -0.1 } };
  const Box upper{ { -0.2, 0.5, -0.25, 0.35, -0.2, 0.5 } };
  const Double3 light{ { 0.1, 0.3, -1.0 } };
  const Double3 view{ { 0.0, 0.6, -0.8 } };
  SceneVolume colored = MakeMatter(upper, 3.0, BLUE);
  colored.TransmissionColor = vtkSmartPointer<vtkColorTransferFunction>::New();
  colored.TransmissionColor->AddRGBPoint(0.0, 0.1, 0.5, 0.9);
  TestScene(check, "colour of light that passes",
    MakeScene({ MakeMatter(lower, 2.0, RED), colored }, light, view), { 0.04, 0.0003 });

  SceneVolume clipped = MakeMatter(upper, 3.0, BLUE);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(-1.0, 0.3, 0.2);
  plane->SetOrigin(0.2, 0.0, 0.0);
  clipped.ClippingPlanes = { vtkSmartPointer<vtkPlane>(plane) };
  SceneVolume cropped = MakeMatter(lower, 2.0, RED);
  cropped.CroppingFlags = VTK_CROP_SUBVOLUME;
  cropped.CroppingPlanes = { { -0.4, 0.0, -0.2, 0.1, -0.4, -0.2 } };
  TestScene(
    check, "clipped and cropped", MakeScene({ clipped, cropped }, light, view), { 0.04, 0.0003 });

  SceneVolume turned = MakeMatter(upper, 3.0, BLUE);
  turned.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(35.0, 1.0, 0.4, 0.2);
  transform->Scale(0.8, 1.2, -0.7);
  turned.Matrix->DeepCopy(transform->GetMatrix());
  turned.Property->SetShade(1);
  TestScene(check, "turned, mirrored and shaded",
    MakeScene({ MakeMatter(lower, 2.0, RED), turned }, light, view), { 0.04, 0.0003 });

  MixedScene several =
    MakeScene({ MakeMatter(lower, 2.0, RED), MakeMatter(upper, 3.0, BLUE),
                MakeMatter({ { -0.7, 0.7, -0.7, 0.7, -0.7, 0.7 } }, 0.5, WHITE) },
      light, view);
  several.Size = { { 28, 28 } };
  several.Lights.push_back({ MakeSun({ { -1.0, 0.2, 0.4 } }), {} });
  several.Lights[0].Light->SetIntensity(0.6);
  several.Lights[1].Light->SetIntensity(0.4);
  TestScene(check, "three volumes, two lights", several, { 0.04, 0.0003 });
}

vtkSmartPointer<vtkLight> MakeRoundLamp(const Double3& place, double diameter)
{
  vtkNew<vtkAreaLight> lamp;
  lamp->SetLightTypeToSceneLight();
  lamp->SetPositional(true);
  lamp->SetPosition(place.data());
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetConeAngle(180.0);
  lamp->SetShadowAttenuation(1.0F);
  lamp->SetShape(vtkAreaLight::ROUND);
  lamp->SetSize(diameter, diameter);
  return vtkSmartPointer<vtkLight>(lamp);
}

/// Two halves leave of a round lamp what the whole leaves, on surfaces in and behind them too.
void TestSoftHalves(Check& check)
{
  const auto draw = [](const std::vector<SceneVolume>& volumes)
  {
    MixedScene scene = MakeScene(volumes, { { 0.0, 0.0, -1.0 } }, { { 0.0, 0.6, -0.8 } });
    scene.Lights[0].Light = MakeRoundLamp({ { 0.4, 0.3, 2.0 } }, 0.6);
    for (const double height : { -0.9, 0.0 })
    {
      const double size = height < -0.5 ? 2.0 : 0.6;
      scene.Surfaces.push_back({ MakeRectangle({ { -0.5 * size, -0.5 * size, height } },
                                   { { size, 0.0, 0.0 } }, { { 0.0, size, 0.0 } }),
        {} });
    }
    return Draw(scene);
  };
  ExpectAlike(check, "two halves, round lamp and surfaces",
    draw({ MakeSmoke(0, 16), MakeSmoke(16, 32) }), draw({ MakeSmoke(0, 32) }), { 0.0003, 2e-6 });
}

/// A round lamp over two volumes, in layers of its samples.
void TestSoftShadows(Check& check)
{
  MixedScene scene = MakeScene({ MakeMatter({ { -0.5, 0.2, -0.3, 0.3, -0.5, -0.1 } }, 2.0, RED),
                                 MakeMatter({ { -0.2, 0.3, -0.25, 0.3, -0.2, 0.4 } }, 4.0, BLUE) },
    { { 0.0, 0.0, -1.0 } }, { { 0.0, 0.6, -0.8 } });
  const Double3 place{ { 0.4, 0.3, 2.0 } };
  constexpr double diameter = 0.8;
  Double3 axis = place;
  vtkMath::Normalize(axis.data());
  Double3 side;
  Double3 up;
  vtkMath::Perpendiculars(axis.data(), side.data(), up.data(), 0.0);
  vtkMath::MultiplyScalar(side.data(), diameter);
  vtkMath::MultiplyScalar(up.data(), diameter);
  scene.Size = { { 20, 20 } };
  scene.Lights = { { MakeRoundLamp(place, diameter), MakeRoundPoints(place, side, up, 40) } };
  VolumePile pile(scene);
  const RgbaPicture picture = pile.Draw();
  vtkInterlumeReport* report = pile.Mappers[1]->GetReport();
  check.Near(report->GetNumber("LightLayers"), 8, 0.0, "soft: layers for both volumes");
  check.Near(report->GetNumber("LightBuffers"), 1, 0.0, "soft: one buffer");
  check.Near(report->GetNumber("AreaLightsWithHardShadows"), 0, 0.0, "soft: no hard light");
  const RgbaPicture expected = MakeMixedPicture(scene);
  ExpectAlike(check, "soft shadows", picture, expected, { 0.02, 0.0002 });
  scene.Lights[0].Points.clear();
  const PictureError hard = ComparePictures(MakeMixedPicture(scene), expected);
  std::cout << "hard shadows instead: " << hard << std::endl;
  check.That(hard.Mean > 0.0005, "soft: penumbras are seen");
}

/// Opaque matter, whose surfaces are found within slabs, and shadows across.
void TestSharp(Check& check)
{
  const SceneVolume lower = MakeMatter({ { -0.5, 0.3, -0.3, 0.3, -0.5, -0.2 } }, 80.0, RED);
  const SceneVolume upper = MakeMatter({ { -0.2, 0.5, -0.15, 0.25, 0.1, 0.4 } }, 80.0, BLUE);
  const SceneVolume thin = MakeMatter({ { -0.6, 0.6, -0.4, 0.4, -0.3, 0.0 } }, 1.0, WHITE);
  const Double3 view{ { 0.1, 0.6, -0.8 } };
  TestScene(check, "opaque boxes", MakeScene({ lower, upper }, { { 0.2, 0.3, -1.0 } }, view),
    { 0.4, 0.0008 });
  TestScene(check, "opaque boxes in smoke",
    MakeScene({ lower, upper, thin }, { { 0.2, 0.3, -1.0 } }, view), { 0.2, 0.0005 });
}

/// Surfaces before, between, in and behind two volumes.
void TestSurfaces(Check& check)
{
  const SceneVolume lower = MakeMatter({ { -0.5, 0.1, -0.3, 0.3, -0.5, -0.1 } }, 2.0, RED);
  const SceneVolume upper = MakeMatter({ { -0.2, 0.5, -0.25, 0.35, -0.2, 0.4 } }, 3.0, BLUE);
  MixedScene scene = MakeScene({ lower, upper }, { { 0.3, 0.2, -1.0 } }, { { 0.0, 0.6, -0.8 } });
  scene.Surfaces.push_back(
    { MakeRectangle({ { -1.0, -1.0, -0.55 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }), {} });
  scene.Surfaces.push_back({ MakeBox({ { -0.1, 0.2, -0.5, 0.1, -0.4, 0.1 } }), {} });
  TestScene(check, "surfaces", scene, { 0.15, 0.0005 });
}

/// What is shared of different settings.
void TestSettings(Check& check)
{
  const MixedScene scene =
    MakeScene({ MakeMatter({ { -0.5, 0.1, -0.3, 0.3, -0.5, -0.1 } }, 2.0, RED),
                MakeMatter({ { -0.2, 0.5, -0.2, 0.3, 0.1, 0.4 } }, 3.0, BLUE) },
      { { 0.3, 0.2, -1.0 } }, { { 0.0, 0.6, -0.8 } });
  VolumePile pile(scene);
  vtkShadowedSliceMapper* first = pile.Mappers[0];
  vtkShadowedSliceMapper* second = pile.Mappers[1];
  const auto draw = [&]() -> vtkInterlumeReport*
  {
    pile.Draw();
    check.Near(pile.GetReport()->GetNumber("VolumesInSharedSlices"), 2, 0.0, "settings: together");
    return second->GetReport();
  };
  first->SetSliceSpacing(0.1);
  second->SetSliceSpacing(0.03);
  first->SetLightBufferSize(96);
  second->SetLightBufferSize(160);
  check.That(draw()->GetNumber("SliceSpacing") <= 0.03 &&
      second->GetReport()->GetNumber("SliceSpacing") > 0.025,
    "settings: the finest spacing");
  check.Near(
    second->GetReport()->GetNumber("LightBufferSize"), 160, 0.0, "settings: the largest buffer");
  check.Near(second->GetReport()->GetNumber("LightChannels"), 1, 0.0, "settings: one channel");
  first->SetLightBufferSize(0);
  second->SetLightBufferSize(304);
  check.Near(draw()->GetNumber("LightBufferSize"), 304, 0.0, "settings: no less than what is set");
  second->SetLightBufferSize(0);
  second->SetSliceSpacing(0.0);
  check.That(draw()->GetNumber("SliceSpacing") < 0.02, "settings: the automatic spacing is finer");
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.2, 0.5, 0.8);
  first->SetTransmissionColor(color);
  check.Near(draw()->GetNumber("LightChannels"), 3, 0.0, "settings: three channels");
  check.That(second->GetReport()->GetText("Features").find("transmission") != std::string::npos,
    "settings: the other one's light has colours too");
  first->SetImageSampleDistance(4.0);
  second->SetImageSampleDistance(2.0);
  check.Near(
    draw()->GetNumber("ImageSampleDistance"), 2.0, 1e-12, "settings: the finest picture", 1.0);

  // Enough for one of them with small buffers.
  first->SetLightBufferSize(32);
  second->SetLightBufferSize(32);
  second->SetMaximumTextureMemory(
    first->GetReport()->GetNumber("TextureBytes") + second->GetReport()->GetNumber("TextureBytes"));
  pile.Draw();
  check.Near(pile.GetReport()->GetNumber("VolumesInSharedSlices"), 0, 0.0, "memory: apart");
  check.That(pile.GetReport()->GetText("SeparateVolumesReason").find("MaximumTextureMemory") !=
      std::string::npos,
    "memory: the report says why");
  check.Near(pile.GetReport()->GetNumber("Volumes"), 2, 0.0, "memory: both are drawn");
}

/// What is drawn one by one, or by one volume alone.
void TestApart(Check& check)
{
  const SceneVolume large = MakeMatter({ { -0.5, 0.5, -0.5, 0.5, -0.5, 0.5 } }, 1.0, RED);
  const SceneVolume small =
    MakeMatter({ { 0.6, 0.601, -0.0005, 0.0005, 0.0, 0.001 } }, 100.0, BLUE);
  const Double3 light{ { 0.3, 0.2, -1.0 } };
  const Double3 view{ { 0.0, 0.6, -0.8 } };
  VolumePile pile(MakeScene({ large, small }, light, view));
  pile.Draw();
  check.Near(pile.GetReport()->GetNumber("VolumesInSharedSlices"), 0, 0.0, "1 to 1000: apart");
  check.That(pile.GetReport()->GetText("SeparateVolumesReason").find("slices") != std::string::npos,
    "1 to 1000: the report says why");

  // One volume with a floor: no group, and the same picture whatever was drawn together before.
  MixedScene single = MakeScene({ large }, light, view);
  single.Surfaces.push_back(
    { MakeRectangle({ { -1.0, -1.0, -0.55 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }), {} });
  MixedScene both = single;
  both.Volumes.push_back(MakeMatter({ { 0.2, 0.6, -0.2, 0.2, 0.0, 0.6 } }, 3.0, BLUE));
  VolumePile one(single);
  const RgbaPicture alone = one.Draw();
  const auto expected = CopyReport(one.Mappers[0]->GetReport());
  check.Near(
    one.GetReport()->GetNumber("VolumesInSharedSlices"), 0, 0.0, "one volume: nothing is together");
  VolumePile two(both);
  const RgbaPicture together = two.Draw();
  check.Near(two.GetReport()->GetNumber("VolumesInSharedSlices"), 2, 0.0, "two volumes: together");
  check.That(ComparePictures(alone, together).Max > 0.01, "two volumes: another picture");
  two.Volumes[1]->VisibilityOff();
  check.Near(ComparePictures(two.Draw(), alone).Max, 0.0, 0.0, "one is hidden: the same bytes");
  vtkInterlumeReport* report = two.Mappers[0]->GetReport();
  check.Near(two.GetReport()->GetNumber("VolumesInSharedSlices"), 0, 0.0,
    "one is hidden: nothing is together");
  check.Near(report->GetNumber("ImagePasses"), expected->GetNumber("ImagePasses"), 0.0,
    "one is hidden: passes of the eye");
  check.Near(report->GetNumber("LightPasses"), expected->GetNumber("LightPasses"), 0.0,
    "one is hidden: passes of the light");
  check.Near(report->GetNumber("LightBufferBytes"), expected->GetNumber("LightBufferBytes"), 0.0,
    "one is hidden: light buffers");
  check.Near(report->GetNumber("ImageBufferBytes"), expected->GetNumber("ImageBufferBytes"), 0.0,
    "one is hidden: pictures");
  check.That(report->GetText("Features") == expected->GetText("Features"),
    "one is hidden: parts of shaders");
  two.Volumes[1]->VisibilityOn();
  check.Near(
    ComparePictures(two.Draw(), together).Max, 0.0, 0.0, "shown again: the same bytes as before");
  two.Mappers[1]->ShadowsOff();
  two.Draw();
  check.Near(
    two.GetReport()->GetNumber("VolumesInSharedSlices"), 0, 0.0, "shadows off: drawn by itself");
  vtkNew<vtkImageData> buffer;
  check.That(two.Mappers[0]->ReadLightBuffer(two.Stage.GetRenderer(), both.Lights[0].Light, buffer),
    "a light's buffer of one volume");
  two.Mappers[1]->ShadowsOn();
  two.Draw();
  check.That(two.Mappers[1]->ReadLightBuffer(two.Stage.GetRenderer(), both.Lights[0].Light, buffer),
    "a light's buffer of two volumes");
}
}

int TestShadowedVolumes(int, char*[])
{
  Check check;
  TestBoxes(check);
  TestHalves(check);
  TestThickHalves(check);
  TestRefinement(check);
  TestLamps(check);
  TestLampAboveFloor(check);
  TestFeatures(check);
  TestSoftShadows(check);
  TestSoftHalves(check);
  TestSharp(check);
  TestSettings(check);
  TestApart(check);
  TestSurfaces(check);
  return check.Result();
}
