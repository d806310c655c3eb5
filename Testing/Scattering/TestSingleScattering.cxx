// SPDX-License-Identifier: BSD-3-Clause
// Single scattering of vtkShadowedSliceMapper: albedo and phase function compared with their
// formulas, and no cost if it is off.
#include "Support/Checks/LargestError.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <iostream>
#include <string>

namespace
{

using namespace reference;
using Mapper = vtkShadowedSliceMapper;

const Double3 ViewDirection{ { -0.3, -0.4, -1.0 } };

ShadowScene BoxesScene()
{
  auto scene = MakeScene(MakeImage(16, TwoBoxes), MakeTranslucentProperty(0.7, false));
  scene.Camera = LookAt(scene.Image, ViewDirection, true);
  scene.Size = { { 32, 32 } };
  return scene;
}

/// Returns 4 pi times the Henyey-Greenstein function for a light direction and a view direction.
double GetPhase(double g, const Double3& light, const Double3& view)
{
  const double cosine =
    -vtkMath::Dot(light, view) / std::sqrt(vtkMath::Dot(light, light) * vtkMath::Dot(view, view));
  return (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
}

/// Returns the largest difference between \a a and \a factor times \a b, relative to the largest
/// value.
double GetDifference(const RgbaImage& a, const RgbaImage& b, double factor)
{
  double largest = 0.0;
  double difference = 0.0;
  for (int j = 0; j < a.Height; ++j)
  {
    for (int i = 0; i < a.Width; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double expected = factor * b.At(i, j)[k];
        reference::KeepLargest(largest, expected);
        difference = std::max(difference, std::abs(a.At(i, j)[k] - expected));
      }
    }
  }
  return largest > 0.0 ? difference / largest : 1.0;
}

/// With an isotropic phase function and the colors as albedo, the result equals lighting with
/// Diffuse 1.
void TestIsotropic(Check& check)
{
  auto scene = BoxesScene();
  scene.Property->SetAmbient(0.0);
  scene.Property->SetDiffuse(1.0);
  vtkNew<Mapper> off;
  const RgbaImage expected = DrawByMapper(off, scene);
  check.That(off->GetReport()->GetText("Features").find("scatter") == std::string::npos,
    "no shader code for scattering if it is off");
  // Material coefficients have no effect.
  scene.Property->SetAmbient(0.3);
  scene.Property->SetDiffuse(0.2);
  scene.Property->SetSpecular(0.7);
  scene.Property->ShadeOn();
  vtkNew<Mapper> single;
  single->SetScatteringModeToSingle();
  const RgbaImage found = DrawByMapper(single, scene);
  check.Near(GetDifference(found, expected, 1.0), 0.0, 1e-6,
    "isotropic scattering equals diffuse lighting", 1.0);
  check.That(single->GetReport()->GetText("Features").find("scattering") != std::string::npos,
    "shader code for scattering if it is on");
  check.Equal(
    single->GetReport()->GetCount("ScatteringCells"), 0, "single scattering has no cells");
  check.Equal(
    single->GetReport()->GetCount("ScatteringSolves"), 0, "single scattering is not solved");
  check.Equal(single->GetReport()->GetCount("TextureBytes"),
    off->GetReport()->GetCount("TextureBytes"), "single scattering has no additional textures");

  vtkNew<vtkColorTransferFunction> albedo;
  albedo->AddRGBPoint(0.0, 0.5, 0.25, 2.0);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.5, 0.25, 1.0);
  single->SetScatteringAlbedo(albedo);
  const RgbaImage withAlbedo = DrawByMapper(single, scene);
  scene.Property->SetColor(color);
  single->SetScatteringBrightness(0.25);
  check.Near(GetDifference(DrawByMapper(single, scene), withAlbedo, 0.25), 0.0, 1e-6,
    "a quarter of the brightness", 1.0);
  single->SetScatteringBrightness(1.0);
  single->SetScatteringAlbedo(nullptr);
  check.Near(GetDifference(withAlbedo, DrawByMapper(single, scene), 1.0), 0.0, 1e-6,
    "the albedo replaces the colors and is at most 1", 1.0);
}

