// SPDX-License-Identifier: BSD-3-Clause
// The shadows of vtkImplicitFlowVolumeMapper: what paint takes from light against its formula, the
// same paint by slices as by lines of sight, what there is without shadows, and pictures after many
// changes.
#include "FlowDrawing.h"

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

/// Two slabs along the flow, a red one and a white one.
Color4 Slabs(double u, double)
{
  const bool isFirst = u > 0.25 && u < 0.35;
  const bool isSecond = u > 0.6 && u < 0.75;
  return { { 0.9, isFirst ? 0.3 : 0.9, isFirst ? 0.2 : 0.9,
    isFirst ? 0.6 : (isSecond ? 0.4 : 0.0) } };
}

/// A spot that is thinner and thicker smoothly.
Color4 Spot(double u, double v)
{
  const double r = std::hypot(u - 0.5, v - 0.45) / 0.25;
  return { { u, 0.8, v, 0.5 * std::exp(-r * r) } };
}

using Paint = Color4 (*)(double, double);

double ExtinctionOf(Paint paint, const Place3& x)
{
  for (const double coordinate : x)
  {
    if (std::abs(coordinate) > 0.5)
    {
      return 0.0;
    }
  }
  return -std::log(1.0 - paint(x[1] + 0.5, x[2] + 0.5)[3]) / UnitDistance;
}

/// The transmittance of paint from a place to a light at a place, or far away along a direction.
double GetTransmittance(Paint paint, const Place3& x, const Place3& light, bool isPositional)
{
  Place3 way = light;
  for (int i = 0; i < 3 && isPositional; ++i)
  {
    way[i] -= x[i];
  }
  const double length = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
  const double reach = isPositional ? std::min(length, 1.8) : 1.8;
  const int steps = 300;
  double depth = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    Place3 at = x;
    for (int c = 0; c < 3; ++c)
    {
      at[c] += way[c] / length * reach * (i + 0.5) / steps;
    }
    depth += ExtinctionOf(paint, at) * reach / steps;
  }
  return std::exp(-depth);
}

