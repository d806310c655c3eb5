// SPDX-License-Identifier: BSD-3-Clause
// Multiple scattering of volumes in a vtkShadowedScenePass: in shadows of surfaces, and in several
// volumes.
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Scattering/ScatteringSolver.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>

#include <glm/geometric.hpp>

namespace
{

using namespace reference;
using Mapper = vtkShadowedSliceMapper;

/// A cube that is seen along -z and lit from above. A sheet above the cube is outside the view.
struct Stage
{
  Stage()
    : Scene(MakeHomogeneousScene(12, 3.0))
    , View(std::array<int, 2>{ { 24, 24 } })
  {
    this->Scene.Camera = LookAt(this->Scene.Image, { { 0.0, 0.0, -1.0 } }, true);
    this->Scene.Camera->SetParallelScale(0.5);
    this->Scene.Lights = { MakeDirectionalLight({ { 0.0, -1.0, 0.0 } }) };
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Sheet->GetOutputPort());
    this->Actor->SetMapper(mapper);
    this->PlaceSheet(-2.0, 2.0);
    this->Mapper->SetScatteringModeToFull();
    SetScene(this->View, this->Mapper, this->Scene);
    this->View.AddActor(this->Actor);
    this->View.SetPass(this->Pass);
  }

  void PlaceSheet(double left, double right)
  {
    this->Sheet->SetOrigin(left, 0.8, -2.0);
    this->Sheet->SetPoint1(right, 0.8, -2.0);
    this->Sheet->SetPoint2(left, 0.8, 2.0);
  }

  /// Returns the sum of the pixel values in a range of columns.
  double Draw(int first = 0, int last = 24)
  {
    const RgbaImage image = this->View.Capture();
    double sum = 0.0;
    for (int j = 0; j < 24; ++j)
    {
      for (int i = first; i < last; ++i)
      {
        sum += image.At(i, j)[1];
      }
    }
    return sum;
  }

  ShadowScene Scene;
  VolumeStage View;
  vtkNew<vtkPlaneSource> Sheet;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkShadowedSliceMapper> Mapper;
  vtkNew<vtkShadowedScenePass> Pass;
};

void TestShadows(Check& check, bool isSoft)
{
  const std::string name = isSoft ? "area light" : "light";
  Stage stage;
  if (isSoft)
  {
    vtkNew<vtkAreaLight> areaLight;
    areaLight->SetPosition(0.0, 3.0, 0.0);
    areaLight->SetFocalPoint(0.0, 0.0, 0.0);
    areaLight->PositionalOn();
    areaLight->SetConeAngle(180.0);
    areaLight->SetSize(0.3, 0.3);
    stage.View.SetLights({ areaLight.Get() });
  }
  const double dark = stage.Draw();
  stage.PlaceSheet(-2.0, 0.0);
  const int solves = stage.Mapper->GetReport()->GetNumber("ScatteringSolves");
  const double shadowed = stage.Draw(2, 10);
  check.Equal(stage.Mapper->GetReport()->GetCount("ScatteringSolves"), solves + 1,
    name + ": solved again after moving the sheet");
  const double lit = stage.Draw(14, 22);
  stage.Scene.Camera->Azimuth(20.0);
  stage.View.Capture();
  check.Equal(stage.Mapper->GetReport()->GetCount("ScatteringSolves"), solves + 1,
    name + ": not solved again after rotating the view");
  stage.Scene.Camera->Azimuth(-20.0);
  stage.Mapper->SetScatteringModeToSingle();
  const double once = stage.Draw(2, 10);
  stage.Mapper->SetScatteringModeToFull();
  stage.Actor->VisibilityOff();
  const double complete = stage.Draw();
  std::cout << name << ": " << dark << " under the sheet, " << complete << " without it, halves "
            << shadowed << " and " << lit << ", by single scattering " << once << std::endl;
  check.That(complete > 100.0, name + ": light without the sheet");
  check.Near(dark / complete, 0.0, 2e-3, name + ": dark below the sheet", 1.0);
  check.That(shadowed > 3.0 * once + 5.0, name + ": scattered light in the shadow");
  check.That(shadowed < 0.5 * lit, name + ": less light than next to the shadow");
}

