// SPDX-License-Identifier: BSD-3-Clause
// Light that vtkShadowedSliceMapper scatters once: albedo and phase function against their
// formulas, and nothing of it where it is off.
#include "Support/Pictures/ShadowCases.h"
#include "Support/Drawing/ShadowPicture.h"
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

const Double3 Sight{ { -0.3, -0.4, -1.0 } };

ShadowScene BoxesScene()
{
  auto scene = MakeScene(MakeImage(16, TwoBoxes), MakeSoftProperty(0.7, false));
  scene.Camera = LookAt(scene.Image, Sight, true);
  scene.Size = { { 32, 32 } };
  return scene;
}

/// 4 pi times Henyey and Greenstein's function for light along one direction, seen along another.
double GetPhase(double g, const Double3& light, const Double3& sight)
{
  const double cosine = -vtkMath::Dot(light, sight) /
    std::sqrt(vtkMath::Dot(light, light) * vtkMath::Dot(sight, sight));
  return (1.0 - g * g) / std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
}

/// The largest difference of a from factor times b, over the largest value.
double GetDifference(const RgbaPicture& a, const RgbaPicture& b, double factor)
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
        largest = std::max(largest, expected);
        difference = std::max(difference, std::abs(a.At(i, j)[k] - expected));
      }
    }
  }
  return largest > 0.0 ? difference / largest : 1.0;
}

/// Isotropic, with the colours as albedo: what evenly scattered light of Diffuse 1 is.
void TestIsotropic(Check& check)
{
  auto scene = BoxesScene();
  scene.Property->SetAmbient(0.0);
  scene.Property->SetDiffuse(1.0);
  vtkNew<Mapper> off;
  const RgbaPicture expected = DrawByMapper(off, scene);
  check.That(off->GetReport()->GetText("Features").find("scatter") == std::string::npos,
    "no words where off");
  // Material coefficients have no part.
  scene.Property->SetAmbient(0.3);
  scene.Property->SetDiffuse(0.2);
  scene.Property->SetSpecular(0.7);
  scene.Property->ShadeOn();
  vtkNew<Mapper> single;
  single->SetMultipleScatteringToSingle();
  const RgbaPicture found = DrawByMapper(single, scene);
  check.Near(GetDifference(found, expected, 1.0), 0.0, 1e-6, "isotropic, as evenly scattered", 1.0);
  check.That(single->GetReport()->GetText("Features").find("scattering") != std::string::npos,
    "words where on");
  check.Near(single->GetReport()->GetNumber("ScatteringCells"), 0, 0.0, "single: cells");
  check.Near(single->GetReport()->GetNumber("ScatteringSolves"), 0, 0.0, "single: solves");
  check.Near(single->GetReport()->GetNumber("TextureBytes"),
    off->GetReport()->GetNumber("TextureBytes"), 0.0, "single: bytes of textures");

  vtkNew<vtkColorTransferFunction> albedo;
  albedo->AddRGBPoint(0.0, 0.5, 0.25, 2.0);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.5, 0.25, 1.0);
  single->SetScatteringAlbedo(albedo);
  const RgbaPicture withAlbedo = DrawByMapper(single, scene);
  scene.Property->SetColor(color);
  single->SetScatteringBrightness(0.25);
  check.Near(GetDifference(DrawByMapper(single, scene), withAlbedo, 0.25), 0.0, 1e-6,
    "a quarter of the brightness", 1.0);
  single->SetScatteringBrightness(1.0);
  single->SetScatteringAlbedo(nullptr);
  check.Near(GetDifference(withAlbedo, DrawByMapper(single, scene), 1.0), 0.0, 1e-6,
    "an albedo in the place of colours, at most 1", 1.0);
}

/// A phase function multiplies the picture by one number where light and sight have one direction.
void TestPhases(Check& check)
{
  const auto scene = BoxesScene();
  const Double3 direction{ { 1.0, -1.0, -1.0 } };
  vtkNew<Mapper> isotropic;
  isotropic->SetMultipleScatteringToSingle();
  const RgbaPicture even = DrawByMapper(isotropic, scene);
  for (const double g : { -0.99, -0.5, 0.0, 0.3, 0.85, 0.99 })
  {
    const double factor = GetPhase(g, direction, Sight);
    vtkNew<Mapper> mapper;
    mapper->SetMultipleScatteringToSingle();
    mapper->SetPhaseFunctionToHenyeyGreenstein();
    mapper->SetAnisotropy(g);
    const std::string name = "g = " + std::to_string(g);
    const double difference = GetDifference(DrawByMapper(mapper, scene), even, factor);
    std::cout << name << ": factor " << factor << ", off by " << difference << std::endl;
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
    check.Near(GetDifference(DrawByMapper(mapper, scene), even, factor), 0.0, 1e-3,
      name + " by a table", 1.0);
  }
  // Light straight along the view, and against it, where digits would cancel.
  for (const double sign : { -1.0, 1.0 })
  {
    auto straight = scene;
    const Double3 along{ { sign * Sight[0], sign * Sight[1], sign * Sight[2] } };
    straight.Lights = { MakeDirectionalLight(along) };
    vtkNew<Mapper> mapper;
    mapper->SetMultipleScatteringToSingle();
    const RgbaPicture evenly = DrawByMapper(mapper, straight);
    mapper->SetPhaseFunctionToHenyeyGreenstein();
    mapper->SetAnisotropy(-0.99 * sign);
    check.Near(GetDifference(DrawByMapper(mapper, straight), evenly, 1.99 / (0.01 * 0.01)), 0.0,
      3e-3, "the peak of a phase function", 1.0);
  }
}

/// What is set and not asked for leaves no trace.
void TestOff(Check& check)
{
  for (const bool shade : { false, true })
  {
    auto scene = BoxesScene();
    scene.Property->SetShade(shade ? 1 : 0);
    vtkNew<Mapper> plain;
    const RgbaPicture expected = DrawByMapper(plain, scene);
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
      const PictureError error = ComparePictures(DrawByMapper(mapper, scene), expected);
      check.That(error.Max == 0.0, name + ": the same picture");
      vtkInterlumeReport* found = mapper->GetReport();
      vtkInterlumeReport* report = plain->GetReport();
      check.That(found->GetText("Features") == report->GetText("Features"),
        name + ": the same words of shaders");
      check.Near(found->GetNumber("TextureBytes"), report->GetNumber("TextureBytes"), 0.0,
        name + ": bytes of textures");
      check.Near(found->GetNumber("UploadedBytes"), report->GetNumber("UploadedBytes"), 0.0,
        name + ": bytes sent");
      check.Near(found->GetNumber("ImagePasses") + found->GetNumber("LightPasses"),
        report->GetNumber("ImagePasses") + report->GetNumber("LightPasses"), 0.0,
        name + ": passes");
      check.Near(found->GetNumber("ScatteringCells"), 0, 0.0, name + ": cells");
      check.Near(found->GetNumber("ScatteringBytes"), 0, 0.0, name + ": bytes of scattered light");
      check.Near(found->GetNumber("ScatteringSolves"), 0, 0.0, name + ": solves");
    };
    expectOff("off");
    table->RemoveAllPoints();
    table->AddPoint(0.0, 1.0);
    mapper->SetMultipleScatteringToFull();
    DrawByMapper(mapper, scene);
    check.That(mapper->GetReport()->GetNumber("ScatteringCells") > 0, "full: cells");
    mapper->SetMultipleScatteringToOff();
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
