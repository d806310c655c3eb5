// SPDX-License-Identifier: BSD-3-Clause
// Light that volumes of a vtkShadowedScenePass scatter on and on, in the shadows of surfaces, and
// in several volumes at once.
#include "Support/Pictures/ShadowCases.h"
#include "Support/Drawing/ShadowPicture.h"
#include "Support/Pictures/VolumeStage.h"
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

/// A cube seen along -z, lit from above, under a sheet that the eye does not see.
struct Stage
{
  Stage()
    : Scene(MakeHomogeneousScene(12, 3.0))
    , Picture(std::array<int, 2>{ { 24, 24 } })
  {
    this->Scene.Camera = LookAt(this->Scene.Image, { { 0.0, 0.0, -1.0 } }, true);
    this->Scene.Camera->SetParallelScale(0.5);
    this->Scene.Lights = { MakeDirectionalLight({ { 0.0, -1.0, 0.0 } }) };
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Sheet->GetOutputPort());
    this->Actor->SetMapper(mapper);
    this->PlaceSheet(-2.0, 2.0);
    this->Mapper->SetMultipleScatteringToFull();
    SetScene(this->Picture, this->Mapper, this->Scene);
    this->Picture.AddActor(this->Actor);
    this->Picture.SetPass(this->Pass);
  }

  void PlaceSheet(double left, double right)
  {
    this->Sheet->SetOrigin(left, 0.8, -2.0);
    this->Sheet->SetPoint1(right, 0.8, -2.0);
    this->Sheet->SetPoint2(left, 0.8, 2.0);
  }

  /// The sum of a half of the picture, or of all.
  double Draw(int first = 0, int last = 24)
  {
    const RgbaPicture picture = this->Picture.Capture();
    double sum = 0.0;
    for (int j = 0; j < 24; ++j)
    {
      for (int i = first; i < last; ++i)
      {
        sum += picture.At(i, j)[1];
      }
    }
    return sum;
  }

  ShadowScene Scene;
  VolumeStage Picture;
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
    vtkNew<vtkAreaLight> lamp;
    lamp->SetPosition(0.0, 3.0, 0.0);
    lamp->SetFocalPoint(0.0, 0.0, 0.0);
    lamp->PositionalOn();
    lamp->SetConeAngle(180.0);
    lamp->SetSize(0.3, 0.3);
    stage.Picture.SetLights({ lamp.Get() });
  }
  const double dark = stage.Draw();
  stage.PlaceSheet(-2.0, 0.0);
  const int solves = stage.Mapper->GetReport()->GetNumber("ScatteringSolves");
  const double shadowed = stage.Draw(2, 10);
  check.Near(stage.Mapper->GetReport()->GetNumber("ScatteringSolves"), solves + 1, 0.0,
    name + ": sheet moved");
  const double lit = stage.Draw(14, 22);
  stage.Scene.Camera->Azimuth(20.0);
  stage.Picture.Capture();
  check.Near(stage.Mapper->GetReport()->GetNumber("ScatteringSolves"), solves + 1, 0.0,
    name + ": view turned");
  stage.Scene.Camera->Azimuth(-20.0);
  stage.Mapper->SetMultipleScatteringToSingle();
  const double once = stage.Draw(2, 10);
  stage.Mapper->SetMultipleScatteringToFull();
  stage.Actor->VisibilityOff();
  const double whole = stage.Draw();
  std::cout << name << ": " << dark << " under the sheet, " << whole << " without, halves "
            << shadowed << " and " << lit << ", by single scattering " << once << std::endl;
  check.That(whole > 100.0, name + ": light without the sheet");
  check.Near(dark / whole, 0.0, 2e-3, name + ": dark under the sheet", 1.0);
  check.That(shadowed > 3.0 * once + 5.0, name + ": scattered light in the shadow");
  check.That(shadowed < 0.5 * lit, name + ": less than beside it");
}

/// A sheet that takes half of the light takes half of what is scattered.
void TestTranslucent(Check& check)
{
  Stage stage;
  stage.Actor->VisibilityOff();
  const double whole = stage.Draw();
  stage.Actor->VisibilityOn();
  stage.Actor->GetProperty()->SetOpacity(0.5);
  const double half = stage.Draw();
  std::cout << "translucent sheet: " << half / whole << std::endl;
  check.Near(half / whole, 0.5, 0.01, "half of the light through a sheet", 1.0);
}

