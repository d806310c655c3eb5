// SPDX-License-Identifier: BSD-3-Clause
// Soft shadows of a vtkAreaLight in the volume, compared with a formula for many point lights and
// with hard shadows. Also measures stripes on sharp edges of dense texture.
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

/// A dense region of the texture, given by ranges of u and v.
struct Slab
{
  std::array<double, 2> U;
  std::array<double, 2> V;
  double Alpha;
};

/// A strip that casts its shadow on a slab behind it.
const std::vector<Slab> Slabs{ { { { 0.2, 0.28 } }, { { 0.35, 0.65 } }, 0.8 },
  { { { 0.7, 0.85 } }, { { 0.0, 1.0 } }, 0.5 } };

Color4 GetSlabColor(double u, double v)
{
  double alpha = 0.0;
  for (const Slab& slab : Slabs)
  {
    const bool isIn = u > slab.U[0] && u < slab.U[1] && v > slab.V[0] && v < slab.V[1];
    alpha = isIn ? slab.Alpha : alpha;
  }
  return { { 1.0, 1.0, 1.0, alpha } };
}

/// Returns the exact transmittance of the slabs from a point to a light.
double GetTransmittance(const Position3& x, const Position3& light)
{
  Position3 path;
  double length = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    path[i] = light[i] - x[i];
    length += path[i] * path[i];
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
      const double a = (bounds[i][0] - x[i]) / path[i];
      const double b = (bounds[i][1] - x[i]) / path[i];
      lower = std::max(lower, std::min(a, b));
      upper = std::min(upper, std::max(a, b));
    }
    depth -= std::max(upper - lower, 0.0) * length * std::log(1.0 - slab.Alpha) / UnitDistance;
  }
  return std::exp(-depth);
}

/// Position of the light. Its square emitter faces the origin.
const Position3 LightPosition{ { 0.31, -1.7, 0.42 } };

vtkSmartPointer<vtkAreaLight> MakeLight(double size)
{
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetPosition(LightPosition[0], LightPosition[1], LightPosition[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetShapeToSquare();
  light->SetSize(size, size);
  return light;
}

FlowScene MakeScene(vtkAreaLight* light, int samples)
{
  std::vector<Position3> positions;
  for (const vtkAreaLight::Sample& sample : light->GetSamples(samples))
  {
    positions.push_back({ { sample.Position[0], sample.Position[1], sample.Position[2] } });
  }
  FlowScene scene;
  scene.Flow = &Uniform;
  scene.UnitDistance = UnitDistance;
  scene.Camera = LookAlong({ { -0.5, 0.6, -0.4 } });
  scene.Paint = [positions](const FlowEnd& end)
  {
    Color4 color = GetSlabColor(end.U, end.V);
    double light = 0.0;
    for (const Position3& position : positions)
    {
      light += color[3] > 0.0
        ? GetTransmittance({ { end.Time - 0.5, end.U - 0.5, end.V - 0.5 } }, position)
        : 0.0;
    }
    for (int c = 0; c < 3; ++c)
    {
      color[c] *= 0.1 + 0.9 * light / static_cast<double>(positions.size());
    }
    return color;
  };
  return scene;
}

RgbaImage Draw(vtkImplicitFlowVolumeMapper* mapper, vtkAreaLight* light, const FlowScene& scene,
  Color4 (*color)(double, double))
{
  mapper->SetInputData(static_cast<vtkDataSet*>(MakeFlowVoxels(33, &Uniform)));
  mapper->SetInflowTexture(0, MakePaint(513, 513, color));
  mapper->ShadowsOn();
  vtkNew<vtkVolumeProperty> property;
  SetCoefficients(property, UnitDistance, 0.1, 0.9);
  VolumeStage stage(scene.Size);
  stage.SetVolume(mapper, property);
  stage.SetCamera(scene.Camera);
  stage.SetLights({ light });
  return stage.Capture();
}

void TestFormula(Check& check)
{
  for (const double size : { 0.0, 0.5, 0.9 })
  {
    const vtkSmartPointer<vtkAreaLight> light = MakeLight(size);
    const FlowScene scene = MakeScene(light, size > 0.0 ? 144 : 1);
    const RgbaImage expected = MakeFlowReferenceImage(scene, 400);
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    const RgbaImage found = Draw(mapper, light, scene, &GetSlabColor);
    const LightError error = CompareLight(found, expected);
    vtkInterlumeReport* report = mapper->GetReport();
    std::cout << "emitter of size " << size << ": mean light error " << error.Mean << " in "
              << error.Pixels << " pixels; " << report->GetNumber("LightBufferSize") << " columns, "
              << report->GetText("Features") << "\n";
    const std::string name = "emitter of size " + std::to_string(size);
    check.That(error.Pixels > 100, name + " is visible");
    check.That(error.Mean <= 0.007 + 0.008 * size,
      name + ": mean light error " + std::to_string(error.Mean));
    if (size > 0.0)
    {
      // For comparison, the error of a point light.
      const RgbaImage point = Draw(mapper, MakeLight(0.0), scene, &GetSlabColor);
      const double hard = CompareLight(point, expected).Mean;
      std::cout << "a light without extent instead: mean light error " << hard << "\n";
      check.That(hard > 2.0 * error.Mean, name + ": closer than hard shadows");
    }
  }
}

Color4 GetDenseColor(double u, double)
{
  return { { 1.0, 1.0, 1.0, u > 0.25 && u < 0.35 ? 0.98 : 0.0 } };
}

/// Draws a dense slab and returns the root mean square difference from the image with the finest
/// light buffer.
double GetStripes(const FlowScene& scene, int size, const RgbaImage* finest, RgbaImage& found)
{
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetLightBufferSize(size);
  found = Draw(mapper, MakeLight(0.0), scene, &GetDenseColor);
  double sum = 0.0;
  int pixels = 0;
  for (int j = 0; finest && j < scene.Size[1]; ++j)
  {
    for (int i = 0; i < scene.Size[0]; ++i)
    {
      if (finest->At(i, j)[3] > 0.95 && found.At(i, j)[3] > 0.95)
      {
        const double difference = found.At(i, j)[0] - finest->At(i, j)[0];
        sum += difference * difference;
        ++pixels;
      }
    }
  }
  return std::sqrt(sum / std::max(pixels, 1));
}

/// Columns of the light buffer may be visible as stripes at sharp edges of a dense texture. With
/// the default buffer size, the stripes must be faint.
void TestStripes(Check& check)
{
  FlowScene scene;
  scene.UnitDistance = UnitDistance;
  scene.Size = { { 96, 96 } };
  scene.Camera = LookAlong({ { -0.5, 0.6, -0.4 } });
  RgbaImage finest(96, 96);
  GetStripes(scene, 512, nullptr, finest);
  RgbaImage image(96, 96);
  const double coarse = GetStripes(scene, 56, &finest, image);
  const double automatic = GetStripes(scene, 0, &finest, image);
  std::cout << "stripes with one column per voxel: " << coarse
            << ", with the default size: " << automatic << "\n";
  check.That(automatic < 0.65 * coarse, "the default size has weaker stripes");
  check.That(automatic < 0.02, "stripes with the default size: " + std::to_string(automatic));
}
}

int TestFlowVolumeSoftShadows(int, char*[])
{
  return RunChecks({ TestFormula, TestStripes });
}
