// SPDX-License-Identifier: BSD-3-Clause
// Light that vtkShadowedSliceMapper scatters on and on is found again where something has changed
// that it depends on, and kept where the view alone has.
#include "Support/Pictures/ShadowCases.h"
#include "Support/Drawing/ShadowPicture.h"
#include "Support/Pictures/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <functional>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using Mapper = vtkShadowedSliceMapper;

/// A scene, a mapper and what can be changed about them.
struct State
{
  State()
    : Scene(MakeScene(MakeImage(12, TwoBoxes), MakeSoftProperty(0.8, false)))
  {
    this->Scene.Size = { { 24, 24 } };
    this->Mapper->SetMultipleScatteringToFull();
    this->Albedo->AddRGBPoint(0.0, 0.9, 0.8, 0.7);
    this->Table->AddPoint(-1.0, 0.2);
    this->Table->AddPoint(1.0, 1.0);
    this->Lamp->SetPosition(0.4, 0.6, 1.1);
    this->Lamp->SetFocalPoint(0.0, 0.0, 0.0);
    this->Lamp->PositionalOn();
    this->Lamp->SetConeAngle(40.0);
    this->Lamp->SetSize(0.2, 0.2);
    this->Scene.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  }

  /// All that is set, on another mapper.
  void CopyTo(vtkShadowedSliceMapper* mapper) const
  {
    mapper->SetMultipleScattering(this->Mapper->GetMultipleScattering());
    mapper->SetScatteringAlbedo(this->Mapper->GetScatteringAlbedo());
    mapper->SetPhaseFunction(this->Mapper->GetPhaseFunction());
    mapper->SetAnisotropy(this->Mapper->GetAnisotropy());
    mapper->SetPhaseTable(this->Mapper->GetPhaseTable());
    mapper->SetForwardSpread(this->Mapper->GetForwardSpread());
    mapper->SetBackwardLayers(this->Mapper->GetBackwardLayers());
    mapper->SetScatteringGridSize(this->Mapper->GetScatteringGridSize());
    mapper->SetScatteringBrightness(this->Mapper->GetScatteringBrightness());
    mapper->SetTransmissionColor(this->Mapper->GetTransmissionColor());
  }

  ShadowScene Scene;
  vtkNew<vtkShadowedSliceMapper> Mapper;
  vtkNew<vtkColorTransferFunction> Albedo;
  vtkNew<vtkPiecewiseFunction> Table;
  vtkNew<vtkAreaLight> Lamp;
};

struct Change
{
  std::string Name;
  std::function<void(State&)> Make;
};

