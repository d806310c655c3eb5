// SPDX-License-Identifier: BSD-3-Clause
// Smoke and surfaces under the same lights by vtkShadowedScenePass, against closed forms: what
// smoke leaves of light on a wall before, in, behind and across it, and the shadow of a plate in
// smoke.
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

// The length within a box of the way from a place along a direction of length 1, up to a distance.
double GetPath(const Vector& place, const Vector& direction, const Box& box, double most)
{
  double first = 0.0;
  double last = most;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double slope = direction[axis];
    double a = (box[2 * axis] - place[axis]) / slope;
    double b = (box[2 * axis + 1] - place[axis]) / slope;
    if (std::abs(slope) < 1e-12)
    {
      const bool isInside = place[axis] > box[2 * axis] && place[axis] < box[2 * axis + 1];
      a = isInside ? -1e9 : 1e9;
      b = 1e9;
    }
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return std::max(last - first, 0.0);
}

// A wall at a distance from the middle of the smoke, a light, and how the eye looks.
struct Case
{
  std::string Name;
  Vector Normal;
  double Distance;
  bool IsLamp;
  Vector Light;
  Vector View;
  double Bound;
  /// The diameter of a round lamp; 0 for lights without extent.
  double Diameter = 0.0;
  /// The number of lamps that shine from their centre alone.
  int HardLamps = 0;
};

// A lamp that looks at the origin.
vtkSmartPointer<vtkLight> MakeRoundLamp(const Vector& position, double diameter)
{
  vtkNew<vtkAreaLight> lamp;
  lamp->SetPositional(true);
  lamp->SetPosition(position.data());
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetConeAngle(180.0);
  lamp->SetShape(vtkAreaLight::ROUND);
  lamp->SetSize(diameter, diameter);
  return lamp;
}

// Places all over the emitter of such a lamp.
std::vector<Vector> GetEmitter(const Vector& position, double diameter)
{
  Vector first;
  Vector second;
  const Vector axis = Normalize(position);
  vtkMath::Perpendiculars(axis.data(), first.data(), second.data(), 0.0);
  std::vector<Vector> places;
  constexpr int rows = 12;
  for (int i = 0; i < rows * rows; ++i)
  {
    const double x = (i % rows + 0.5) / rows - 0.5;
    const double y = (i / rows + 0.5) / rows - 0.5;
    if (x * x + y * y < 0.25)
    {
      places.push_back(position);
      for (int k = 0; k < 3; ++k)
      {
        places.back()[k] += diameter * (x * first[k] + y * second[k]);
      }
    }
  }
  return places;
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
  // Black smoke has no light of its own.
  stage.Stage.GetVolume()->GetProperty()->SetDiffuse(0.0);
  stage.Stage.SetLights({ wall.Diameter > 0.0 ? MakeRoundLamp(wall.Light, wall.Diameter)
      : wall.IsLamp                           ? MakeLamp(wall.Light, { { 0.0, 0.0, 0.0 } })
                                              : MakeSun(wall.Light) });
  stage.LookAlong(wall.View);
  const RgbaPicture picture = stage.Draw();

  vtkCamera* camera = stage.Stage.GetRenderer()->GetActiveCamera();
  const Vector view = Normalize(wall.View);
  Vector up;
  camera->GetViewUp(up.data());
  Vector right;
  vtkMath::Cross(view.data(), up.data(), right.data());
  right = Normalize(right);
  vtkMath::Cross(right.data(), view.data(), up.data());
  const std::vector<Vector> emitter = wall.Diameter > 0.0 && wall.HardLamps == 0
    ? GetEmitter(wall.Light, wall.Diameter)
    : std::vector<Vector>();
  std::vector<double> errors;
  for (int j = 0; j < pixels; ++j)
  {
    for (int i = 0; i < pixels; ++i)
    {
      Vector place;
      const double x = ((i + 0.5) / pixels - 0.5) * size;
      const double y = ((j + 0.5) / pixels - 0.5) * size;
      for (int k = 0; k < 3; ++k)
      {
        place[k] = x * right[k] + y * up[k];
      }
      const double way = (wall.Distance - Dot(place, normal)) / Dot(view, normal);
      for (int k = 0; k < 3; ++k)
      {
        place[k] += way * view[k];
      }
      Vector toLight;
      double distance = 1e9;
      for (int k = 0; k < 3; ++k)
      {
        toLight[k] = wall.IsLamp ? wall.Light[k] - place[k] : -wall.Light[k];
      }
      if (wall.IsLamp)
      {
        distance = std::sqrt(Dot(toLight, toLight));
      }
      toLight = Normalize(toLight);
      const double facing = Dot(normal, view) < 0.0 ? 1.0 : -1.0;
      const Vector toEye{ { -view[0], -view[1], -view[2] } };
      double transmittance = 0.0;
      for (const Vector& point : emitter)
      {
        Vector way{ { point[0] - place[0], point[1] - place[1], point[2] - place[2] } };
        const double most = vtkMath::Norm(way.data());
        transmittance += std::exp(-EXTINCTION * GetPath(place, Normalize(way), SMOKE, most)) /
          static_cast<double>(emitter.size());
      }
      if (emitter.empty())
      {
        transmittance = std::exp(-EXTINCTION * GetPath(place, toLight, SMOKE, distance));
      }
      const double expected = std::max(facing * Dot(normal, toLight), 0.0) * transmittance *
        std::exp(-EXTINCTION * GetPath(place, toEye, SMOKE, 1e9));
      errors.push_back(std::abs(picture.At(i, j)[0] - expected));
    }
  }
  std::sort(errors.begin(), errors.end());
  double mean = 0.0;
  for (const double error : errors)
  {
    mean += error / static_cast<double>(errors.size());
  }
  const double most = errors[errors.size() * 95 / 100];
  vtkInterlumeReport* report = stage.GetReport();
  std::cout << wall.Name << ": mean " << mean << ", 95 % " << most << ", largest " << errors.back()
            << ", pixels " << report->GetNumber("PixelsInFrontOfVolumes") << " "
            << report->GetNumber("PixelsInsideVolumes") << " "
            << report->GetNumber("PixelsBehindVolumes") << ", passes "
            << report->GetNumber("ReceiverPasses") << ", sweeps "
            << stage.Mapper->GetReport()->GetNumber("Sweeps") << " "
            << stage.Mapper->GetReport()->GetNumber("FrontToBackSweeps") << std::endl;
  check.Near(stage.Mapper->GetReport()->GetNumber("SoftShadowLights"), wall.Diameter > 0.0 ? 1 : 0,
    0.0, wall.Name + ": lamps with an extent");
  check.Near(stage.Mapper->GetReport()->GetNumber("AreaLightsWithHardShadows"), wall.HardLamps, 0.0,
    wall.Name + ": lamps that shine from their centre");
  check.Near(most, 0.0, wall.Bound, wall.Name + ": error of 95 % of the pixels", 1.0);
  check.Near(mean, 0.0, 0.5 * wall.Bound, wall.Name + ": mean error", 1.0);
}

