// SPDX-License-Identifier: BSD-3-Clause
// Soft shadows of a vtkAreaLight on paint: against the mean of many lights by formula, beside a
// light without extent, and how even light is on sharp edges of dense paint.
#include "FlowDrawing.h"

#include "Support/Checks/ReferenceCheck.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

constexpr double UnitDistance = 0.1;

/// Paint between two places of u, and of v.
struct Slab
{
  std::array<double, 2> U;
  std::array<double, 2> V;
  double Alpha;
};

/// A strip that casts its shadow on a slab behind it.
const std::vector<Slab> Slabs{ { { { 0.2, 0.28 } }, { { 0.35, 0.65 } }, 0.8 },
  { { { 0.7, 0.85 } }, { { 0.0, 1.0 } }, 0.5 } };

Color4 PaintSlabs(double u, double v)
{
  double alpha = 0.0;
  for (const Slab& slab : Slabs)
  {
    const bool isIn = u > slab.U[0] && u < slab.U[1] && v > slab.V[0] && v < slab.V[1];
    alpha = isIn ? slab.Alpha : alpha;
  }
  return { { 1.0, 1.0, 1.0, alpha } };
}

/// The transmittance of the slabs from a place to a light, exactly.
double GetTransmittance(const Place3& x, const Place3& light)
{
  Place3 way;
  double length = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    way[i] = light[i] - x[i];
    length += way[i] * way[i];
  }
  length = std::sqrt(length);
  double depth = 0.0;
  for (const Slab& slab : Slabs)
  {
    const std::array<double, 2> bounds[3] = { { { -0.5, 0.5 } },
      { { slab.U[0] - 0.5, slab.U[1] - 0.5 } }, { { slab.V[0] - 0.5, slab.V[1] - 0.5 } } };
    double lower = 0.0;
    double upper = 1.0;
    for (int i = 0; i < 3; ++i)
    {
      const double a = (bounds[i][0] - x[i]) / way[i];
      const double b = (bounds[i][1] - x[i]) / way[i];
      lower = std::max(lower, std::min(a, b));
      upper = std::min(upper, std::max(a, b));
    }
    depth -= std::max(upper - lower, 0.0) * length * std::log(1.0 - slab.Alpha) / UnitDistance;
  }
  return std::exp(-depth);
}

/// The light's place; its emitter is a square across the line from there to the origin.
const Place3 LightPlace{ { 0.31, -1.7, 0.42 } };