/// What light depends on.
std::vector<Change> GetChanges()
{
  return {
    { "light turned", [](State& s) { s.Scene.Lights.front()->SetPosition(-0.3, 0.8, 1.0); } },
    { "light's colour", [](State& s) { s.Scene.Lights.front()->SetDiffuseColor(0.9, 0.5, 0.2); } },
    { "light's intensity", [](State& s) { s.Scene.Lights.front()->SetIntensity(0.5); } },
    { "shadow attenuation", [](State& s) { s.Scene.Lights.front()->SetShadowAttenuation(0.6); } },
    { "a second light", [](State& s) { s.Scene.Lights.push_back(s.Lamp.Get()); } },
    { "its cone", [](State& s) { s.Lamp->SetConeAngle(20.0); } },
    { "its size", [](State& s) { s.Lamp->SetSize(0.05, 0.3); } },
    { "opacity", [](State& s) { s.Scene.Property->GetScalarOpacity()->AddPoint(0.5, 0.7); } },
    { "unit distance", [](State& s) { s.Scene.Property->SetScalarOpacityUnitDistance(0.3); } },
    { "albedo", [](State& s) { s.Mapper->SetScatteringAlbedo(s.Albedo); } },
    { "albedo's points", [](State& s) { s.Albedo->AddRGBPoint(1.0, 0.3, 0.9, 1.0); } },
    { "phase", [](State& s) { s.Mapper->SetPhaseFunctionToHenyeyGreenstein(); } },
    { "anisotropy", [](State& s) { s.Mapper->SetAnisotropy(0.6); } },
    { "phase by a table",
      [](State& s)
      {
        s.Mapper->SetPhaseTable(s.Table);
        s.Mapper->SetPhaseFunctionToTable();
      } },
    { "table's points", [](State& s) { s.Table->AddPoint(0.3, 3.0); } },
    { "layers", [](State& s) { s.Mapper->SetBackwardLayers(2); } },
    { "mode", [](State& s) { s.Mapper->SetMultipleScatteringToForward(); } },
    { "spread", [](State& s) { s.Mapper->SetForwardSpread(0.2); } },
    { "cells", [](State& s) { s.Mapper->SetScatteringGridSize(8); } },
    { "clipping",
      [](State& s)
      {
        auto plane = vtkSmartPointer<vtkPlane>::New();
        plane->SetNormal(0.3, 0.2, 1.0);
        plane->SetOrigin(0.0, 0.0, -0.1);
        s.Scene.ClippingPlanes = { plane };
      } },
    { "cropping",
      [](State& s)
      {
        s.Scene.CroppingFlags = VTK_CROP_SUBVOLUME;
        s.Scene.CroppingPlanes = { { -0.4, 0.4, -0.5, 0.3, -0.5, 0.5 } };
      } },
    { "cropping's cross", [](State& s) { s.Scene.CroppingFlags = VTK_CROP_CROSS; } },
    { "voxels",
      [](State& s)
      {
        vtkDataArray* values = s.Scene.Image->GetPointData()->GetScalars();
        for (vtkIdType i = 0; i < values->GetNumberOfTuples(); i += 3)
        {
          values->SetComponent(i, 0, 0.5 * values->GetComponent(i, 0));
        }
        values->Modified();
      } },
    { "matrix", [](State& s) { s.Scene.Matrix->SetElement(0, 0, 1.5); } },
    { "light through matter", [](State& s) { s.Scene.TransmissionColor = s.Albedo; } },
  };
}

RgbaPicture DrawAnew(const State& state)
{
  vtkNew<Mapper> mapper;
  state.CopyTo(mapper);
  return DrawByMapper(mapper, state.Scene);
}

/// One change after the other: each is found once, and the picture is that of a new mapper.
void TestChanges(Check& check)
{
  State state;
  VolumeStage stage(state.Scene.Size);
  const auto draw = [&]()
  {
    SetScene(stage, state.Mapper, state.Scene);
    return stage.Capture();
  };
  RgbaPicture last = draw();
  int solves = 1;
  const auto expectSolves = [&](const std::string& name)
  {
    check.Near(
      state.Mapper->GetReport()->GetNumber("ScatteringSolves"), solves, 0.0, name + ": solves");
  };
  expectSolves("first picture");
  check.That(state.Mapper->GetReport()->GetNumber("ScatteringCells") > 100, "first picture: cells");
  check.That(
    state.Mapper->GetReport()->GetNumber("ScatteringBytes") > 1000, "first picture: bytes");
  draw();
  expectSolves("the same picture");
  check.Near(
    state.Mapper->GetReport()->GetNumber("UploadedBytes"), 0, 0.0, "the same picture: bytes sent");
  std::vector<vtkSmartPointer<vtkCamera>> cameras{ state.Scene.Camera };
  std::vector<RgbaPicture> turned;
  for (const Double3& sight :
    { Double3{ { 1.0, 0.2, -0.3 } }, Double3{ { 0.1, 1.0, 0.4 } }, Double3{ { 0.3, 0.2, 1.0 } } })
  {
    cameras.push_back(LookAt(state.Scene.Image, sight, sight[1] > 0.5));
    state.Scene.Camera = cameras.back();
    turned.push_back(draw());
    expectSolves("turned");
  }
  state.Mapper->SetImageSampleDistance(2.0);
  state.Mapper->SetSliceSpacing(0.05);
  state.Mapper->SetScatteringBrightness(0.5);
  draw();
  expectSolves("other slices, pixels and brightness");
  state.Mapper->SetScatteringBrightness(1.0);
  state.Mapper->SetImageSampleDistance(1.0);
  state.Mapper->SetSliceSpacing(0.0);
  last = draw();
  expectSolves("the same slices again");
  for (std::size_t i = 0; i < turned.size(); ++i)
  {
    State again;
    again.Scene.Camera = cameras[i + 1];
    check.Near(
      ComparePictures(turned[i], DrawAnew(again)).Max, 0.0, 0.0, "turned: as drawn anew", 1.0);
  }
  // Drawing anew by another mapper may count as a change of the data: it has a state of its own.
  State other;
  for (const Change& change : GetChanges())
  {
    change.Make(state);
    const RgbaPicture picture = draw();
    ++solves;
    expectSolves(change.Name);
    change.Make(other);
    other.Scene.Camera = state.Scene.Camera;
    const double difference = ComparePictures(picture, DrawAnew(other)).Max;
    check.Near(difference, 0.0, 0.0, change.Name + ": as drawn anew", 1.0);
    // Layers and phase functions of small anisotropy may change nothing that is seen.
    const bool maySame =
      change.Name == "layers" || change.Name == "anisotropy" || change.Name == "phase";
    check.That(maySame || ComparePictures(picture, last).Max > 0.0, change.Name + ": seen");
    last = picture;
  }
  state.Scene.Lights.clear();
  const RgbaPicture dark = draw();
  check.Near(state.Mapper->GetReport()->GetNumber("ScatteringCells"), 0, 0.0, "no light: cells");
  check.Near(state.Mapper->GetReport()->GetNumber("ScatteringBytes"), 0, 0.0, "no light: bytes");
  double light = 0.0;
  for (int i = 0; i < 24 * 24; ++i)
  {
    light += dark.At(i % 24, i / 24)[0];
  }
  check.Near(light, 0.0, 0.0, "no light: black", 1.0);
}