/// A sheet that transmits half of the light halves the scattered light.
void TestTranslucent(Check& check)
{
  Stage stage;
  stage.Actor->VisibilityOff();
  const double complete = stage.Draw();
  stage.Actor->VisibilityOn();
  stage.Actor->GetProperty()->SetOpacity(0.5);
  const double half = stage.Draw();
  std::cout << "translucent sheet: " << half / complete << std::endl;
  check.Near(half / complete, 0.5, 0.01, "half of the light with a translucent sheet", 1.0);
}

/// A plate parallel to the light direction blocks scattered light: the half of the cube next to it
/// is lit like a separate half cube.
void TestBlocked(Check& check)
{
  Stage stage;
  stage.Actor->VisibilityOff();
  const double complete = stage.Draw(0, 11);
  check.Equal(stage.Mapper->GetReport()->GetCount("ScatteringBlockedCells"), 0,
    "blocked cells without a plate");
  stage.Actor->VisibilityOn();
  // The plate is in the seventh of twelve layers of cells. Only its edge is visible.
  stage.Sheet->SetOrigin(0.03, -2.0, -2.0);
  stage.Sheet->SetPoint1(0.03, 2.0, -2.0);
  stage.Sheet->SetPoint2(0.03, -2.0, 2.0);
  const double nearPlate = stage.Draw(0, 11);
  check.Equal(stage.Mapper->GetReport()->GetCount("ScatteringBlockedCells"), 144,
    "blocked cells with a plate");
  const int solves = stage.Mapper->GetReport()->GetNumber("ScatteringSolves");
  vtkShadowedScenePass::SetCastsShadows(stage.Actor, false);
  const double nonCasting = stage.Draw(0, 11);
  check.Equal(stage.Mapper->GetReport()->GetCount("ScatteringBlockedCells"), 0,
    "blocked cells with a plate without shadows");
  check.Equal(stage.Mapper->GetReport()->GetCount("ScatteringSolves"), solves + 1,
    "solved again after turning off the plate's shadows");
  stage.Actor->VisibilityOff();
  stage.Scene.CroppingFlags = VTK_CROP_SUBVOLUME;
  stage.Scene.CroppingPlanes = { { -0.5, 0.0, -0.5, 0.5, -0.5, 0.5 } };
  SetScene(stage.View, stage.Mapper, stage.Scene);
  const double half = stage.Draw(0, 11);
  std::cout << "plate in the cube: " << nearPlate << " next to it, " << half << " in half a cube, "
            << complete << " without it" << std::endl;
  check.That(nearPlate < 0.97 * complete, "less light next to a plate");
  check.Near(
    nonCasting / complete, 1.0, 1e-6, "a plate without shadows does not change the light", 1.0);
  check.Near(nearPlate / half, 1.0, 5e-3, "next to a plate, light as in half a cube", 1.0);
}

/// Solves the scattering in the cube, and computes the light that a horizontal surface receives at
/// a point below the cube's center.
class FloorLight
{
public:
  FloorLight(double extinction, double g)
    : Anisotropy(g)
  {
    this->Medium.Cells = glm::ivec3(Cells);
    this->Medium.CellSize = glm::dvec3(1.0 / Cells);
    this->Medium.Extinction.assign(this->Medium.GetNumberOfCells(), static_cast<float>(extinction));
    this->Medium.Albedo.assign(this->Medium.GetNumberOfCells(), glm::vec3(1.0F));
    static_cast<void>(this->Medium.Phase.SetHenyeyGreenstein(g));
    this->Light.Direction = { 0.0, -1.0, 0.0 };
    this->Light.Fill(this->Medium, glm::vec3(0.8F));
    interlume::ScatteringReport report;
    static_cast<void>(interlume::ScatteringSolver::Solve(
      this->Medium, { this->Light }, interlume::ScatteringMode::Full, {}, this->Field, report));
  }