/// A plate along the light stops what was scattered: the half of the cube beside it is as by
/// itself.
void TestBlocked(Check& check)
{
  Stage stage;
  stage.Actor->VisibilityOff();
  const double whole = stage.Draw(0, 11);
  check.Near(
    stage.Mapper->GetReport()->GetNumber("ScatteringBlockedCells"), 0, 0.0, "no plate: cells");
  stage.Actor->VisibilityOn();
  // It is in the seventh of twelve layers of cells, and the eye sees its edge alone.
  stage.Sheet->SetOrigin(0.03, -2.0, -2.0);
  stage.Sheet->SetPoint1(0.03, 2.0, -2.0);
  stage.Sheet->SetPoint2(0.03, -2.0, 2.0);
  const double beside = stage.Draw(0, 11);
  check.Near(
    stage.Mapper->GetReport()->GetNumber("ScatteringBlockedCells"), 144, 0.0, "plate: cells");
  const int solves = stage.Mapper->GetReport()->GetNumber("ScatteringSolves");
  vtkShadowedScenePass::SetCastsShadows(stage.Actor, false);
  const double kept = stage.Draw(0, 11);
  check.Near(stage.Mapper->GetReport()->GetNumber("ScatteringBlockedCells"), 0, 0.0,
    "plate without shadows: cells");
  check.Near(stage.Mapper->GetReport()->GetNumber("ScatteringSolves"), solves + 1, 0.0,
    "plate without shadows");
  stage.Actor->VisibilityOff();
  stage.Scene.CroppingFlags = VTK_CROP_SUBVOLUME;
  stage.Scene.CroppingPlanes = { { -0.5, 0.0, -0.5, 0.5, -0.5, 0.5 } };
  SetScene(stage.Picture, stage.Mapper, stage.Scene);
  const double half = stage.Draw(0, 11);
  std::cout << "plate in the cube: " << beside << " beside it, " << half << " in half a cube, "
            << whole << " without" << std::endl;
  check.That(beside < 0.97 * whole, "less light beside a plate");
  check.Near(kept / whole, 1.0, 1e-6, "plate without shadows: light", 1.0);
  check.Near(beside / half, 1.0, 5e-3, "beside a plate as in half a cube", 1.0);
}

/// The cube by the solver, and what a place below its middle receives through a horizontal plane.
class Below
{
public:
  Below(double extinction, double g)
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

  /// By the formula of SceneFields.h.
  double GetFormula(double distance) const
  {
    double sum = 0.0;
    for (const glm::ivec3& cell :
      { glm::ivec3(5, 0, 5), glm::ivec3(6, 0, 5), glm::ivec3(5, 0, 6), glm::ivec3(6, 0, 6) })
    {
      const std::size_t at = this->Medium.GetIndex(cell);
      sum += 0.25 * this->Field.Fluence[at].y * (0.25 - 0.5 * this->Field.Lean[at].y);
      sum += this->Field.Forward.empty() ? 0.0 : 0.25 * this->Field.Forward[0][at].y;
    }
    const double disc = 1.0 / vtkMath::Pi();
    return sum * disc / (disc + distance * distance);
  }

  /// By the sources along lines to all directions of the upper half space.
  double GetTrue(double distance) const
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
        const double way = 1.0 / steps / height;
        const glm::dvec3 place =
          glm::dvec3(0.5, -distance, 0.5) + (distance / height + (step + 0.5) * way) * up;
        if (std::min(place.x, place.z) > 0.0 && std::max(place.x, place.z) < 1.0)
        {
          const std::size_t at = this->Medium.GetIndex(glm::ivec3(place * double(Cells)));
          const double through = std::exp(-way * this->Medium.Extinction[at]);
          sum += transmittance * (1.0 - through) * this->GetSource(at, -up) / lines;
          transmittance *= through;
        }
      }
    }
    return 0.25 * sum;
  }

