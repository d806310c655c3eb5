// SPDX-License-Identifier: BSD-3-Clause
// Shadows of vtkImplicitFlowVolumeMapper: light compared with a formula, slices compared with ray
// casting, no cost without shadows, and images after many changes.
#include "FlowDrawing.h"

#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceRandom.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr double UnitDistance = 0.1;

/// A red slab and a white slab, both parallel to the flow.
Color4 Slabs(double u, double)
{
  const bool isFirst = u > 0.25 && u < 0.35;
  const bool isSecond = u > 0.6 && u < 0.75;
  return { { 0.9, isFirst ? 0.3 : 0.9, isFirst ? 0.2 : 0.9,
    isFirst ? 0.6 : (isSecond ? 0.4 : 0.0) } };
}

/// A spot whose opacity falls off smoothly.
Color4 Spot(double u, double v)
{
  const double r = std::hypot(u - 0.5, v - 0.45) / 0.25;
  return { { u, 0.8, v, 0.5 * std::exp(-r * r) } };
}

using ColorFunction = Color4 (*)(double, double);

double ExtinctionOf(ColorFunction color, const Position3& x)
{
  for (const double coordinate : x)
  {
    if (std::abs(coordinate) > 0.5)
    {
      return 0.0;
    }
  }
  return -std::log(1.0 - color(x[1] + 0.5, x[2] + 0.5)[3]) / UnitDistance;
}

/// Returns the transmittance from \a x to a light. \a light is its position or, for a directional
/// light, the direction to it.
double GetTransmittance(
  ColorFunction color, const Position3& x, const Position3& light, bool isPositional)
{
  Position3 path = light;
  for (int i = 0; i < 3 && isPositional; ++i)
  {
    path[i] -= x[i];
  }
  const double length = std::sqrt(path[0] * path[0] + path[1] * path[1] + path[2] * path[2]);
  const double reach = isPositional ? std::min(length, 1.8) : 1.8;
  const int steps = 300;
  double depth = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    Position3 at = x;
    for (int c = 0; c < 3; ++c)
    {
      at[c] += path[c] / length * reach * (i + 0.5) / steps;
    }
    depth += ExtinctionOf(color, at) * reach / steps;
  }
  return std::exp(-depth);
}

vtkSmartPointer<vtkLight> MakeLight(const Position3& position, bool isPositional)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPositional(isPositional);
  light->SetConeAngle(90.0);
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  return light;
}

struct Case
{
  std::string Name;
  ColorFunction Color;
  Position3 Light;
  bool IsPositional;
  Position3 ViewDirection;
  /// Upper bounds of the mean light error: with default settings, and with finer slices and light
  /// buffers.
  double Mean;
  double Fine;
};

void TestFormula(Check& check)
{
  const std::vector<Case> cases{
    { "slabs, seen across", &Slabs, { { 0.0, -2.0, 0.0 } }, false, { { -1.0, 0.0, 0.1 } }, 0.0078,
      0.004 },
    { "slabs, oblique view", &Slabs, { { 0.3, -2.0, 0.5 } }, false, { { -0.5, 0.6, -0.4 } }, 0.0045,
      0.0027 },
    { "slabs, lit from behind", &Slabs, { { 0.2, 2.0, -0.3 } }, false, { { -0.6, -0.7, 0.3 } },
      0.0045, 0.002 },
    { "slabs, a point light outside", &Slabs, { { 0.2, -1.2, 0.1 } }, true, { { -0.6, 0.5, 0.3 } },
      0.003, 0.0021 },
    { "slabs, a point light inside", &Slabs, { { 0.1, -0.02, 0.05 } }, true, { { -0.6, 0.5, 0.3 } },
      0.0055, 0.0031 },
    { "spot", &Spot, { { 0.4, -1.0, 0.8 } }, false, { { -0.5, 0.6, -0.4 } }, 4.5e-4, 2.5e-4 },
  };
  for (const Case& one : cases)
  {
    FlowScene scene;
    scene.Flow = &Uniform;
    scene.UnitDistance = UnitDistance;
    scene.Camera = LookAlong(one.ViewDirection);
    scene.Paint = [&one](const FlowEnd& end)
    {
      Color4 color = one.Color(end.U, end.V);
      const double light = color[3] > 0.0 ? 0.1 +
          0.9 *
            GetTransmittance(one.Color, { { end.Time - 0.5, end.U - 0.5, end.V - 0.5 } }, one.Light,
              one.IsPositional)
                                          : 0.0;
      for (int c = 0; c < 3; ++c)
      {
        color[c] *= light;
      }
      return color;
    };
    const RgbaImage expected = MakeFlowReferenceImage(scene, 400);
    for (const bool isFine : { false, true })
    {
      vtkNew<vtkImplicitFlowVolumeMapper> mapper;
      mapper->SetInputData(static_cast<vtkDataSet*>(MakeFlowVoxels(33, &Uniform)));
      mapper->SetInflowTexture(0, MakePaint(513, 129, one.Color));
      mapper->ShadowsOn();
      mapper->SetLightBufferSize(isFine ? 256 : 0);
      mapper->SetSampleDistance(isFine ? 0.004 : 0.0);
      vtkNew<vtkVolumeProperty> property;
      SetCoefficients(property, UnitDistance, 0.1, 0.9);
      VolumeStage stage(scene.Size);
      stage.SetVolume(mapper, property);
      stage.SetCamera(scene.Camera);
      stage.SetLights({ MakeLight(one.Light, one.IsPositional) });
      const RgbaImage found = stage.Capture();
      const LightError error = CompareLight(found, expected);
      vtkInterlumeReport* report = mapper->GetReport();
      const std::string name = one.Name + (isFine ? ", finer" : "");
      std::cout << name << ": mean light error " << error.Mean << ", largest " << error.Largest
                << ", in " << error.Pixels << " pixels; image error "
                << CompareImages(found, expected) << "; " << report->GetNumber("Slices")
                << " slices in " << report->GetNumber("Sweeps") << " sweeps, buffer "
                << report->GetNumber("LightBufferSize") << "\n";
      check.That(error.Pixels > 100, name + " is visible");
      const double bound = isFine ? one.Fine : one.Mean;
      check.That(error.Mean <= bound, name + ": mean light error " + std::to_string(error.Mean));
      check.Equal(report->GetCount("ShadowedLights"), 1, name + ": lights with shadows");
      check.Equal(report->GetCount("LightBuffers"), 1, name + ": buffers");
    }
  }
}