  /// Returns the received light according to the formula in SceneScatteredLight.h.
  double GetFormula(double distance) const
  {
    double sum = 0.0;
    for (const glm::ivec3& cell :
      { glm::ivec3(5, 0, 5), glm::ivec3(6, 0, 5), glm::ivec3(5, 0, 6), glm::ivec3(6, 0, 6) })
    {
      const std::size_t at = this->Medium.GetIndex(cell);
      sum += 0.25 * this->Field.Fluence[at].y * (0.25 - 0.5 * this->Field.NetFlux[at].y);
      sum += this->Field.Forward.empty() ? 0.0 : 0.25 * this->Field.Forward[0][at].y;
    }
    const double disk = 1.0 / vtkMath::Pi();
    return sum * disk / (disk + distance * distance);
  }

  /// Returns the received light, integrated along rays in all directions of the upper hemisphere.
  double GetIntegral(double distance) const
  {
    constexpr int lines = 4000;
    constexpr int steps = 200;
    double sum = 0.0;
    for (int line = 0; line < lines; ++line)
    {
      const double height = std::sqrt((line + 0.5) / lines);
      const double angle = 2.399963229728653 * line;
      const double side = std::sqrt(1.0 - height * height);
      const glm::dvec3 up(side * std::cos(angle), height, side * std::sin(angle));
      double transmittance = 1.0;
      for (int step = 0; step < steps; ++step)
      {
        const double length = 1.0 / steps / height;
        const glm::dvec3 position =
          glm::dvec3(0.5, -distance, 0.5) + (distance / height + (step + 0.5) * length) * up;
        if (std::min(position.x, position.z) > 0.0 && std::max(position.x, position.z) < 1.0)
        {
          const std::size_t at = this->Medium.GetIndex(glm::ivec3(position * double(Cells)));
          const double transmitted = std::exp(-length * this->Medium.Extinction[at]);
          sum += transmittance * (1.0 - transmitted) * this->GetSource(at, -up) / lines;
          transmittance *= transmitted;
        }
      }
    }
    return 0.25 * sum;
  }

private:
  static constexpr int Cells = 12;

  double GetSource(std::size_t at, const glm::dvec3& toCamera) const
  {
    const double phase =
      4.0 * vtkMath::Pi() * this->Medium.Phase.Value(glm::dot(this->Light.Direction, toCamera));
    const double forward = this->Field.Forward.empty() ? 0.0 : this->Field.Forward[0][at].y;
    return (this->Light.Direct[at].y + forward) * phase +
      this->Field.Fluence[at].y *
      (1.0 + 3.0 * this->Anisotropy * glm::dot(glm::dvec3(this->Field.NetFlux[at]), toCamera));
  }

  double Anisotropy;
  interlume::ScatteringMedium Medium;
  interlume::ScatteringLight Light;
  interlume::ScatteredLight Field;
};