private:
  static constexpr int Cells = 12;

  double GetSource(std::size_t at, const glm::dvec3& toEye) const
  {
    const double phase =
      4.0 * vtkMath::Pi() * this->Medium.Phase.Value(glm::dot(this->Light.Direction, toEye));
    const double onwards = this->Field.Forward.empty() ? 0.0 : this->Field.Forward[0][at].y;
    return (this->Light.Direct[at].y + onwards) * phase +
      this->Field.Fluence[at].y *
      (1.0 + 3.0 * this->Anisotropy * glm::dot(glm::dvec3(this->Field.Lean[at]), toEye));
  }

  double Anisotropy;
  interlume::ScatteringMedium Medium;
  interlume::ScatteringLight Light;
  interlume::ScatteringField Field;
};

/// A white floor under the cube receives what the formula says, and that without scattering on.
void TestReceived(Check& check)
{
  constexpr double distance = 0.25;
  Stage stage;
  stage.Sheet->SetOrigin(-2.0, -0.5 - distance, -2.0);
  stage.Sheet->SetPoint1(-2.0, -0.5 - distance, 2.0);
  stage.Sheet->SetPoint2(2.0, -0.5 - distance, -2.0);
  // The middle of the picture shows the floor below the middle of the cube.
  stage.Scene.Camera->SetFocalPoint(0.0, -0.5 - distance, 0.0);
  stage.Scene.Camera->SetPosition(0.0, -0.5 - distance + 0.9, 3.0);
  stage.Scene.Camera->SetViewUp(0.0, 1.0, 0.0);
  stage.Scene.Camera->SetClippingRange(0.1, 10.0);
  stage.Scene.Camera->SetParallelScale(0.05);
  const auto draw = [&](int mode)
  {
    stage.Mapper->SetMultipleScattering(mode);
    return stage.Draw() / (24.0 * 24.0);
  };
  for (const double g : { 0.0, 0.75 })
  {
    const std::string name = "floor, g " + std::to_string(g);
    stage.Mapper->SetPhaseFunctionToHenyeyGreenstein();
    stage.Mapper->SetAnisotropy(g);
    const double once = draw(Mapper::SINGLE_SCATTERING);
    check.Near(
      stage.Pass->GetReport()->GetNumber("ScatteringReceivers"), 0, 0.0, name + ": none by single");
    const double full = draw(Mapper::FULL_SCATTERING);
    check.Near(
      stage.Pass->GetReport()->GetNumber("ScatteringReceivers"), 1, 0.0, name + ": receivers");
    vtkShadowedScenePass::SetReceivesShadows(stage.Actor, false);
    const double lit = draw(Mapper::FULL_SCATTERING);
    check.Near(
      stage.Pass->GetReport()->GetNumber("ScatteringReceivers"), 0, 0.0, name + ": kept from it");
    vtkShadowedScenePass::SetReceivesShadows(stage.Actor, true);
    const Below below(3.0, g);
    const double expected = below.GetFormula(distance);
    std::cout << name << ": " << full << " from " << once << ", " << lit
              << " without shadows, scattered " << full - once << ", by the formula " << expected
              << ", by lines " << below.GetTrue(distance) << std::endl;
    check.Near(once, 0.8 * std::exp(-3.0), 0.01, name + ": light through the cube", 1.0);
    check.Near(lit, 0.8, 1e-3, name + ": all light without shadows", 1.0);
    check.Near((full - once) / expected, 1.0, 0.05, name + ": received", 1.0);
    // The face is brighter in its middle than at its edges.
    check.Near(expected / below.GetTrue(distance), 1.2, 0.25, name + ": formula", 1.0);
  }
  check.Near(stage.Pass->GetReport()->GetNumber("SeparateScatteringVolumes"), 0, 0.0, "one volume");
}