/// A fixture with a directional light, and a point light that is off.
struct Fixture : FlowFixture
{
  Fixture()
    : Lights{ MakeLight({ { 0.3, 2.0, 0.4 } }, false), MakeLight({ { 0.5, 0.2, 1.0 } }, true) }
  {
    SetCoefficients(this->Property, UnitDistance, 0.2, 0.8);
    this->Mapper->SetInflowTexture(0, MakeStripes(20.0, 0.2));
    this->Lights[1]->SwitchOff();
    this->Stage.SetLights(this->Lights);
  }

  void Apply(const State& state) override
  {
    this->FlowFixture::Apply(state);
    this->Mapper->SetInflowTexture(0, state[0] > 0.5 ? MakeStripes(30.0 * state[0], 0.4) : nullptr);
    this->Mapper->SetInflowTexture(8, state[1] > 0.5 ? MakeStripes(7.0, state[1]) : nullptr);
    this->Mapper->SetShadows(state[2] > 0.3);
    for (int i = 0; i < 2; ++i)
    {
      vtkLight* light = this->Lights[i];
      light->SetPosition(2.0 * state[3 + i] - 1.0, 1.0 - state[4 + i], 0.9);
      light->SetShadowAttenuation(state[5 + i] > 0.5 ? static_cast<float>(state[5 + i]) : 0.0F);
      light->SetSwitch(state[7 + i] > 0.3);
    }
    this->Property->SetSpecular(state[12]);
  }

  std::vector<vtkSmartPointer<vtkLight>> Lights;
};

bool Has(vtkInterlumeReport* report, const std::string& word)
{
  return (" " + report->GetText("Features") + " ").find(" " + word + " ") != std::string::npos;
}

/// Shadows that are off, or that no light casts, need no resources.
void TestUnusedShadows(Check& check)
{
  Fixture never;
  const RgbaImage plain = never.Stage.Capture();
  Fixture fixture;
  const auto expectNothing = [&](const std::string& what)
  {
    const RgbaImage image = fixture.Stage.Capture();
    vtkInterlumeReport* report = fixture.Mapper->GetReport();
    check.That(CompareImages(image, plain).Max == 0.0, what + ": the image");
    check.Equal(report->GetCount("Passes"), 1, what + ": passes");
    check.Equal(report->GetCount("Slices") + report->GetCount("LightBuffers") +
        report->GetCount("ShadowedLights"),
      0, what + ": slices, buffers and lights");
    check.That(
      report->GetNumber("LightBufferBytes") == 0 && report->GetNumber("SliceSpacing") == 0.0,
      what + ": bytes");
    check.That(report->GetText("Features") == "splits surfaces paint_filter",
      what + ": " + report->GetText("Features"));
  };
  expectNothing("off");
  fixture.Mapper->ShadowsOn();
  fixture.Lights[0]->SetShadowAttenuation(0.0F);
  expectNothing("no light casts shadows");
  fixture.Lights[0]->SetShadowAttenuation(1.0F);
  fixture.Lights[0]->SwitchOff();
  expectNothing("no light");
  fixture.Lights[0]->SwitchOn();
  fixture.Draw();
  vtkInterlumeReport* report = fixture.Mapper->GetReport();
  check.That(Has(report, "shadow") && Has(report, "matter"), "on: " + report->GetText("Features"));
  check.That(
    report->GetNumber("Passes") == 0 && report->GetNumber("Slices") > 10, "slices are drawn");
  check.Equal(report->GetCount("LightBuffers"), 1, "one light buffer");
  const int uploads = report->GetNumber("GridUploads") + report->GetNumber("InflowUploads");
  check.Equal(uploads, 0, "the textures are reused");
  check.That(report->GetNumber("UploadedBytes") == 0, "turning shadows on uploads nothing");
  fixture.Lights[0]->SetPosition(1.0, 1.0, 0.5);
  check.That(fixture.Draw()->GetNumber("UploadedBytes") == 0, "moving a light uploads nothing");
  fixture.Mapper->SetInflowTexture(0, MakeStripes(5.0, 0.4));
  fixture.Draw();
  check.Equal(fixture.Mapper->GetReport()->GetCount("InflowUploads"), 1,
    "another inflow texture is uploaded");
  check.Equal(fixture.Mapper->GetReport()->GetCount("GridUploads"), 0,
    "another inflow texture does not upload voxels");
  fixture.Lights[1]->SwitchOn();
  check.Equal(fixture.Draw()->GetCount("LightBuffers"), 2, "one light buffer per light");
  fixture.Mapper->SetLightBufferSize(32);
  check.Equal(fixture.Draw()->GetCount("LightBufferSize"), 32, "the size of light buffers");
}