/// Another mapper of the same image and property, in a volume of its own, leaves the first one as
/// it is.
void TestSecondMapper(Check& check)
{
  const State state;
  VolumeStage stage(state.Scene.Size);
  SetScene(stage, state.Mapper, state.Scene);
  const RgbaPicture first = stage.Capture();
  const vtkMTimeType time = state.Scene.Property->GetMTime();
  DrawAnew(state);
  check.That(state.Scene.Property->GetMTime() > time, "second mapper: VTK counts a change");
  const double difference = ComparePictures(stage.Capture(), first).Max;
  check.Near(difference, 0.0, 0.0, "second mapper: picture", 1.0);
  check.Near(
    state.Mapper->GetReport()->GetNumber("UploadedBytes"), 0, 0.0, "second mapper: bytes sent");
  check.Near(
    state.Mapper->GetReport()->GetNumber("ScatteringSolves"), 1, 0.0, "second mapper: solves");
}

/// Changes in any order, many of them at once.
void TestRandomChanges(Check& check)
{
  std::mt19937 random(7);
  State state;
  VolumeStage stage(state.Scene.Size);
  const std::vector<Change> changes = GetChanges();
  for (int i = 0; i < 20; ++i)
  {
    for (unsigned j = 0; j <= random() % 3; ++j)
    {
      changes[random() % changes.size()].Make(state);
    }
    state.Mapper->SetMultipleScattering(static_cast<int>(random() % 4));
    state.Mapper->SetAnisotropy(0.1 * static_cast<double>(random() % 18) - 0.9);
    state.Scene.Lights.resize(1);
    state.Scene.Camera = LookAt(state.Scene.Image,
      { { 0.1 * static_cast<double>(random() % 10) - 0.5, 0.4, -1.0 } }, random() % 2 == 0);
    SetScene(stage, state.Mapper, state.Scene);
    const double difference = ComparePictures(stage.Capture(), DrawAnew(state)).Max;
    check.Near(difference, 0.0, 0.0, "random state " + std::to_string(i) + ": as drawn anew", 1.0);
  }
}

}

int TestScatteringChanges(int, char*[])
{
  Check check;
  TestChanges(check);
  TestSecondMapper(check);
  TestRandomChanges(check);
  return check.Result();
}
