// SPDX-License-Identifier: BSD-3-Clause
// Multiple scattering of vtkShadowedSliceMapper is solved again if an input has changed, and reused
// if only the view has changed.
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
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

/// A scene, a mapper and their adjustable settings.
struct State
{
  State()
    : Scene(MakeScene(MakeImage(12, TwoBoxes), MakeTranslucentProperty(0.8, false)))
  {
    this->Scene.Size = { { 24, 24 } };
    this->Mapper->SetScatteringModeToFull();
    this->Albedo->AddRGBPoint(0.0, 0.9, 0.8, 0.7);
    this->Table->AddPoint(-1.0, 0.2);
    this->Table->AddPoint(1.0, 1.0);
    this->AreaLight->SetPosition(0.4, 0.6, 1.1);
    this->AreaLight->SetFocalPoint(0.0, 0.0, 0.0);
    this->AreaLight->PositionalOn();
    this->AreaLight->SetConeAngle(40.0);
    this->AreaLight->SetSize(0.2, 0.2);
    this->Scene.Matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  }

  /// Copies all settings to another mapper.
  void CopyTo(vtkShadowedSliceMapper* mapper) const
  {
    mapper->SetScatteringMode(this->Mapper->GetScatteringMode());
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
  vtkNew<vtkAreaLight> AreaLight;
};

struct Change
{
  std::string Name;
  std::function<void(State&)> Make;
};

/// Returns the changes that affect scattered light.
std::vector<Change> GetChanges()
{
  return {
    { "light turned", [](State& s) { s.Scene.Lights.front()->SetPosition(-0.3, 0.8, 1.0); } },
    { "light's color", [](State& s) { s.Scene.Lights.front()->SetDiffuseColor(0.9, 0.5, 0.2); } },
    { "light's intensity", [](State& s) { s.Scene.Lights.front()->SetIntensity(0.5); } },
    { "shadow attenuation", [](State& s) { s.Scene.Lights.front()->SetShadowAttenuation(0.6); } },
    { "a second light", [](State& s) { s.Scene.Lights.push_back(s.AreaLight.Get()); } },
    { "its cone", [](State& s) { s.AreaLight->SetConeAngle(20.0); } },
    { "its size", [](State& s) { s.AreaLight->SetSize(0.05, 0.3); } },
    { "opacity", [](State& s) { s.Scene.Property->GetScalarOpacity()->AddPoint(0.5, 0.7); } },
    { "unit distance", [](State& s) { s.Scene.Property->SetScalarOpacityUnitDistance(0.3); } },
    { "albedo", [](State& s) { s.Mapper->SetScatteringAlbedo(s.Albedo); } },
    { "points of the albedo", [](State& s) { s.Albedo->AddRGBPoint(1.0, 0.3, 0.9, 1.0); } },
    { "phase", [](State& s) { s.Mapper->SetPhaseFunctionToHenyeyGreenstein(); } },
    { "anisotropy", [](State& s) { s.Mapper->SetAnisotropy(0.6); } },
    { "phase by a table",
      [](State& s)
      {
        s.Mapper->SetPhaseTable(s.Table);
        s.Mapper->SetPhaseFunctionToTable();
      } },
    { "points of the phase table", [](State& s) { s.Table->AddPoint(0.3, 3.0); } },
    { "layers", [](State& s) { s.Mapper->SetBackwardLayers(2); } },
    { "mode", [](State& s) { s.Mapper->SetScatteringModeToForward(); } },
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
    { "cropping to a cross", [](State& s) { s.Scene.CroppingFlags = VTK_CROP_CROSS; } },
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
    { "light through medium", [](State& s) { s.Scene.TransmissionColor = s.Albedo; } },
  };
}

RgbaImage DrawByNewMapper(const State& state)
{
  vtkNew<Mapper> mapper;
  state.CopyTo(mapper);
  return DrawByMapper(mapper, state.Scene);
}

/// After each change, the solver runs once, and the image equals the image of a new mapper.
void TestChanges(Check& check)
{
  State state;
  VolumeStage stage(state.Scene.Size);
  const auto draw = [&]()
  {
    SetScene(stage, state.Mapper, state.Scene);
    return stage.Capture();
  };
  RgbaImage last = draw();
  int solves = 1;
  const auto expectSolves = [&](const std::string& name)
  {
    check.Equal(state.Mapper->GetReport()->GetCount("ScatteringSolves"), solves, name + ": solves");
  };
  expectSolves("first image");
  check.That(state.Mapper->GetReport()->GetNumber("ScatteringCells") > 100, "first image: cells");
  check.That(state.Mapper->GetReport()->GetNumber("ScatteringBytes") > 1000, "first image: bytes");
  draw();
  expectSolves("same image");
  check.Equal(
    state.Mapper->GetReport()->GetCount("UploadedBytes"), 0, "same image: uploaded bytes");
  std::vector<vtkSmartPointer<vtkCamera>> cameras{ state.Scene.Camera };
  std::vector<RgbaImage> rotated;
  for (const Double3& direction :
    { Double3{ { 1.0, 0.2, -0.3 } }, Double3{ { 0.1, 1.0, 0.4 } }, Double3{ { 0.3, 0.2, 1.0 } } })
  {
    cameras.push_back(LookAt(state.Scene.Image, direction, direction[1] > 0.5));
    state.Scene.Camera = cameras.back();
    rotated.push_back(draw());
    expectSolves("rotated view");
  }
  state.Mapper->SetImageSampleDistance(2.0);
  state.Mapper->SetSliceSpacing(0.05);
  state.Mapper->SetScatteringBrightness(0.5);
  draw();
  expectSolves("other slice spacing, pixels and brightness");
  state.Mapper->SetScatteringBrightness(1.0);
  state.Mapper->SetImageSampleDistance(1.0);
  state.Mapper->SetSliceSpacing(0.0);
  last = draw();
  expectSolves("first slice spacing again");
  for (std::size_t i = 0; i < rotated.size(); ++i)
  {
    State again;
    again.Scene.Camera = cameras[i + 1];
    check.Near(CompareImages(rotated[i], DrawByNewMapper(again)).Max, 0.0, 0.0,
      "rotated view: same image as by a new mapper", 1.0);
  }
  // Drawing with another mapper may mark the data as modified, so the new mappers draw a second
  // scene.
  State other;
  for (const Change& change : GetChanges())
  {
    change.Make(state);
    const RgbaImage image = draw();
    ++solves;
    expectSolves(change.Name);
    change.Make(other);
    other.Scene.Camera = state.Scene.Camera;
    const double difference = CompareImages(image, DrawByNewMapper(other)).Max;
    check.Near(difference, 0.0, 0.0, change.Name + ": same image as by a new mapper", 1.0);
    // The number of layers, and phase functions with low anisotropy, might not visibly change the
    // image.
    const bool mayBeEqual =
      change.Name == "layers" || change.Name == "anisotropy" || change.Name == "phase";
    check.That(
      mayBeEqual || CompareImages(image, last).Max > 0.0, change.Name + ": visible change");
    last = image;
  }
  state.Scene.Lights.clear();
  const RgbaImage dark = draw();
  check.Equal(state.Mapper->GetReport()->GetCount("ScatteringCells"), 0, "cells without light");
  check.Equal(state.Mapper->GetReport()->GetCount("ScatteringBytes"), 0, "bytes without light");
  double light = 0.0;
  for (int i = 0; i < 24 * 24; ++i)
  {
    light += dark.At(i % 24, i / 24)[0];
  }
  check.Near(light, 0.0, 0.0, "black without light", 1.0);
}

/// A second mapper with the same vtkImageData and property, in another volume, does not affect the
/// first mapper.
void TestSecondMapper(Check& check)
{
  const State state;
  VolumeStage stage(state.Scene.Size);
  SetScene(stage, state.Mapper, state.Scene);
  const RgbaImage first = stage.Capture();
  const vtkMTimeType time = state.Scene.Property->GetMTime();
  DrawByNewMapper(state);
  check.That(state.Scene.Property->GetMTime() > time, "second mapper: VTK reports a change");
  const double difference = CompareImages(stage.Capture(), first).Max;
  check.Near(difference, 0.0, 0.0, "second mapper: same image", 1.0);
  check.Equal(
    state.Mapper->GetReport()->GetCount("UploadedBytes"), 0, "second mapper: uploaded bytes");
  check.Equal(state.Mapper->GetReport()->GetCount("ScatteringSolves"), 1, "second mapper: solves");
}

/// Random sequences of one or several changes.
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
    state.Mapper->SetScatteringMode(static_cast<int>(random() % 4));
    state.Mapper->SetAnisotropy(0.1 * static_cast<double>(random() % 18) - 0.9);
    state.Scene.Lights.resize(1);
    state.Scene.Camera = LookAt(state.Scene.Image,
      { { 0.1 * static_cast<double>(random() % 10) - 0.5, 0.4, -1.0 } }, random() % 2 == 0);
    SetScene(stage, state.Mapper, state.Scene);
    const double difference = CompareImages(stage.Capture(), DrawByNewMapper(state)).Max;
    check.Near(difference, 0.0, 0.0,
      "random state " + std::to_string(i) + ": same image as by a new mapper", 1.0);
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