/// If light and view directions are constant, the phase function scales the image by a constant.
void TestPhases(Check& check)
{
  const auto scene = BoxesScene();
  const Double3 direction{ { 1.0, -1.0, -1.0 } };
  vtkNew<Mapper> isotropic;
  isotropic->SetScatteringModeToSingle();
  const RgbaImage isotropicImage = DrawByMapper(isotropic, scene);
  for (const double g : { -0.99, -0.5, 0.0, 0.3, 0.85, 0.99 })
  {
    const double factor = GetPhase(g, direction, ViewDirection);
    vtkNew<Mapper> mapper;
    mapper->SetScatteringModeToSingle();
    mapper->SetPhaseFunctionToHenyeyGreenstein();
    mapper->SetAnisotropy(g);
    const std::string name = "g = " + std::to_string(g);
    const double difference = GetDifference(DrawByMapper(mapper, scene), isotropicImage, factor);
    std::cout << name << ": factor " << factor << ", largest difference " << difference
              << std::endl;
    check.Near(difference, 0.0, 2e-5, name, 1.0);
    if (std::abs(g) > 0.9)
    {
      continue;
    }
    vtkNew<vtkPiecewiseFunction> table;
    for (int i = 0; i <= 2000; ++i)
    {
      const double cosine = i / 1000.0 - 1.0;
      table->AddPoint(cosine, 3.0 * (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
    }
    mapper->SetPhaseFunctionToTable();
    mapper->SetPhaseTable(table);
    check.Near(GetDifference(DrawByMapper(mapper, scene), isotropicImage, factor), 0.0, 1e-3,
      name + " with a table", 1.0);
  }
  // Light exactly along and against the view direction, where subtraction could cancel significant
  // digits.
  for (const double sign : { -1.0, 1.0 })
  {
    auto straight = scene;
    const Double3 along{ { sign * ViewDirection[0], sign * ViewDirection[1],
      sign * ViewDirection[2] } };
    straight.Lights = { MakeDirectionalLight(along) };
    vtkNew<Mapper> mapper;
    mapper->SetScatteringModeToSingle();
    const RgbaImage straightImage = DrawByMapper(mapper, straight);
    mapper->SetPhaseFunctionToHenyeyGreenstein();
    mapper->SetAnisotropy(-0.99 * sign);
    check.Near(GetDifference(DrawByMapper(mapper, straight), straightImage, 1.99 / (0.01 * 0.01)),
      0.0, 3e-3, "peak of the phase function", 1.0);
  }
}

/// Scattering settings have no effect if scattering is off.
void TestOff(Check& check)
{
  for (const bool shade : { false, true })
  {
    auto scene = BoxesScene();
    scene.Property->SetShade(shade ? 1 : 0);
    vtkNew<Mapper> plain;
    const RgbaImage expected = DrawByMapper(plain, scene);
    vtkNew<Mapper> mapper;
    vtkNew<vtkColorTransferFunction> albedo;
    albedo->AddRGBPoint(0.0, 0.1, 0.2, 0.3);
    vtkNew<vtkPiecewiseFunction> table;
    table->AddPoint(-1.0, -1.0);
    mapper->SetScatteringAlbedo(albedo);
    mapper->SetPhaseTable(table);
    mapper->SetPhaseFunctionToTable();
    mapper->SetAnisotropy(0.7);
    mapper->SetForwardSpread(0.1);
    mapper->SetScatteringGridSize(8);
    const auto expectOff = [&](const std::string& name)
    {
      const ImageError error = CompareImages(DrawByMapper(mapper, scene), expected);
      check.That(error.Max == 0.0, name + ": the same image");
      vtkInterlumeReport* found = mapper->GetReport();
      vtkInterlumeReport* report = plain->GetReport();
      check.That(found->GetText("Features") == report->GetText("Features"),
        name + ": the same shader features");
      check.Equal(found->GetCount("TextureBytes"), report->GetCount("TextureBytes"),
        name + ": texture bytes");
      check.Equal(found->GetCount("UploadedBytes"), report->GetCount("UploadedBytes"),
        name + ": uploaded bytes");
      check.Equal(found->GetCount("ImagePasses") + found->GetCount("LightPasses"),
        report->GetCount("ImagePasses") + report->GetCount("LightPasses"), name + ": passes");
      check.Equal(found->GetCount("ScatteringCells"), 0, name + ": cells");
      check.Equal(found->GetCount("ScatteringBytes"), 0, name + ": bytes of scattered light");
      check.Equal(found->GetCount("ScatteringSolves"), 0, name + ": solves");
    };
    expectOff("off");
    table->RemoveAllPoints();
    table->AddPoint(0.0, 1.0);
    mapper->SetScatteringModeToFull();
    DrawByMapper(mapper, scene);
    check.That(mapper->GetReport()->GetNumber("ScatteringCells") > 0, "full: cells");
    mapper->SetScatteringModeToOff();
    expectOff("off again");
  }
}

}

int TestSingleScattering(int, char*[])
{
  Check check;
  TestIsotropic(check);
  TestPhases(check);
  TestOff(check);
  return check.Result();
}