void TestWalls(Check& check)
{
  const Vector down{ { 0.0, 0.0, -1.0 } };
  const Vector aslant{ { 0.5, 0.2, -1.0 } };
  const Vector floor{ { 0.0, 0.0, 1.0 } };
  const Vector tilted{ { -0.8, 0.1, 0.6 } };
  const Vector against{ { 1.0, 0.1, 0.4 } };
  TestWall(check, { "before", floor, 0.5, false, aslant, down, 0.002 });
  TestWall(check, { "behind", floor, -0.5, false, aslant, down, 0.002 });
  TestWall(check, { "within", floor, 0.1, false, aslant, down, 0.002 });
  TestWall(check, { "across", tilted, 0.05, false, aslant, down, 0.002 });
  TestWall(check, { "on a face", floor, -0.3, false, aslant, down, 0.002 });
  TestWall(check, { "against the light, across", tilted, 0.05, false, against, down, 0.002 });
  TestWall(check, { "against the light, behind", tilted, 0.45, false, against, down, 0.002 });
  TestWall(check, { "lamp, across", tilted, 0.05, true, { { -1.0, 0.2, 2.0 } }, down, 0.002 });
  TestWall(
    check, { "lamp within, across", tilted, -0.1, true, { { -0.1, 0.0, 0.2 } }, down, 0.01 });
  const Vector lamp{ { -1.0, 0.2, 2.0 } };
  TestWall(check, { "round lamp, across", tilted, 0.05, true, lamp, down, 0.01, 0.4 });
  TestWall(check, { "round lamp, behind", floor, -0.5, true, lamp, down, 0.01, 0.4 });
  const Vector above{ { -0.2, 0.1, 2.0 } };
  TestWall(check, { "round lamp, far behind", floor, -3.0, true, above, down, 0.015, 0.4 });
  TestWall(check,
    { "round lamp within, across", tilted, -0.1, true, { { -0.1, 0.0, 0.2 } }, down, 0.01, 0.2,
      1 });
}