/// Tests an error of slice rendering, and hardware selection while shadows are on.
void TestOthers(Check& check)
{
  Fixture fixture;
  fixture.Mapper->ShadowsOn();
  fixture.Draw();
  const vtkIdType bytes = fixture.Mapper->GetReport()->GetNumber("TextureBytes");
  fixture.Mapper->SetMaximumTextureMemory(bytes + 1000);
  check.Contains(CaptureErrors(fixture.Mapper, [&]() { fixture.Draw(); }), "MaximumTextureMemory");
  fixture.Mapper->SetMaximumTextureMemory(0);
  check.That(CaptureErrors(fixture.Mapper, [&]() { fixture.Draw(); }).empty(),
    "there is no error without the limit");
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(fixture.Stage.GetRenderer());
  selector->SetArea(0, 0, 39, 39);
  check.That(selector->CaptureBuffers(), "the selection succeeds");
  const unsigned int center[2] = { 20, 20 };
  check.That(selector->GetPixelInformation(center, 0).Prop == fixture.Stage.GetVolume(),
    "the volume is selected");
  check.Equal(fixture.Draw()->GetCount("LightBuffers"), 1, "shadows after a selection");
}

/// Slices and ray casting must yield the same image with purely ambient light, and with shading by
/// lights whose shadows are negligible.
void TestRaysAndSlices(Check& check)
{
  Random random(5);
  double largest = 0.0;
  for (int change = 0; change < 14; ++change)
  {
    FlowFixture::State values;
    std::generate(values.begin(), values.end() - 1, [&]() { return random.Get(0.0, 1.0); });
    // Filters textures only in parallel projection, for which the error bound was measured.
    values[16] = values[15];
    const bool isShaded = change % 2 == 1;
    values[12] = isShaded ? 1.0 : 0.0;
    // Enables a shading array, without which only slices are lit.
    values[10] = isShaded ? 1.0 : values[10];
    Fixture sliced;
    sliced.Apply(values);
    SetCoefficients(sliced.Property, UnitDistance, isShaded ? 0.2 : 1.0, isShaded ? 0.5 : 0.0);
    sliced.Property->SetSpecular(isShaded ? 0.4 : 0.0);
    sliced.Property->SetSpecularPower(5.0);
    for (vtkLight* light : sliced.Lights)
    {
      light->SwitchOn();
      light->SetShadowAttenuation(isShaded ? 1e-6F : 1.0F);
    }
    sliced.Mapper->SetSampleDistance(0.01);
    sliced.Mapper->ShadowsOff();
    const RgbaImage rays = sliced.Stage.Capture();
    check.Equal(
      sliced.Mapper->GetReport()->GetCount("Passes"), 1, "the image is drawn by ray casting");
    sliced.Mapper->ShadowsOn();
    const RgbaImage slices = sliced.Stage.Capture();
    check.Equal(sliced.Mapper->GetReport()->GetCount("Passes"), 0, "the image is drawn by slices");
    const ImageError error = CompareImages(slices, rays);
    std::cout << "slices and rays, " << sliced.Mapper->GetReport()->GetText("Features") << ": "
              << error << "\n";
    check.That(error.Mean <= 1.1e-3, "slices and rays: mean error " + std::to_string(error.Mean));
    reference::KeepLargest(largest, LargestAlpha(rays));
  }
  check.That(largest > 0.2, "some image is not empty");
}

/// The image after many changes must equal that of a new mapper.
void TestRandom(Check& check)
{
  int shadowed = 0;
  CheckRandomStates([] { return std::make_unique<Fixture>(); },
    [&](vtkInterlumeReport* report) { shadowed += report->GetNumber("LightBuffers") > 0 ? 1 : 0; },
    check);
  check.That(
    shadowed > 5 && shadowed < 20, "states with and without shadows: " + std::to_string(shadowed));
}
}

int TestFlowVolumeShadows(int, char*[])
{
  return RunChecks({ TestFormula, TestUnusedShadows, TestOthers, TestRaysAndSlices, TestRandom });
}
