// SPDX-License-Identifier: BSD-3-Clause
// Smoke and surfaces in vtkShadowedScenePass, compared with closed forms: light on a wall in front
// of, inside, behind and across smoke, and the shadow of a plate in smoke.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace reference;
using Vector = std::array<double, 3>;
using Box = std::array<double, 6>;

constexpr double EXTINCTION = 2.0;
const Box SMOKE{ { -0.5, 0.5, -0.4, 0.4, -0.3, 0.3 } };

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector Normalize(Vector a)
{
  vtkMath::Normalize(a.data());
  return a;
}

// Returns the length of a ray inside a box, up to the distance \a limit. \a direction has length 1.
double GetPath(const Vector& position, const Vector& direction, const Box& box, double limit)
{
  double first = 0.0;
  double last = limit;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double slope = direction[axis];
    double a = (box[2 * axis] - position[axis]) / slope;
    double b = (box[2 * axis + 1] - position[axis]) / slope;
    if (std::abs(slope) < 1e-12)
    {
      const bool isInside = position[axis] > box[2 * axis] && position[axis] < box[2 * axis + 1];
      a = isInside ? -1e9 : 1e9;
      b = 1e9;
    }
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return std::max(last - first, 0.0);
}

// A wall at a distance from the center of the smoke, a light and a view direction.
struct Case
{
  std::string Name;
  Vector Normal;
  double Distance;
  bool IsPositional;
  Vector Light;
  Vector View;
  double Bound;
  /// Diameter of a round light, or 0 for lights without extent.
  double Diameter = 0.0;
  /// Expected number of area lights that are reduced to their center.
  int HardLights = 0;
};