// Two volumes, which overlap or stand apart, take their light one after the other.
void TestTwoVolumes(Check& check)
{
  for (const double apart : { 0.2, 0.6 })
  {
    const Box upper{ { -0.5, 0.5, -0.4, 0.4, -0.3 + apart, 0.3 + apart } };
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
    const RgbaPicture picture = stage.Draw();
    check.Near(stage.GetReport()->GetNumber("Volumes"), 2, 0.0, "two volumes");
    for (const Vector& place :
      { Vector{ { 0.0, 0.0, -0.4 } }, Vector{ { 0.3, 0.1, -0.4 } }, Vector{ { -0.15, 0.2, -0.4 } },
        Vector{ { 0.6, 0.15, -0.4 } }, Vector{ { -0.7, 0.6, -0.4 } } })
    {
      const Vector toLight{ { -light[0], -light[1], -light[2] } };
      const Vector toEye{ { 0.0, 0.0, 1.0 } };
      const double depth = EXTINCTION *
        (GetPath(place, toLight, SMOKE, 1e9) + GetPath(place, toEye, SMOKE, 1e9) +
          0.5 * (GetPath(place, toLight, upper, 1e9) + GetPath(place, toEye, upper, 1e9)));
      check.Near(stage.At(picture, place[0], place[1]), -light[2] * std::exp(-depth), 0.005,
        "two volumes, " + std::to_string(apart) + " apart, at " + std::to_string(place[0]), 1.0);
    }
  }
}

void TestPlate(Check& check)
{
  // Light falls down, or up, on smoke whose left half a plate covers.
  for (const double side : { 1.0, -1.0 })
  {
    for (const double aside : { 0.0, -0.2 })
    {
      RgbaPicture pictures[2];
      const std::string name =
        "plate at " + std::to_string(side) + ", eye aside " + std::to_string(aside);
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
        stage.LookAlong({ { 0.0, 1.0, aside } });
        pictures[i] = stage.Draw();
        check.That(
          stage.Mapper->GetReport()->GetText("Features").find("casters") != std::string::npos,
          name + ": the volume asks for maps");
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
            dark = std::max(dark, pictures[0].At(i, j)[0]);
          }
          else if (i > 65)
          {
            lit = std::max(lit, std::abs(pictures[0].At(i, j)[0] - pictures[1].At(i, j)[0]));
            brightness = std::max(brightness, pictures[0].At(i, j)[0]);
          }
        }
      }
      check.Near(dark, 0.0, 0.0, name + ": in shadow", 1.0);
      check.Near(lit, 0.0, 1e-6, name + ": beside the shadow", 1.0);
      check.That(brightness > 0.2, name + ": lit at all");
    }
  }
}

void TestCounters(Check& check)
{
  // Smoke alone.
  SceneStage smoke(64);
  smoke.AddSmoke(SMOKE, EXTINCTION);
  smoke.Stage.SetLights({ MakeSun({ { 0.4, 0.2, -1.0 } }) });
  const RgbaPicture with = smoke.Draw();
  const auto report = CopyReport(smoke.Mapper->GetReport());
  const auto scene = CopyReport(smoke.GetReport());
  check.Near(scene->GetNumber("DepthMaps") + scene->GetNumber("CameraDepthPasses") +
      scene->GetNumber("ReceiverPasses") + scene->GetNumber("Volumes"),
    0, 0.0, "smoke alone: passes");
  check.Near(scene->GetNumber("DepthMapBytes") + scene->GetNumber("CameraDepthBytes") +
      scene->GetNumber("TransmittanceBytes"),
    0, 0.0, "smoke alone: bytes");
  const RgbaPicture without = smoke.Draw(false);
  check.Near(ComparePictures(with, without).Max, 0.0, 0.0, "smoke alone: the same picture");
  check.That(report->GetText("Features") == smoke.Mapper->GetReport()->GetText("Features") &&
      report->GetNumber("ImagePasses") == smoke.Mapper->GetReport()->GetNumber("ImagePasses") &&
      report->GetNumber("LightPasses") == smoke.Mapper->GetReport()->GetNumber("LightPasses") &&
      report->GetNumber("ImageBufferBytes") ==
        smoke.Mapper->GetReport()->GetNumber("ImageBufferBytes"),
    "smoke alone: the same work");

  // A wall alone, a wall before smoke, and a wall without light that casts shadows.
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
    const RgbaPicture picture = stage.Draw();
    vtkInterlumeReport* found = stage.GetReport();
    const std::string name = "wall " + std::to_string(i);
    check.Near(found->GetNumber("DepthMaps"), i < 2 ? 1 : 0, 0.0, name + ": maps");
    check.Near(
      found->GetNumber("CameraDepthPasses"), i == 1 ? 1 : 0, 0.0, name + ": depth of the eye");
    check.Near(found->GetNumber("Volumes"), i == 1 ? 1 : 0, 0.0, name + ": volumes");
    check.Near(found->GetNumber("PixelsInFrontOfVolumes"), i == 1 ? 64 * 64 : 0, 0.0,
      name + ": pixels before the smoke");
    check.Near(found->GetNumber("ReceiverPasses"), 0, 0.0, name + ": passes over surfaces");
    check.Near(found->GetNumber("TransmittanceBytes"), 0, 0.0, name + ": bytes of light");
    if (i == 2)
    {
      check.Near(ComparePictures(picture, stage.Draw(false)).Max, 0.0, 0.0, name + ": the same");
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
