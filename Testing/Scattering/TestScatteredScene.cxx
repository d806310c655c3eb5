// SPDX-License-Identifier: BSD-3-Clause
// Light that volumes of a vtkShadowedScenePass scatter on and on, in the shadows of surfaces, and
// in several volumes at once.
#include "Pictures/ShadowCases.h"
#include "Pictures/ShadowPicture.h"
#include "Pictures/VolumeStage.h"
#include "Reference/Checks/ReferenceCheck.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"

#include <array>
#include <iostream>
#include <string>

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
  const int solves = stage.Mapper->GetReport().ScatteringSolves;
  const double shadowed = stage.Draw(2, 10);
  check.Equal(stage.Mapper->GetReport().ScatteringSolves, solves + 1, name + ": sheet moved");
  const double lit = stage.Draw(14, 22);
  stage.Scene.Camera->Azimuth(20.0);
  stage.Picture.Capture();
  check.Equal(stage.Mapper->GetReport().ScatteringSolves, solves + 1, name + ": view turned");
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
  check.Equal(stage.Mapper->GetReport().ScatteringBlockedCells, 0, "no plate: cells");
  stage.Actor->VisibilityOn();
  // It is in the seventh of twelve layers of cells, and the eye sees its edge alone.
  stage.Sheet->SetOrigin(0.03, -2.0, -2.0);
  stage.Sheet->SetPoint1(0.03, 2.0, -2.0);
  stage.Sheet->SetPoint2(0.03, -2.0, 2.0);
  const double beside = stage.Draw(0, 11);
  check.Equal(stage.Mapper->GetReport().ScatteringBlockedCells, 144, "plate: cells");
  const int solves = stage.Mapper->GetReport().ScatteringSolves;
  vtkShadowedScenePass::SetCastsShadows(stage.Actor, false);
  const double kept = stage.Draw(0, 11);
  check.Equal(stage.Mapper->GetReport().ScatteringBlockedCells, 0, "plate without shadows: cells");
  check.Equal(stage.Mapper->GetReport().ScatteringSolves, solves + 1, "plate without shadows");
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

/// Two volumes that are far from each other are drawn in one set of slices as each by itself.
void TestVolumes(Check& check)
{
  Stage stage;
  stage.Actor->VisibilityOff();
  stage.Scene.Camera->SetParallelScale(1.6);
  const double one = stage.Draw();
  const ShadowScene other = stage.Scene;
  vtkNew<vtkShadowedSliceMapper> mapper;
  Configure(mapper, other);
  mapper->SetMultipleScatteringToFull();
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(other.Property);
  volume->SetPosition(-1.0, 0.0, 0.0);
  stage.Picture.GetRenderer()->AddVolume(volume);
  stage.Picture.GetVolume()->SetPosition(0.5, 0.0, 0.0);
  const double both = stage.Draw();
  std::cout << "two volumes: " << both / one << std::endl;
  check.That(stage.Mapper->GetReport().ScatteringCells > 0, "first volume: cells");
  check.That(mapper->GetReport().ScatteringCells > 0, "second volume: cells");
  check.Near(both / one, 2.0, 0.04, "two volumes beside each other", 1.0);
}

}

int TestScatteredScene(int, char*[])
{
  Check check;
  TestShadows(check, false);
  TestShadows(check, true);
  TestTranslucent(check);
  TestBlocked(check);
  TestVolumes(check);
  return check.Result();
}