/// What a floor below a cube shows of light that the cube has scattered.
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

  /// The mean of the picture's powers by \a gamma.
  double GetMean(int mode, double gamma)
  {
    this->Mapper->SetMultipleScattering(mode);
    const RgbaPicture picture = this->Picture.Capture();
    double sum = 0.0;
    for (int j = 0; j < 24; ++j)
    {
      for (int i = 0; i < 24; ++i)
      {
        sum += std::pow(picture.At(i, j)[1], gamma) / (24.0 * 24.0);
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

/// Translucent floors receive their share, physically based ones what VTK's formula of light from
/// all around leaves of it, and floors behind a sheet of glass as much as without it.
void TestKindsOfReceivers(Check& check)
{
  ReceivedStage stage;
  const double plain = stage.GetReceived();
  vtkProperty* property = stage.Actor->GetProperty();
  property->SetOpacity(0.5);
  const double translucent = stage.GetReceived();
  check.Near(
    stage.Pass->GetReport()->GetNumber("ScatteringReceivers"), 0, 0.0, "translucent by single");
  stage.GetMean(Mapper::FULL_SCATTERING, 1.0);
  check.Near(
    stage.Pass->GetReport()->GetNumber("ScatteringReceivers"), 1, 0.0, "translucent: receivers");
  property->SetOpacity(1.0);
  property->SetInterpolationToPBR();
  property->SetRoughness(1.0);
  property->SetMetallic(0.0);
  const double physical = stage.GetReceived(2.2);
  check.Near(stage.Pass->GetReport()->GetNumber("ScatteringReceivers"), 0, 0.0,
    "physically based by single");
  property->SetMetallic(1.0);
  const double metal = stage.GetReceived(2.2);
  property->SetInterpolationToPhong();

  vtkNew<vtkPlaneSource> glass;
  glass->SetOrigin(-2.0, -2.0, 1.0);
  glass->SetPoint1(2.0, -2.0, 1.0);
  glass->SetPoint2(-2.0, 2.0, 1.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(glass->GetOutputPort());
  vtkNew<vtkActor> pane;
  pane->SetMapper(mapper);
  pane->GetProperty()->SetOpacity(0.5);
  pane->GetProperty()->LightingOff();
  pane->GetProperty()->SetColor(0.0, 0.0, 0.0);
  vtkShadowedScenePass::SetCastsShadows(pane, false);
  stage.Picture.AddActor(pane);
  const double behind = stage.GetReceived();

  std::cout << "received by a floor: " << plain << ", translucent " << translucent
            << ", physically based " << physical << ", of metal " << metal << ", behind glass "
            << behind << std::endl;
  check.That(plain > 0.05, "a floor receives light");
  check.Near(translucent / plain, 0.5, 0.005, "translucent floor", 1.0);
  // Of light at right angles the surface of a medium of index 1.5 reflects 0.04 as a mirror.
  check.Near(physical / plain, 0.96 / vtkMath::Pi(), 0.003, "physically based floor", 1.0);
  check.Near(metal, 0.0, 1e-4, "floor of metal", 1.0);
  check.Near(behind / plain, 0.5, 0.005, "floor behind glass", 1.0);
}

/// A plate of glyphs stops what was scattered as a plate does.
void TestBlockingGlyphs(Check& check)
{
  Stage stage;
  stage.Sheet->SetOrigin(0.03, -2.0, -2.0);
  stage.Sheet->SetPoint1(0.03, 2.0, -2.0);
  stage.Sheet->SetPoint2(0.03, -2.0, 2.0);
  const double beside = stage.Draw(0, 11);
  stage.Actor->VisibilityOff();
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(0.03, 0.0, 0.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(places);
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
  stage.Picture.AddActor(actor);
  const double glyphs = stage.Draw(0, 11);
  std::cout << "plate of glyphs: " << glyphs << ", plate " << beside << std::endl;
  check.Near(stage.Mapper->GetReport()->GetNumber("ScatteringBlockedCells"), 144, 0.0,
    "plate of glyphs: cells");
  check.Near(glyphs / beside, 1.0, 1e-3, "plate of glyphs: light", 1.0);
}

/// A stage with a second volume, and no sheet.
struct TwoVolumes : Stage
{
  TwoVolumes()
  {
    this->Actor->VisibilityOff();
    this->Other->SetMultipleScatteringToFull();
    this->Volume->SetMapper(this->Other);
  }

  void Show(const ShadowScene& first, const ShadowScene& second)
  {
    SetScene(this->Picture, this->Mapper, first);
    Configure(this->Other, second);
    this->Volume->SetProperty(second.Property);
    this->Picture.GetRenderer()->AddVolume(this->Volume);
  }

  vtkNew<vtkShadowedSliceMapper> Other;
  vtkNew<vtkVolume> Volume;
};

/// Two volumes that are far from each other are drawn in one set of slices as each by itself.
void TestVolumes(Check& check)
{
  TwoVolumes stage;
  stage.Scene.Camera->SetParallelScale(1.6);
  const double one = stage.Draw();
  stage.Show(stage.Scene, stage.Scene);
  stage.Volume->SetPosition(-1.0, 0.0, 0.0);
  stage.Picture.GetVolume()->SetPosition(0.5, 0.0, 0.0);
  const double both = stage.Draw();
  std::cout << "two volumes: " << both / one << std::endl;
  // Twelve cells for an edge of 1, in a box of 2.5.
  check.Near(stage.Mapper->GetReport()->GetNumber("ScatteringCells"), 30 * 12 * 12, 0.0,
    "first volume: cells");
  check.Near(stage.Other->GetReport()->GetNumber("ScatteringCells"), 30 * 12 * 12, 0.0,
    "second volume: cells");
  check.Near(
    stage.Pass->GetReport()->GetNumber("SeparateScatteringVolumes"), 0, 0.0, "volumes apart");
  check.Near(both / one, 2.0, 0.04, "two volumes beside each other", 1.0);
}

/// The mean difference of a picture of two volumes from one of a volume, over its mean.
double Compare(TwoVolumes& stage, const RgbaPicture& expected)
{
  const RgbaPicture found = stage.Picture.Capture();
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

/// Two halves of a cube, and two cubes of half its matter at its place, scatter light as the cube.
void TestVolumesTogether(Check& check)
{
  TwoVolumes stage;
  stage.Scene.Camera->Azimuth(25.0);
  stage.Scene.Camera->Elevation(30.0);
  stage.Scene.Camera->SetParallelScale(0.8);
  const RgbaPicture whole = stage.Picture.Capture();
  ShadowScene half = stage.Scene;
  half.CroppingFlags = VTK_CROP_SUBVOLUME;
  half.CroppingPlanes = { { -0.5, 0.0, -0.5, 0.5, -0.5, 0.5 } };
  ShadowScene rest = half;
  rest.CroppingPlanes = { { 0.0, 0.5, -0.5, 0.5, -0.5, 0.5 } };
  stage.Show(half, rest);
  const double halves = Compare(stage, whole);
  stage.Other->SetMultipleScatteringToSingle();
  const double absorbing = Compare(stage, whole);
  check.Near(
    stage.Other->GetReport()->GetNumber("ScatteringCells"), 0, 0.0, "single beside full: cells");
  stage.Other->SetMultipleScatteringToFull();

  ShadowScene thin = MakeHomogeneousScene(12, 1.5);
  thin.Camera = stage.Scene.Camera;
  thin.Lights = stage.Scene.Lights;
  stage.Show(thin, thin);
  const double thinner = Compare(stage, whole);
  const int solves = stage.Mapper->GetReport()->GetNumber("ScatteringSolves");
  stage.Volume->SetPosition(0.1, 0.0, 0.0);
  stage.Picture.Capture();
  check.Near(stage.Mapper->GetReport()->GetNumber("ScatteringSolves"), solves + 1, 0.0,
    "the other volume moved");
  stage.Volume->SetPosition(0.0, 0.0, 0.0);
  // Another phase function has light of its own.
  stage.Other->SetPhaseFunctionToHenyeyGreenstein();
  stage.Other->SetAnisotropy(1e-3);
  const double apart = Compare(stage, whole);
  std::cout << "against one volume: halves " << halves << ", one of them by single " << absorbing
            << ", half the matter twice " << thinner << ", with two phase functions " << apart
            << std::endl;
  check.Near(halves, 0.0, 0.002, "two halves", 1.0);
  check.That(absorbing > 0.1, "a half that does not scatter on");
  check.Near(thinner, 0.0, 0.005, "half the matter twice", 1.0);
  check.Near(apart, 0.0, 0.005, "half the matter twice, two phase functions", 1.0);
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