/// In addition to the light without multiple scattering, a white floor below the cube receives the
/// light that the formula of FloorLight predicts.
void TestReceived(Check& check)
{
  constexpr double distance = 0.25;
  Stage stage;
  stage.Sheet->SetOrigin(-2.0, -0.5 - distance, -2.0);
  stage.Sheet->SetPoint1(-2.0, -0.5 - distance, 2.0);
  stage.Sheet->SetPoint2(2.0, -0.5 - distance, -2.0);
  // The center of the image shows the floor below the center of the cube.
  stage.Scene.Camera->SetFocalPoint(0.0, -0.5 - distance, 0.0);
  stage.Scene.Camera->SetPosition(0.0, -0.5 - distance + 0.9, 3.0);
  stage.Scene.Camera->SetViewUp(0.0, 1.0, 0.0);
  stage.Scene.Camera->SetClippingRange(0.1, 10.0);
  stage.Scene.Camera->SetParallelScale(0.05);
  const auto draw = [&](int mode)
  {
    stage.Mapper->SetScatteringMode(mode);
    return stage.Draw() / (24.0 * 24.0);
  };
  for (const double g : { 0.0, 0.75 })
  {
    const std::string name = "floor, g " + std::to_string(g);
    stage.Mapper->SetPhaseFunctionToHenyeyGreenstein();
    stage.Mapper->SetAnisotropy(g);
    const double once = draw(Mapper::SINGLE_SCATTERING);
    check.Equal(stage.Pass->GetReport()->GetCount("ScatteringReceivers"), 0,
      name + ": no receivers with single scattering");
    const double full = draw(Mapper::FULL_SCATTERING);
    check.Equal(stage.Pass->GetReport()->GetCount("ScatteringReceivers"), 1,
      name + ": receivers with full scattering");
    vtkShadowedScenePass::SetReceivesShadows(stage.Actor, false);
    const double lit = draw(Mapper::FULL_SCATTERING);
    check.Equal(stage.Pass->GetReport()->GetCount("ScatteringReceivers"), 0,
      name + ": no receivers without shadows");
    vtkShadowedScenePass::SetReceivesShadows(stage.Actor, true);
    const FloorLight floorLight(3.0, g);
    const double expected = floorLight.GetFormula(distance);
    std::cout << name << ": " << full << " from " << once << ", " << lit
              << " without shadows, scattered " << full - once << ", by formula " << expected
              << ", by integration " << floorLight.GetIntegral(distance) << std::endl;
    check.Near(once, 0.8 * std::exp(-3.0), 0.01, name + ": light transmitted by the cube", 1.0);
    check.Near(lit, 0.8, 1e-3, name + ": all light without shadows", 1.0);
    check.Near((full - once) / expected, 1.0, 0.05, name + ": received light", 1.0);
    // The formula uses the center of the bottom face, which is brighter than the edges of this
    // face.
    check.Near(expected / floorLight.GetIntegral(distance), 1.2, 0.25, name + ": formula", 1.0);
  }
  check.Equal(stage.Pass->GetReport()->GetCount("SeparateScatteringVolumes"), 0,
    "no separate scattering volumes");
}

/// A floor below a cube, which receives light that the cube scatters.
struct ReceivedStage : Stage
{
  ReceivedStage()
  {
    constexpr double height = -0.75;
    this->Sheet->SetOrigin(-2.0, height, -2.0);
    this->Sheet->SetPoint1(-2.0, height, 2.0);
    this->Sheet->SetPoint2(2.0, height, -2.0);
    this->Scene.Camera->SetFocalPoint(0.0, height, 0.0);
    this->Scene.Camera->SetPosition(0.0, height + 0.9, 3.0);
    this->Scene.Camera->SetClippingRange(0.1, 10.0);
    this->Scene.Camera->SetParallelScale(0.05);
  }

  /// Returns the mean of the image values, each raised to the power \a gamma.
  double GetMean(int mode, double gamma)
  {
    this->Mapper->SetScatteringMode(mode);
    const RgbaImage image = this->View.Capture();
    double sum = 0.0;
    for (int j = 0; j < 24; ++j)
    {
      for (int i = 0; i < 24; ++i)
      {
        sum += std::pow(image.At(i, j)[1], gamma) / (24.0 * 24.0);
      }
    }
    return sum;
  }

  double GetReceived(double gamma = 1.0)
  {
    return this->GetMean(Mapper::FULL_SCATTERING, gamma) -
      this->GetMean(Mapper::SINGLE_SCATTERING, gamma);
  }
};

