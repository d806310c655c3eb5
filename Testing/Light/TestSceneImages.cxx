// SPDX-License-Identifier: BSD-3-Clause
// Images that vtkProjectiveLight and vtkAreaLight cast on actors in vtkShadowedScenePass. Pixels
// are compared with the colors that the lights report.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkProjectiveLight.h"
#include "vtkProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>

namespace
{
using namespace reference;

constexpr int PIXELS = 256;
constexpr double SIZE = 2.0;

// Creates a checkerboard with \a squares squares along each edge. The lighter color varies by row.
vtkSmartPointer<vtkImageData> MakeBoard(int squares)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(squares, squares, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int j = 0; j < squares; ++j)
  {
    for (int i = 0; i < squares; ++i)
    {
      auto* color = static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0));
      const bool isLight = (i + j) % 2 == 0;
      color[0] = static_cast<unsigned char>(isLight ? 255 : 40);
      color[1] = static_cast<unsigned char>(isLight ? 200 - 20 * j : 0);
      color[2] = static_cast<unsigned char>(isLight ? 30 : 220);
    }
  }
  return image;
}

vtkSmartPointer<vtkProjectiveLight> MakeProjector(bool isPositional, int squares)
{
  auto light = vtkSmartPointer<vtkProjectiveLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPositional(isPositional);
  light->SetPosition(0.7, -0.4, 2.0);
  light->SetFocalPoint(0.1, 0.05, 0.0);
  light->SetConeAngle(90.0);
  light->SetViewUp(0.2, 1.0, 0.0);
  light->SetScreenSize(1.2, 0.9);
  light->SetShadowAttenuation(1.0F);
  if (squares > 0)
  {
    light->SetImage(MakeBoard(squares));
  }
  return light;
}

// Checks the pixels of a floor at z = 0 below a projector, except at edges of squares.
void TestFloor(Check& check, vtkProjectiveLight* light, int squares, const std::string& name)
{
  SceneStage stage(PIXELS, SIZE);
  stage.Add(MakeRectangle({ { -1.5, -1.5, 0.0 } }, { { 3.0, 0.0, 0.0 } }, { { 0.0, 3.0, 0.0 } }));
  stage.Stage.SetLights({ vtkSmartPointer<vtkLight>(light) });
  const RgbaImage rendered = stage.Draw();
  check.Equal(stage.GetReport()->GetCount("Images"), 1, name + ": lights with images");

  vtkNew<vtkMatrix4x4> screen;
  light->GetScreenMatrix(screen);
  double largest = 0.0;
  double brightest = 0.0;
  int dark = 0;
  int skipped = 0;
  for (int j = 0; j < PIXELS; ++j)
  {
    for (int i = 0; i < PIXELS; ++i)
    {
      const double position[4] = { ((i + 0.5) / PIXELS - 0.5) * SIZE,
        ((j + 0.5) / PIXELS - 0.5) * SIZE, 0.0, 1.0 };
      double at[4];
      screen->MultiplyPoint(position, at);
      const std::array<double, 2> uv{ { at[0] / at[3], at[1] / at[3] } };
      // Skips pixels at the sharp edges of squares, which may have either color.
      bool isEdge = false;
      for (const double value : uv)
      {
        const double square = value * std::max(squares, 1);
        const bool isSharp =
          squares == 0 || !light->GetInterpolate() || value < 0.01 || value > 0.99;
        isEdge = isEdge ||
          (isSharp && std::abs(square - std::round(square)) < 0.01 * std::max(squares, 1));
      }
      if (isEdge)
      {
        ++skipped;
        continue;
      }
      double color[3];
      light->GetScreenColor(uv[0], uv[1], color);
      double toLight[3] = { 0.6, -0.45, 2.0 };
      if (light->GetPositional())
      {
        toLight[0] = 0.7 - position[0];
        toLight[1] = -0.4 - position[1];
      }
      const double length =
        std::sqrt(toLight[0] * toLight[0] + toLight[1] * toLight[1] + toLight[2] * toLight[2]);
      for (int k = 0; k < 3; ++k)
      {
        const double expected = color[k] * toLight[2] / length;
        reference::KeepLargest(largest, std::abs(rendered.At(i, j)[k] - expected));
        brightest = std::max(brightest, expected);
        dark += expected == 0.0 ? 1 : 0;
      }
    }
  }
  std::cout << name << ": largest error " << largest << ", brightest " << brightest << ", dark "
            << dark << ", skipped at edges " << skipped << std::endl;
  check.Near(largest, 0.0, 1e-4, name + ": colors", 1.0);
  check.That(brightest > 0.6, name + ": the screen is visible");
  check.That(dark > 1000, name + ": the floor outside the screen is black");
}

void TestProjectors(Check& check)
{
  for (const bool isPositional : { false, true })
  {
    const std::string name = isPositional ? "slide projector" : "beam";
    const auto light = MakeProjector(isPositional, 4);
    light->InterpolateOff();
    TestFloor(check, light, 4, name + ", squares");
    light->InterpolateOn();
    TestFloor(check, light, 4, name + ", interpolated");
    light->SetEdgeWidth(0.5);
    light->SetScreenOpacity(0.75);
    TestFloor(check, light, 4, name + ", a soft edge");
    // Without shadows, the light still projects its image.
    light->SetShadowAttenuation(0.0F);
    TestFloor(check, light, 4, name + ", no shadows");
    TestFloor(check, MakeProjector(isPositional, 0), 0, name + ", no image");
  }
}