// Returns a round light that is directed at the origin.
vtkSmartPointer<vtkLight> MakeRoundLight(const Vector& position, double diameter)
{
  vtkNew<vtkAreaLight> light;
  light->SetPositional(true);
  light->SetPosition(position.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetConeAngle(180.0);
  light->SetShape(vtkAreaLight::ROUND);
  light->SetSize(diameter, diameter);
  return light;
}

// Returns positions on the emitter of a round light.
std::vector<Vector> GetEmitter(const Vector& position, double diameter)
{
  Vector first;
  Vector second;
  const Vector axis = Normalize(position);
  vtkMath::Perpendiculars(axis.data(), first.data(), second.data(), 0.0);
  std::vector<Vector> positions;
  constexpr int rows = 12;
  for (int i = 0; i < rows * rows; ++i)
  {
    const double x = (i % rows + 0.5) / rows - 0.5;
    const double y = (i / rows + 0.5) / rows - 0.5;
    if (x * x + y * y < 0.25)
    {
      positions.push_back(position);
      for (int k = 0; k < 3; ++k)
      {
        positions.back()[k] += diameter * (x * first[k] + y * second[k]);
      }
    }
  }
  return positions;
}

void TestWall(Check& check, const Case& wall)
{
  constexpr int pixels = 128;
  constexpr double size = 1.6;
  SceneStage stage(pixels, size);
  const Vector normal = Normalize(wall.Normal);
  Vector first;
  Vector second;
  vtkMath::Perpendiculars(normal.data(), first.data(), second.data(), 0.0);
  Vector origin;
  for (int i = 0; i < 3; ++i)
  {
    first[i] *= 6.0;
    second[i] *= 6.0;
    origin[i] = wall.Distance * normal[i] - 0.5 * (first[i] + second[i]);
  }
  stage.Add(MakeRectangle(origin, first, second));
  stage.AddSmoke(SMOKE, EXTINCTION, 24);
  // Black smoke attenuates light, but scatters none.
  stage.Stage.GetVolume()->GetProperty()->SetDiffuse(0.0);
  stage.Stage.SetLights({ wall.Diameter > 0.0 ? MakeRoundLight(wall.Light, wall.Diameter)
      : wall.IsPositional                     ? MakePointLight(wall.Light, { { 0.0, 0.0, 0.0 } })
                                              : MakeSun(wall.Light) });
  stage.LookAlong(wall.View);
  const RgbaImage image = stage.Draw();

  vtkCamera* camera = stage.Stage.GetRenderer()->GetActiveCamera();
  const Vector view = Normalize(wall.View);
  Vector up;
  camera->GetViewUp(up.data());
  Vector right;
  vtkMath::Cross(view.data(), up.data(), right.data());
  right = Normalize(right);
  vtkMath::Cross(right.data(), view.data(), up.data());
  const std::vector<Vector> emitter = wall.Diameter > 0.0 && wall.HardLights == 0
    ? GetEmitter(wall.Light, wall.Diameter)
    : std::vector<Vector>();
  std::vector<double> errors;
  for (int j = 0; j < pixels; ++j)
  {
    for (int i = 0; i < pixels; ++i)
    {
      Vector position;
      const double x = ((i + 0.5) / pixels - 0.5) * size;
      const double y = ((j + 0.5) / pixels - 0.5) * size;
      for (int k = 0; k < 3; ++k)
      {
        position[k] = x * right[k] + y * up[k];
      }
      const double path = (wall.Distance - Dot(position, normal)) / Dot(view, normal);
      for (int k = 0; k < 3; ++k)
      {
        position[k] += path * view[k];
      }
      Vector toLight;
      double distance = 1e9;
      for (int k = 0; k < 3; ++k)
      {
        toLight[k] = wall.IsPositional ? wall.Light[k] - position[k] : -wall.Light[k];
      }
      if (wall.IsPositional)
      {
        distance = std::sqrt(Dot(toLight, toLight));
      }
      toLight = Normalize(toLight);
      const double facing = Dot(normal, view) < 0.0 ? 1.0 : -1.0;
      const Vector toCamera{ { -view[0], -view[1], -view[2] } };
      double transmittance = 0.0;
      for (const Vector& point : emitter)
      {
        Vector path{ { point[0] - position[0], point[1] - position[1], point[2] - position[2] } };
        const double limit = vtkMath::Norm(path.data());
        transmittance += std::exp(-EXTINCTION * GetPath(position, Normalize(path), SMOKE, limit)) /
          static_cast<double>(emitter.size());
      }
      if (emitter.empty())
      {
        transmittance = std::exp(-EXTINCTION * GetPath(position, toLight, SMOKE, distance));
      }
      const double expected = std::max(facing * Dot(normal, toLight), 0.0) * transmittance *
        std::exp(-EXTINCTION * GetPath(position, toCamera, SMOKE, 1e9));
      errors.push_back(std::abs(image.At(i, j)[0] - expected));
    }
  }
  std::sort(errors.begin(), errors.end());
  double mean = 0.0;
  for (const double error : errors)
  {
    mean += error / static_cast<double>(errors.size());
  }
  const double limit = errors[errors.size() * 95 / 100];
  vtkInterlumeReport* report = stage.GetReport();
  std::cout << wall.Name << ": mean " << mean << ", 95 % " << limit << ", largest " << errors.back()
            << ", pixels " << report->GetNumber("PixelsInFrontOfVolumes") << " "
            << report->GetNumber("PixelsInsideVolumes") << " "
            << report->GetNumber("PixelsBehindVolumes") << ", passes "
            << report->GetNumber("ReceiverPasses") << ", sweeps "
            << stage.Mapper->GetReport()->GetNumber("Sweeps") << " "
            << stage.Mapper->GetReport()->GetNumber("FrontToBackSweeps") << std::endl;
  check.Near(stage.Mapper->GetReport()->GetNumber("SoftShadowLights"), wall.Diameter > 0.0 ? 1 : 0,
    0.0, wall.Name + ": lights with soft shadows");
  check.Equal(stage.Mapper->GetReport()->GetCount("AreaLightsWithHardShadows"), wall.HardLights,
    wall.Name + ": area lights with hard shadows");
  check.Near(limit, 0.0, wall.Bound, wall.Name + ": error of 95 % of the pixels", 1.0);
  check.Near(mean, 0.0, 0.5 * wall.Bound, wall.Name + ": mean error", 1.0);
}

void TestWalls(Check& check)
{
  const Vector down{ { 0.0, 0.0, -1.0 } };
  const Vector oblique{ { 0.5, 0.2, -1.0 } };
  const Vector floor{ { 0.0, 0.0, 1.0 } };
  const Vector tilted{ { -0.8, 0.1, 0.6 } };
  const Vector opposite{ { 1.0, 0.1, 0.4 } };
  TestWall(check, { "in front", floor, 0.5, false, oblique, down, 0.002 });
  TestWall(check, { "behind", floor, -0.5, false, oblique, down, 0.002 });
  TestWall(check, { "inside", floor, 0.1, false, oblique, down, 0.002 });
  TestWall(check, { "across", tilted, 0.05, false, oblique, down, 0.002 });
  TestWall(check, { "on a face", floor, -0.3, false, oblique, down, 0.002 });
  TestWall(check, { "light opposite, across", tilted, 0.05, false, opposite, down, 0.002 });
  TestWall(check, { "light opposite, behind", tilted, 0.45, false, opposite, down, 0.002 });
  TestWall(
    check, { "point light, across", tilted, 0.05, true, { { -1.0, 0.2, 2.0 } }, down, 0.002 });
  TestWall(check,
    { "point light inside, across", tilted, -0.1, true, { { -0.1, 0.0, 0.2 } }, down, 0.01 });
  const Vector light{ { -1.0, 0.2, 2.0 } };
  TestWall(check, { "round light, across", tilted, 0.05, true, light, down, 0.01, 0.4 });
  TestWall(check, { "round light, behind", floor, -0.5, true, light, down, 0.01, 0.4 });
  const Vector above{ { -0.2, 0.1, 2.0 } };
  TestWall(check, { "round light, far behind", floor, -3.0, true, above, down, 0.015, 0.4 });
  TestWall(check,
    { "round light inside, across", tilted, -0.1, true, { { -0.1, 0.0, 0.2 } }, down, 0.01, 0.2,
      1 });
}

// The transmittances of two volumes are multiplied, whether they overlap or not.
void TestTwoVolumes(Check& check)
{
  for (const double shift : { 0.2, 0.6 })
  {
    const Box upper{ { -0.5, 0.5, -0.4, 0.4, -0.3 + shift, 0.3 + shift } };
    SceneStage stage(128, 1.6);
    stage.Add(
      MakeRectangle({ { -2.0, -2.0, -0.4 } }, { { 4.0, 0.0, 0.0 } }, { { 0.0, 4.0, 0.0 } }));
    stage.AddSmoke(SMOKE, EXTINCTION, 24);
    stage.AddSmoke(upper, 0.5 * EXTINCTION, 24);
    vtkVolumeCollection* volumes = stage.Stage.GetRenderer()->GetVolumes();
    for (int i = 0; i < 2; ++i)
    {
      vtkVolume::SafeDownCast(volumes->GetItemAsObject(i))->GetProperty()->SetDiffuse(0.0);
    }
    const Vector light = Normalize({ { 0.5, 0.2, -1.0 } });
    stage.Stage.SetLights({ MakeSun(light) });
    const RgbaImage image = stage.Draw();
    check.Equal(stage.GetReport()->GetCount("Volumes"), 2, "two volumes");
    for (const Vector& position :
      { Vector{ { 0.0, 0.0, -0.4 } }, Vector{ { 0.3, 0.1, -0.4 } }, Vector{ { -0.15, 0.2, -0.4 } },
        Vector{ { 0.6, 0.15, -0.4 } }, Vector{ { -0.7, 0.6, -0.4 } } })
    {
      const Vector toLight{ { -light[0], -light[1], -light[2] } };
      const Vector toCamera{ { 0.0, 0.0, 1.0 } };
      const double depth = EXTINCTION *
        (GetPath(position, toLight, SMOKE, 1e9) + GetPath(position, toCamera, SMOKE, 1e9) +
          0.5 * (GetPath(position, toLight, upper, 1e9) + GetPath(position, toCamera, upper, 1e9)));
      check.Near(stage.At(image, position[0], position[1]), -light[2] * std::exp(-depth), 0.005,
        "two volumes, shift " + std::to_string(shift) + ", at " + std::to_string(position[0]), 1.0);
    }
  }
}

void TestPlate(Check& check)
{
  // A black plate between the smoke and the light shadows the left half of the smoke, for light
  // from above and from below.
  for (const double side : { 1.0, -1.0 })
  {
    for (const double tilt : { 0.0, -0.2 })
    {
      RgbaImage images[2];
      const std::string name =
        "plate at " + std::to_string(side) + ", view tilt " + std::to_string(tilt);
      for (int i = 0; i < 2; ++i)
      {
        SceneStage stage(128, 1.6);
        vtkSmartPointer<vtkActor> plate =
          MakeRectangle({ { i == 0 ? -2.0 : -2.4, -1.0, 0.6 * side } },
            { { i == 0 ? 2.0 : 0.2, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } });
        plate->GetProperty()->SetDiffuse(0.0);
        stage.Add(plate);
        stage.AddSmoke(SMOKE, EXTINCTION, 24);
        stage.Stage.SetLights({ MakeSun({ { 0.0, 0.0, -side } }) });
        stage.LookAlong({ { 0.0, 1.0, tilt } });
        images[i] = stage.Draw();
        check.That(
          stage.Mapper->GetReport()->GetText("Features").find("casters") != std::string::npos,
          name + ": the volume uses shadow maps");
      }
      double dark = 0.0;
      double lit = 0.0;
      double brightness = 0.0;
      for (int j = 30; j < 98; ++j)
      {
        for (int i = 30; i < 98; ++i)
        {
          if (i < 62)
          {
            dark = std::max(dark, images[0].At(i, j)[0]);
          }
          else if (i > 65)
          {
            lit = std::max(lit, std::abs(images[0].At(i, j)[0] - images[1].At(i, j)[0]));
            brightness = std::max(brightness, images[0].At(i, j)[0]);
          }
        }
      }
      check.Near(dark, 0.0, 0.0, name + ": black in the shadow", 1.0);
      check.Near(lit, 0.0, 1e-6, name + ": unchanged outside the shadow", 1.0);
      check.That(brightness > 0.2, name + ": some light");
    }
  }
}

void TestCounters(Check& check)
{
  // If the scene contains only smoke, the pass does the same work and draws the same image as the
  // mapper alone.
  SceneStage smoke(64);
  smoke.AddSmoke(SMOKE, EXTINCTION);
  smoke.Stage.SetLights({ MakeSun({ { 0.4, 0.2, -1.0 } }) });
  const RgbaImage with = smoke.Draw();
  const auto report = CopyReport(smoke.Mapper->GetReport());
  const auto scene = CopyReport(smoke.GetReport());
  check.Equal(scene->GetCount("DepthMaps") + scene->GetCount("CameraDepthPasses") +
      scene->GetCount("ReceiverPasses") + scene->GetCount("Volumes"),
    0, "only smoke: passes");
  check.Equal(scene->GetCount("DepthMapBytes") + scene->GetCount("CameraDepthBytes") +
      scene->GetCount("TransmittanceBytes"),
    0, "only smoke: bytes");
  const RgbaImage without = smoke.Draw(false);
  check.Near(CompareImages(with, without).Max, 0.0, 0.0, "only smoke: same image");
  check.That(report->GetText("Features") == smoke.Mapper->GetReport()->GetText("Features") &&
      report->GetNumber("ImagePasses") == smoke.Mapper->GetReport()->GetNumber("ImagePasses") &&
      report->GetNumber("LightPasses") == smoke.Mapper->GetReport()->GetNumber("LightPasses") &&
      report->GetNumber("ImageBufferBytes") ==
        smoke.Mapper->GetReport()->GetNumber("ImageBufferBytes"),
    "only smoke: same work");

  // Three scenes: a wall alone, a wall with smoke, and a wall with smoke but with a light that
  // casts no shadows.
  for (int i = 0; i < 3; ++i)
  {
    SceneStage stage(64);
    stage.Add(MakeRectangle({ { -1.0, -1.0, 0.4 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }));
    if (i > 0)
    {
      stage.AddSmoke(SMOKE, EXTINCTION);
    }
    vtkSmartPointer<vtkLight> sun = MakeSun({ { 0.4, 0.2, -1.0 } });
    sun->SetShadowAttenuation(i == 2 ? 0.0F : 1.0F);
    stage.Stage.SetLights({ sun });
    const RgbaImage image = stage.Draw();
    vtkInterlumeReport* found = stage.GetReport();
    const std::string name = "wall " + std::to_string(i);
    check.Equal(found->GetCount("DepthMaps"), i < 2 ? 1 : 0, name + ": maps");
    check.Equal(
      found->GetCount("CameraDepthPasses"), i == 1 ? 1 : 0, name + ": camera depth passes");
    check.Equal(found->GetCount("Volumes"), i == 1 ? 1 : 0, name + ": volumes");
    check.Equal(found->GetCount("PixelsInFrontOfVolumes"), i == 1 ? 64 * 64 : 0,
      name + ": pixels in front of the smoke");
    check.Equal(found->GetCount("ReceiverPasses"), 0, name + ": receiver passes");
    check.Equal(found->GetCount("TransmittanceBytes"), 0, name + ": transmittance bytes");
    if (i == 2)
    {
      check.Near(CompareImages(image, stage.Draw(false)).Max, 0.0, 0.0, name + ": same image");
    }
  }
}

}

int TestShadowedMixture(int, char*[])
{
  Check check;
  TestWalls(check);
  TestTwoVolumes(check);
  TestPlate(check);
  TestCounters(check);
  return check.Result();
}