vtkSmartPointer<vtkAreaLight> MakeLight(double size)
{
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetPosition(LightPlace[0], LightPlace[1], LightPlace[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetShapeToSquare();
  light->SetSize(size, size);
  return light;
}

FlowScene MakeScene(vtkAreaLight* light, int samples)
{
  std::vector<Place3> places;
  for (const vtkAreaLight::Sample& sample : light->GetSamples(samples))
  {
    places.push_back({ { sample.Position[0], sample.Position[1], sample.Position[2] } });
  }
  FlowScene scene;
  scene.Flow = &Uniform;
  scene.UnitDistance = UnitDistance;
  scene.Camera = LookAlong({ { -0.5, 0.6, -0.4 } });
  scene.Paint = [places](const FlowEnd& answer)
  {
    Color4 color = PaintSlabs(answer.U, answer.V);
    double light = 0.0;
    for (const Place3& place : places)
    {
      light += color[3] > 0.0
        ? GetTransmittance({ { answer.Time - 0.5, answer.U - 0.5, answer.V - 0.5 } }, place)
        : 0.0;
    }
    for (int c = 0; c < 3; ++c)
    {
      color[c] *= 0.1 + 0.9 * light / static_cast<double>(places.size());
    }
    return color;
  };
  return scene;
}

RgbaPicture Draw(vtkImplicitFlowVolumeMapper* mapper, vtkAreaLight* light, const FlowScene& scene,
  Color4 (*paint)(double, double))
{
  mapper->SetInputData(static_cast<vtkDataSet*>(MakeFlowVoxels(33, &Uniform)));
  mapper->SetInflowTexture(0, MakePaint(513, 513, paint));
  mapper->ShadowsOn();
  vtkNew<vtkVolumeProperty> property;
  SetCoefficients(property, UnitDistance, 0.1, 0.9);
  VolumeStage stage(scene.Size);
  stage.SetVolume(mapper, property);
  stage.SetCamera(scene.Camera);
  stage.SetLights({ light });
  return stage.Capture(1);
}

void TestFormula(Check& check)
{
  for (const double size : { 0.0, 0.5, 0.9 })
  {
    const vtkSmartPointer<vtkAreaLight> light = MakeLight(size);
    const FlowScene scene = MakeScene(light, size > 0.0 ? 144 : 1);
    const RgbaPicture expected = MakeFlowPicture(scene, 400);
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    const RgbaPicture found = Draw(mapper, light, scene, &PaintSlabs);
    const LightError error = CompareLight(found, expected);
    vtkInterlumeReport* report = mapper->GetReport();
    std::cout << "emitter of " << size << ": light off by " << error.Mean << " in the mean of "
              << error.Pixels << " pixels; " << report->GetNumber("LightBufferSize") << " columns, "
              << report->GetText("Features") << "\n";
    const std::string name = "emitter of " + std::to_string(size);
    check.That(error.Pixels > 100, name + " is seen");
    check.That(error.Mean <= 0.007 + 0.008 * size, name + ": off by " + std::to_string(error.Mean));
    if (size > 0.0)
    {
      // What a light without extent would be off by.
      const RgbaPicture point = Draw(mapper, MakeLight(0.0), scene, &PaintSlabs);
      const double hard = CompareLight(point, expected).Mean;
      std::cout << "a light without extent instead: off by " << hard << "\n";
      check.That(hard > 2.0 * error.Mean, name + ": softer than a light without extent");
    }
  }
}

Color4 PaintDense(double u, double)
{
  return { { 1.0, 1.0, 1.0, u > 0.25 && u < 0.35 ? 0.98 : 0.0 } };
}

/// The root mean square of how far light on a dense slab's front is from that of the finest buffer.
double GetStripes(const FlowScene& scene, int size, const RgbaPicture* finest, RgbaPicture& found)
{
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetLightBufferSize(size);
  found = Draw(mapper, MakeLight(0.0), scene, &PaintDense);
  double sum = 0.0;
  int pixels = 0;
  for (int j = 0; finest && j < scene.Size[1]; ++j)
  {
    for (int i = 0; i < scene.Size[0]; ++i)
    {
      if (finest->At(i, j)[3] > 0.95 && found.At(i, j)[3] > 0.95)
      {
        const double off = found.At(i, j)[0] - finest->At(i, j)[0];
        sum += off * off;
        ++pixels;
      }
    }
  }
  return std::sqrt(sum / std::max(pixels, 1));
}

/// Light on a sharp edge of dense paint shows the columns of the light's buffer; by itself it has
/// so many that they are faint.
void TestStripes(Check& check)
{
  FlowScene scene;
  scene.UnitDistance = UnitDistance;
  scene.Size = { { 96, 96 } };
  scene.Camera = LookAlong({ { -0.5, 0.6, -0.4 } });
  RgbaPicture finest(96, 96);
  GetStripes(scene, 512, nullptr, finest);
  RgbaPicture picture(96, 96);
  const double coarse = GetStripes(scene, 56, &finest, picture);
  const double automatic = GetStripes(scene, 0, &finest, picture);
  std::cout << "stripes of a column for each voxel " << coarse << ", by itself " << automatic
            << "\n";
  check.That(automatic < 0.65 * coarse, "stripes by itself");
  check.That(automatic < 0.02, "stripes by itself: " + std::to_string(automatic));
}
}

int TestFlowVolumeSoftShadows(int, char*[])
{
  return RunChecks({ TestFormula, TestStripes });
}