// A plate casts a shadow on a floor lit by a projected image. The shadow is black, and the floor
// outside it is unchanged.
void TestShadow(Check& check)
{
  const auto light = MakeProjector(false, 4);
  RgbaImage images[2];
  for (int i = 0; i < 2; ++i)
  {
    SceneStage stage(PIXELS, SIZE);
    stage.Add(MakeRectangle({ { -1.5, -1.5, 0.0 } }, { { 3.0, 0.0, 0.0 } }, { { 0.0, 3.0, 0.0 } }));
    // The shadow is beside the plate, from x = -0.3 to x = -0.05.
    stage.Add(MakeRectangle(
      { { i == 0 ? 0.0 : -9.0, -1.0, 1.0 } }, { { 0.25, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }));
    stage.LookAlong({ { 0.0, 0.0, -1.0 } });
    stage.Stage.SetLights({ vtkSmartPointer<vtkLight>(light) });
    images[i] = stage.Draw();
  }
  double difference = 0.0;
  double brightness = 0.0;
  for (int i = 0; i < PIXELS; ++i)
  {
    const double x = ((i + 0.5) / PIXELS - 0.5) * SIZE;
    const double shadowed = images[0].At(i, PIXELS / 2)[0];
    const double lit = images[1].At(i, PIXELS / 2)[0];
    if (x > -0.28 && x < -0.07)
    {
      check.Near(shadowed, 0.0, 1e-6, "the shadow is black", 1.0);
      check.That(lit > 0.1, "the floor is lit without the plate");
    }
    else if (x < -0.32 || (x > -0.03 && x < -0.02) || x > 0.27)
    {
      difference = std::max(difference, std::abs(shadowed - lit));
      brightness = std::max(brightness, shadowed);
    }
  }
  check.Near(difference, 0.0, 1e-6, "the floor outside the shadow is unchanged", 1.0);
  check.That(brightness > 0.2, "the floor outside the shadow is lit");
}

void TestEmitter(Check& check)
{
  // The mean color of the two pixels is (1, 1/2, 0), scaled so that its brightest channel is 1.
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 1, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (int i = 0; i < 2; ++i)
  {
    image->SetScalarComponentFromDouble(i, 0, 0, 0, 1.0 - 0.5 * i);
    image->SetScalarComponentFromDouble(i, 0, 0, 1, 0.25 + 0.25 * i);
    image->SetScalarComponentFromDouble(i, 0, 0, 2, 0.0);
  }
  vtkNew<vtkAreaLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(0.0, 0.0, 2.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetSize(0.5, 0.5);
  light->SetEmitter(image);
  SceneStage stage(64);
  stage.Add(MakeRectangle({ { -2.0, -2.0, 0.0 } }, { { 4.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } }));
  stage.Stage.SetLights({ vtkSmartPointer<vtkLight>(light.Get()) });
  double color[3];
  light->GetEmitterColor(color);
  const RgbaImage rendered = stage.Draw();
  for (int k = 0; k < 3; ++k)
  {
    check.Near(rendered.At(32, 32)[k], color[k], 1e-5, "the mean color of the emitter", 1.0);
  }
  check.Equal(stage.GetReport()->GetCount("Images"), 1, "an emitter with an image");
  check.Near(stage.Draw(false).At(32, 32)[1], 1.0, 1e-5, "VTK uses the light's color");
  light->SetEmitter(nullptr);
  stage.Draw();
  check.Equal(stage.GetReport()->GetCount("Images"), 0, "an emitter without an image");
}

// A light with an invalid image does not light actors.
void TestInvalidImage(Check& check)
{
  SceneStage stage(PIXELS, SIZE);
  stage.Add(MakeRectangle({ { -1.5, -1.5, 0.0 } }, { { 3.0, 0.0, 0.0 } }, { { 0.0, 3.0, 0.0 } }));
  vtkSmartPointer<vtkProjectiveLight> light = MakeProjector(false, 0);
  stage.Stage.SetLights({ vtkSmartPointer<vtkLight>(light) });
  const double lit = stage.Draw().At(PIXELS / 2, PIXELS / 2)[0];
  check.That(lit > 0.5, "a valid light lights the floor");
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  image->AllocateScalars(VTK_FLOAT, 3);
  light->SetImage(image);
  const RgbaImage rendered = stage.Draw();
  double brightest = 0.0;
  for (int i = 0; i < PIXELS; ++i)
  {
    brightest = std::max<double>(brightest, rendered.At(i, PIXELS / 2)[1]);
  }
  check.That(brightest == 0.0, "a light with an invalid image lights nothing");
}
}

int TestSceneImages(int, char*[])
{
  Check check;
  TestProjectors(check);
  TestShadow(check);
  TestEmitter(check);
  TestInvalidImage(check);
  return check.Result();
}