vtkSmartPointer<vtkLight> MakeLight(const Place3& place, bool isPositional)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPositional(isPositional);
  light->SetConeAngle(90.0);
  light->SetPosition(place[0], place[1], place[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  return light;
}

struct Case
{
  std::string Name;
  Paint Painted;
  Place3 Light;
  bool IsPositional;
  Place3 Sight;
  /// Bounds of the mean error of light, as it comes and with finer slices and buffers.
  double Mean;
  double Fine;
};

void TestFormula(Check& check)
{
  const std::vector<Case> cases{
    { "slabs, seen across", &Slabs, { { 0.0, -2.0, 0.0 } }, false, { { -1.0, 0.0, 0.1 } }, 0.0078,
      0.004 },
    { "slabs, seen aslant", &Slabs, { { 0.3, -2.0, 0.5 } }, false, { { -0.5, 0.6, -0.4 } }, 0.0045,
      0.0027 },
    { "slabs, lit from behind", &Slabs, { { 0.2, 2.0, -0.3 } }, false, { { -0.6, -0.7, 0.3 } },
      0.0045, 0.002 },
    { "slabs, a lamp beside", &Slabs, { { 0.2, -1.2, 0.1 } }, true, { { -0.6, 0.5, 0.3 } }, 0.003,
      0.0021 },
    { "slabs, a lamp within", &Slabs, { { 0.1, -0.02, 0.05 } }, true, { { -0.6, 0.5, 0.3 } },
      0.0055, 0.0031 },
    { "spot", &Spot, { { 0.4, -1.0, 0.8 } }, false, { { -0.5, 0.6, -0.4 } }, 4.5e-4, 2.5e-4 },
  };
  for (const Case& one : cases)
  {
    FlowScene scene;
    scene.Flow = &Uniform;
    scene.UnitDistance = UnitDistance;
    scene.Camera = LookAlong(one.Sight);
    scene.Paint = [&one](const FlowEnd& answer)
    {
      Color4 color = one.Painted(answer.U, answer.V);
      const double light = color[3] > 0.0 ? 0.1 +
          0.9 *
            GetTransmittance(one.Painted, { { answer.Time - 0.5, answer.U - 0.5, answer.V - 0.5 } },
              one.Light, one.IsPositional)
                                          : 0.0;
      for (int c = 0; c < 3; ++c)
      {
        color[c] *= light;
      }
      return color;
    };
    const RgbaPicture expected = MakeFlowPicture(scene, 400);
    for (const bool isFine : { false, true })
    {
      vtkNew<vtkImplicitFlowVolumeMapper> mapper;
      mapper->SetInputData(static_cast<vtkDataSet*>(MakeFlowVoxels(33, &Uniform)));
      mapper->SetInflowTexture(0, MakePaint(513, 129, one.Painted));
      mapper->ShadowsOn();
      mapper->SetLightBufferSize(isFine ? 256 : 0);
      mapper->SetSampleDistance(isFine ? 0.004 : 0.0);
      vtkNew<vtkVolumeProperty> property;
      SetCoefficients(property, UnitDistance, 0.1, 0.9);
      VolumeStage stage(scene.Size);
      stage.SetVolume(mapper, property);
      stage.SetCamera(scene.Camera);
      stage.SetLights({ MakeLight(one.Light, one.IsPositional) });
      const RgbaPicture found = stage.Capture(1);
      const LightError error = CompareLight(found, expected);
      vtkInterlumeReport* report = mapper->GetReport();
      const std::string name = one.Name + (isFine ? ", finer" : "");
      std::cout << name << ": light off by " << error.Mean << " in the mean, " << error.Largest
                << " at most, in " << error.Pixels << " pixels; picture by "
                << ComparePictures(found, expected) << "; " << report->GetNumber("Slices")
                << " slices in " << report->GetNumber("Sweeps") << " sweeps, buffer "
                << report->GetNumber("LightBufferSize") << "\n";
      check.That(error.Pixels > 100, name + " is seen");
      const double bound = isFine ? one.Fine : one.Mean;
      check.That(error.Mean <= bound, name + ": off by " + std::to_string(error.Mean));
      check.Near(report->GetNumber("ShadowedLights"), 1, 0.0, name + ": lights with shadows");
      check.Near(report->GetNumber("LightBuffers"), 1, 0.0, name + ": buffers");
    }
  }
}

/// A show of paint under a light far away and a lamp, which is off.
struct Show : FlowShow
{
  Show()
    : Lights{ MakeLight({ { 0.3, 2.0, 0.4 } }, false), MakeLight({ { 0.5, 0.2, 1.0 } }, true) }
  {
    SetCoefficients(this->Property, UnitDistance, 0.2, 0.8);
    this->Mapper->SetInflowTexture(0, MakeStripes(20.0, 0.2));
    this->Lights[1]->SwitchOff();
    this->Stage.SetLights(this->Lights);
  }

  void Apply(const State& state) override
  {
    this->FlowShow::Apply(state);
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

/// What there is of shadows where they are off or no light asks for them: nothing.
void TestPay(Check& check)
{
  Show never;
  const RgbaPicture plain = never.Stage.Capture();
  Show show;
  const auto expectNothing = [&](const std::string& what)
  {
    const RgbaPicture picture = show.Stage.Capture();
    vtkInterlumeReport* report = show.Mapper->GetReport();
    check.That(ComparePictures(picture, plain).Max == 0.0, what + ": the picture");
    check.Near(report->GetNumber("Passes"), 1, 0.0, what + ": passes");
    check.Near(report->GetNumber("Slices") + report->GetNumber("LightBuffers") +
        report->GetNumber("ShadowedLights"),
      0, 0.0, what + ": parts");
    check.That(
      report->GetNumber("LightBufferBytes") == 0 && report->GetNumber("SliceSpacing") == 0.0,
      what + ": bytes");
    check.That(report->GetText("Features") == "splits surfaces paint_filter",
      what + ": " + report->GetText("Features"));
  };
  expectNothing("off");
  show.Mapper->ShadowsOn();
  show.Lights[0]->SetShadowAttenuation(0.0F);
  expectNothing("no light that asks");
  show.Lights[0]->SetShadowAttenuation(1.0F);
  show.Lights[0]->SwitchOff();
  expectNothing("no light");
  show.Lights[0]->SwitchOn();
  show.Draw();
  vtkInterlumeReport* report = show.Mapper->GetReport();
  check.That(Has(report, "shadow") && Has(report, "matter"), "on: " + report->GetText("Features"));
  check.That(report->GetNumber("Passes") == 0 && report->GetNumber("Slices") > 10, "slices");
  check.Near(report->GetNumber("LightBuffers"), 1, 0.0, "a buffer");
  const int uploads = report->GetNumber("GridUploads") + report->GetNumber("InflowUploads");
  check.Equal(uploads, 0, "the same textures as before");
  check.That(report->GetNumber("UploadedBytes") == 0, "nothing is sent for shadows alone");
  show.Lights[0]->SetPosition(1.0, 1.0, 0.5);
  check.That(
    show.Draw()->GetNumber("UploadedBytes") == 0, "nothing is sent for a light that moves");
  show.Mapper->SetInflowTexture(0, MakeStripes(5.0, 0.4));
  show.Draw();
  check.Near(show.Mapper->GetReport()->GetNumber("InflowUploads"), 1, 0.0, "another image");
  check.Near(
    show.Mapper->GetReport()->GetNumber("GridUploads"), 0, 0.0, "voxels beside another image");
  show.Lights[1]->SwitchOn();
  check.Near(show.Draw()->GetNumber("LightBuffers"), 2, 0.0, "a buffer for each light");
  show.Mapper->SetLightBufferSize(32);
  check.Near(show.Draw()->GetNumber("LightBufferSize"), 32, 0.0, "the size of buffers");
}

/// What goes wrong with slices is the mapper's error, and a selection is drawn without them.
void TestOthers(Check& check)
{
  Show show;
  show.Mapper->ShadowsOn();
  show.Draw();
  const vtkIdType bytes = show.Mapper->GetReport()->GetNumber("TextureBytes");
  show.Mapper->SetMaximumTextureMemory(bytes + 1000);
  check.Contains(ErrorsOf(show.Mapper, [&]() { show.Draw(); }), "MaximumTextureMemory");
  show.Mapper->SetMaximumTextureMemory(0);
  check.That(ErrorsOf(show.Mapper, [&]() { show.Draw(); }).empty(), "no error any more");
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(show.Stage.GetRenderer());
  selector->SetArea(0, 0, 39, 39);
  check.That(selector->CaptureBuffers(), "a selection");
  const unsigned int middle[2] = { 20, 20 };
  check.That(selector->GetPixelInformation(middle, 0).Prop == show.Stage.GetVolume(), "the volume");
  check.Near(show.Draw()->GetNumber("LightBuffers"), 1, 0.0, "shadows after a selection");
}

/// Slices show the paint that lines of sight show under light that takes no part, and the same
/// shading where next to nothing is taken from light.
void TestRoutes(Check& check)
{
  Random random(5);
  double largest = 0.0;
  for (int change = 0; change < 14; ++change)
  {
    FlowShow::State values;
    std::generate(values.begin(), values.end() - 1, [&]() { return random.Get(0.0, 1.0); });
    // Paint is filtered along parallel lines of sight.
    values[16] = values[15];
    const bool isShaded = change % 2 == 1;
    values[12] = isShaded ? 1.0 : 0.0;
    // An array to shade by: without one only slices are lit.
    values[10] = isShaded ? 1.0 : values[10];
    Show sliced;
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
    const RgbaPicture sights = sliced.Stage.Capture(1);
    check.Near(sliced.Mapper->GetReport()->GetNumber("Passes"), 1, 0.0, "lines of sight");
    sliced.Mapper->ShadowsOn();
    const RgbaPicture slices = sliced.Stage.Capture(1);
    check.Near(sliced.Mapper->GetReport()->GetNumber("Passes"), 0, 0.0, "slices");
    const PictureError error = ComparePictures(slices, sights);
    std::cout << "two routes, " << sliced.Mapper->GetReport()->GetText("Features") << ": " << error
              << "\n";
    check.That(error.Mean <= 1.1e-3, "two routes: off by " + std::to_string(error.Mean));
    largest = std::max(largest, LargestAlpha(sights));
  }
  check.That(largest > 0.2, "something is seen");
}

/// A picture after many changes is that of a mapper made anew.
void TestRandom(Check& check)
{
  int shadowed = 0;
  CheckRandomStates([] { return std::make_unique<Show>(); },
    [&](vtkInterlumeReport* report) { shadowed += report->GetNumber("LightBuffers") > 0 ? 1 : 0; },
    check);
  check.That(
    shadowed > 5 && shadowed < 20, "with and without shadows: " + std::to_string(shadowed));
}
}

int TestFlowVolumeShadows(int, char*[])
{
  return RunChecks({ TestFormula, TestPay, TestOthers, TestRoutes, TestRandom });
}