/// Translucent floors receive scattered light in proportion to their opacity. Physically based
/// floors use VTK's ambient lighting formula. A translucent sheet in front of a floor does not
/// change the light that the floor receives.
void TestKindsOfReceivers(Check& check)
{
  ReceivedStage stage;
  const double plain = stage.GetReceived();
  vtkProperty* property = stage.Actor->GetProperty();
  property->SetOpacity(0.5);
  const double translucent = stage.GetReceived();
  check.Equal(stage.Pass->GetReport()->GetCount("ScatteringReceivers"), 0,
    "translucent floor: no receivers with single scattering");
  stage.GetMean(Mapper::FULL_SCATTERING, 1.0);
  check.Equal(
    stage.Pass->GetReport()->GetCount("ScatteringReceivers"), 1, "translucent floor: receivers");
  property->SetOpacity(1.0);
  property->SetInterpolationToPBR();
  property->SetRoughness(1.0);
  property->SetMetallic(0.0);
  const double physical = stage.GetReceived(2.2);
  check.Equal(stage.Pass->GetReport()->GetCount("ScatteringReceivers"), 0,
    "physically based floor: no receivers with single scattering");
  property->SetMetallic(1.0);
  const double metal = stage.GetReceived(2.2);
  property->SetInterpolationToPhong();

  vtkNew<vtkPlaneSource> glass;
  glass->SetOrigin(-2.0, -2.0, 1.0);
  glass->SetPoint1(2.0, -2.0, 1.0);
  glass->SetPoint2(-2.0, 2.0, 1.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(glass->GetOutputPort());
  vtkNew<vtkActor> glassActor;
  glassActor->SetMapper(mapper);
  glassActor->GetProperty()->SetOpacity(0.5);
  glassActor->GetProperty()->LightingOff();
  glassActor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  vtkShadowedScenePass::SetCastsShadows(glassActor, false);
  stage.View.AddActor(glassActor);
  const double behind = stage.GetReceived();

  std::cout << "received by a floor: " << plain << ", translucent " << translucent
            << ", physically based " << physical << ", metallic " << metal << ", behind glass "
            << behind << std::endl;
  check.That(plain > 0.05, "a floor receives light");
  check.Near(translucent / plain, 0.5, 0.005, "translucent floor", 1.0);
  // At normal incidence, a surface of refractive index 1.5 reflects 4 % specularly.
  check.Near(physical / plain, 0.96 / vtkMath::Pi(), 0.003, "physically based floor", 1.0);
  check.Near(metal, 0.0, 1e-4, "metallic floor", 1.0);
  check.Near(behind / plain, 0.5, 0.005, "floor behind glass", 1.0);
}

/// A plate that consists of glyphs blocks scattered light like a single plate.
void TestBlockingGlyphs(Check& check)
{
  Stage stage;
  stage.Sheet->SetOrigin(0.03, -2.0, -2.0);
  stage.Sheet->SetPoint1(0.03, 2.0, -2.0);
  stage.Sheet->SetPoint2(0.03, -2.0, 2.0);
  const double nearPlate = stage.Draw(0, 11);
  stage.Actor->VisibilityOff();
  vtkNew<vtkPoints> positions;
  positions->InsertNextPoint(0.03, 0.0, 0.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(positions);
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(0.0, -0.5, -0.5);
  plate->SetPoint1(0.0, 0.5, -0.5);
  plate->SetPoint2(0.0, -0.5, 0.5);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetSourceConnection(plate->GetOutputPort());
  mapper->SetScaleFactor(4.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.View.AddActor(actor);
  const double glyphs = stage.Draw(0, 11);
  std::cout << "plate of glyphs: " << glyphs << ", plate " << nearPlate << std::endl;
  check.Equal(stage.Mapper->GetReport()->GetCount("ScatteringBlockedCells"), 144,
    "blocked cells with a plate of glyphs");
  check.Near(glyphs / nearPlate, 1.0, 1e-3, "light with a plate of glyphs", 1.0);
}

/// A stage with a second volume and without a sheet.
struct TwoVolumes : Stage
{
  TwoVolumes()
  {
    this->Actor->VisibilityOff();
    this->Other->SetScatteringModeToFull();
    this->Volume->SetMapper(this->Other);
  }

  void Show(const ShadowScene& first, const ShadowScene& second)
  {
    SetScene(this->View, this->Mapper, first);
    Configure(this->Other, second);
    this->Volume->SetProperty(second.Property);
    this->View.GetRenderer()->AddVolume(this->Volume);
  }

  vtkNew<vtkShadowedSliceMapper> Other;
  vtkNew<vtkVolume> Volume;
};

/// Each of two distant volumes that share slices is lit as if it were alone.
void TestVolumes(Check& check)
{
  TwoVolumes stage;
  stage.Scene.Camera->SetParallelScale(1.6);
  const double one = stage.Draw();
  stage.Show(stage.Scene, stage.Scene);
  stage.Volume->SetPosition(-1.0, 0.0, 0.0);
  stage.View.GetVolume()->SetPosition(0.5, 0.0, 0.0);
  const double both = stage.Draw();
  std::cout << "two volumes: " << both / one << std::endl;
  // Twelve cells per unit length, in a box of length 2.5.
  check.Equal(stage.Mapper->GetReport()->GetCount("ScatteringCells"), 30 * 12 * 12,
    "cells of the first volume");
  check.Equal(stage.Other->GetReport()->GetCount("ScatteringCells"), 30 * 12 * 12,
    "cells of the second volume");
  check.Equal(stage.Pass->GetReport()->GetCount("SeparateScatteringVolumes"), 0,
    "no separate scattering volumes");
  check.Near(both / one, 2.0, 0.04, "two distant volumes", 1.0);
}

/// Returns the mean difference of the image from the expected image, relative to the mean of the
/// expected image.
double Compare(TwoVolumes& stage, const RgbaImage& expected)
{
  const RgbaImage found = stage.View.Capture();
  double difference = 0.0;
  double sum = 0.0;
  for (int j = 0; j < 24; ++j)
  {
    for (int i = 0; i < 24; ++i)
    {
      difference += std::abs(found.At(i, j)[1] - expected.At(i, j)[1]);
      sum += expected.At(i, j)[1];
    }
  }
  return difference / sum;
}

/// Two halves of a cube, and two coincident cubes with half the extinction, scatter light like one
/// cube.
void TestVolumesTogether(Check& check)
{
  TwoVolumes stage;
  stage.Scene.Camera->Azimuth(25.0);
  stage.Scene.Camera->Elevation(30.0);
  stage.Scene.Camera->SetParallelScale(0.8);
  const RgbaImage complete = stage.View.Capture();
  ShadowScene half = stage.Scene;
  half.CroppingFlags = VTK_CROP_SUBVOLUME;
  half.CroppingPlanes = { { -0.5, 0.0, -0.5, 0.5, -0.5, 0.5 } };
  ShadowScene rest = half;
  rest.CroppingPlanes = { { 0.0, 0.5, -0.5, 0.5, -0.5, 0.5 } };
  stage.Show(half, rest);
  const double halves = Compare(stage, complete);
  stage.Other->SetScatteringModeToSingle();
  const double absorbing = Compare(stage, complete);
  check.Equal(stage.Other->GetReport()->GetCount("ScatteringCells"), 0,
    "a volume with single scattering has no cells");
  stage.Other->SetScatteringModeToFull();

  ShadowScene halfDensity = MakeHomogeneousScene(12, 1.5);
  halfDensity.Camera = stage.Scene.Camera;
  halfDensity.Lights = stage.Scene.Lights;
  stage.Show(halfDensity, halfDensity);
  const double doubled = Compare(stage, complete);
  const int solves = stage.Mapper->GetReport()->GetNumber("ScatteringSolves");
  stage.Volume->SetPosition(0.1, 0.0, 0.0);
  stage.View.Capture();
  check.Equal(stage.Mapper->GetReport()->GetCount("ScatteringSolves"), solves + 1,
    "solved again after moving the other volume");
  stage.Volume->SetPosition(0.0, 0.0, 0.0);
  // Volumes with different phase functions have separate fields of scattered light.
  stage.Other->SetPhaseFunctionToHenyeyGreenstein();
  stage.Other->SetAnisotropy(1e-3);
  const double separate = Compare(stage, complete);
  std::cout << "compared with one volume: halves " << halves << ", one half with single scattering "
            << absorbing << ", half the extinction twice " << doubled
            << ", with two phase functions " << separate << std::endl;
  check.Near(halves, 0.0, 0.002, "two halves", 1.0);
  check.That(absorbing > 0.1, "a half without multiple scattering");
  check.Near(doubled, 0.0, 0.005, "half the extinction twice", 1.0);
  check.Near(separate, 0.0, 0.005, "half the extinction twice, two phase functions", 1.0);
}

}

int TestScatteredScene(int, char*[])
{
  Check check;
  TestShadows(check, false);
  TestShadows(check, true);
  TestTranslucent(check);
  TestBlocked(check);
  TestBlockingGlyphs(check);
  TestReceived(check);
  TestKindsOfReceivers(check);
  TestVolumes(check);
  TestVolumesTogether(check);
  return check.Result();
}
