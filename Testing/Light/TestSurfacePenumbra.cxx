// SPDX-License-Identifier: BSD-3-Clause
// Soft shadows of surfaces in vtkShadowedScenePass: the penumbra of a half plane compared with its
// exact profile, for square and round lights, parallel and tilted, positional and directional.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"
#include "Support/Light/ReferencePenumbra.h"
#include "SceneStage.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace reference;

/// A half plane x < 0 at height GAP above the floor z = 0, and a light at distance GAP / Ratio from
/// its edge. The penumbra has the width WIDTH unless the light is tilted.
struct Case
{
  std::string Name;
  double Ratio = 1.0;
  bool IsRound = false;
  double Tilt = 0.0;
  int Samples = 16;
  int Resolution = 1024;
  bool IsPositional = true;
  /// Rotation of the emitter around its axis, in degrees.
  double Rotation = 0.0;
  /// Bounds of the relative width error and of the largest profile error.
  double WidthBound = 0.05;
  double ProfileBound = 0.05;
};

constexpr double GAP = 0.5;
constexpr double WIDTH = 0.2;
constexpr int PIXELS = 200;
constexpr double SIZE = 0.8;

struct Profile
{
  std::vector<double> Found;
  std::vector<double> Exact;
};

Profile MeasureProfile(const Case& half)
{
  const double angle = half.Tilt * std::acos(-1.0) / 180.0;
  const glm::dvec3 toLight(std::sin(angle), 0.0, std::cos(angle));
  // The scene is shifted such that the shadow's edge is at the center of the image.
  const double shift = GAP * std::tan(angle);
  const glm::dvec3 edge(shift, 0.0, GAP);
  const glm::dvec3 center = edge + (GAP / half.Ratio) * toLight;
  const double size = WIDTH / half.Ratio;
  SceneStage stage(PIXELS, SIZE);
  stage.Pass->SetNumberOfLightSamples(half.Samples);
  stage.Pass->SetDepthMapResolution(half.Resolution);
  stage.Add(MakeRectangle({ { -0.5, -0.5, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }));
  stage.Add(
    MakeRectangle({ { shift - 1.0, -0.5, GAP } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }));
  vtkNew<vtkAreaLight> light;
  light->SetPosition(glm::value_ptr(center));
  light->SetFocalPoint(glm::value_ptr(edge));
  light->SetPositional(half.IsPositional);
  light->SetConeAngle(180.0);
  light->SetShape(half.IsRound ? vtkAreaLight::ROUND : vtkAreaLight::SQUARE);
  light->SetSize(size, size);
  const double rotation = half.Rotation * std::acos(-1.0) / 180.0;
  const glm::dvec3 right(std::cos(angle), 0.0, -std::sin(angle));
  const glm::dvec3 across(0.0, 1.0, 0.0);
  const glm::dvec3 up = std::cos(rotation) * across - std::sin(rotation) * right;
  light->SetViewUp(glm::value_ptr(up));
  light->SetShadowAttenuation(1.0F);
  stage.Stage.SetLights({ light.Get() });
  // The near plane cuts off the half plane, so that the floor behind it is visible.
  stage.Stage.GetRenderer()->GetActiveCamera()->SetClippingRange(
    4.0 * SIZE - 0.5 * GAP, 8.0 * SIZE);
  const RgbaImage with = stage.Draw();
  const auto report = CopyReport(stage.GetReport());
  stage.Pass->ShadowsOff();
  const RgbaImage without = stage.Draw();

  ReferencePenumbra reference;
  reference.IsRound = half.IsRound;
  reference.IsPositional = half.IsPositional;
  reference.Center = center - edge;
  reference.Center.z += half.IsPositional ? GAP : 0.0;
  reference.Axes = { size * (std::cos(rotation) * right + std::sin(rotation) * across), size * up };
  reference.Height = GAP;
  Profile profile;
  for (int i = 0; i < PIXELS; ++i)
  {
    const double x = ((i + 0.5) / PIXELS - 0.5) * SIZE;
    const double lit = without.At(i, PIXELS / 2)[0];
    profile.Found.push_back(with.At(i, PIXELS / 2)[0] / lit);
    profile.Exact.push_back(reference.GetLightFraction({ x - shift, 0.5 * SIZE / PIXELS, 0.0 }));
  }
  std::cout << half.Name << ": " << report->GetNumber("SampleMaps") << " maps of "
            << report->GetNumber("SampleMapResolution") << "^2, ";
  return profile;
}

/// The left half of an emitter is red, the right half blue. Each color has the shadow of its half.
void TestColors(Check& check)
{
  constexpr double size = WIDTH;
  SceneStage stage(PIXELS, SIZE);
  stage.Pass->SetNumberOfLightSamples(64);
  stage.Add(MakeRectangle({ { -0.5, -0.5, 0.0 } }, { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }));
  stage.Add(MakeRectangle({ { -0.5, -0.5, GAP } }, { { 0.5, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }));
  vtkNew<vtkImageData> image;
  constexpr int columns = 64;
  image->SetDimensions(columns, 1, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < columns; ++i)
  {
    auto* color = static_cast<unsigned char*>(image->GetScalarPointer(i, 0, 0));
    const bool isLeft = i < columns / 2;
    color[0] = isLeft ? 255 : 0;
    color[1] = 0;
    color[2] = isLeft ? 0 : 255;
  }
  vtkNew<vtkAreaLight> light;
  light->SetPosition(0.0, 0.0, 2.0 * GAP);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetShapeToSquare();
  light->SetSize(size, size);
  light->SetEmitter(image);
  stage.Stage.SetLights({ light.Get() });
  stage.Stage.GetRenderer()->GetActiveCamera()->SetClippingRange(
    4.0 * SIZE - 0.5 * GAP, 8.0 * SIZE);
  const RgbaImage with = stage.Draw();
  stage.Pass->ShadowsOff();
  const RgbaImage without = stage.Draw();
  vtkNew<vtkMatrix4x4> matrix;
  light->GetEmitterMatrix(matrix);
  for (const int channel : { 0, 2 })
  {
    const double offset = (channel == 0 ? -0.25 : 0.25) * size * matrix->GetElement(0, 0);
    ReferencePenumbra reference;
    reference.IsRound = false;
    reference.Center = { offset, 0.0, 2.0 * GAP };
    reference.Axes = { glm::dvec3(0.5 * size, 0.0, 0.0), glm::dvec3(0.0, size, 0.0) };
    reference.Height = GAP;
    double largest = 0.0;
    for (int i = 0; i < PIXELS; ++i)
    {
      const double x = ((i + 0.5) / PIXELS - 0.5) * SIZE;
      const double found = with.At(i, PIXELS / 2)[channel] / without.At(i, PIXELS / 2)[channel];
      const double exact = reference.GetLightFraction({ x, 0.5 * SIZE / PIXELS, 0.0 });
      reference::KeepLargest(largest, std::abs(found - exact));
    }
    const std::string name = "channel " + std::to_string(channel);
    std::cout << name << " of a red and blue emitter: largest profile error " << largest
              << std::endl;
    check.Near(largest, 0.0, 0.05, name + ": profile", 1.0);
  }
}

/// Returns the width of the linear ramp whose derivative has the same variance as the derivative of
/// the profile.
double GetRampWidth(const std::vector<double>& profile)
{
  double sum = 0.0;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 1; i < profile.size(); ++i)
  {
    const double slope = profile[i] - profile[i - 1];
    const double x = static_cast<double>(i) * SIZE / PIXELS;
    sum += slope;
    first += slope * x;
    second += slope * x * x;
  }
  const double mean = first / sum;
  return std::sqrt(12.0 * std::max(second / sum - mean * mean, 0.0));
}

double TestProfile(Check& check, const Case& half)
{
  const Profile profile = MeasureProfile(half);
  double largest = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < profile.Found.size(); ++i)
  {
    const double error = std::abs(profile.Found[i] - profile.Exact[i]);
    reference::KeepLargest(largest, error);
    mean += error / static_cast<double>(profile.Found.size());
  }
  const double width = GetRampWidth(profile.Found) / GetRampWidth(profile.Exact) - 1.0;
  std::cout << "width error " << 100.0 * width << " %, largest profile error " << largest
            << ", mean " << mean << std::endl;
  check.Near(width, 0.0, half.WidthBound, half.Name + ": width", 1.0);
  check.Near(largest, 0.0, half.ProfileBound, half.Name + ": profile", 1.0);
  return mean;
}

/// A wall on the floor at x = 0, and a light slightly to one side of it. On that side, the floor
/// near the wall sees the part of the light on the same side of the wall, and the part above the
/// wall's top edge.
void TestFoot(Check& check)
{
  constexpr int pixels = 256;
  constexpr double size = 2.0;
  constexpr double lightHeight = 1.0;
  constexpr double lightSize = 0.4;
  constexpr double offset = 0.1;
  for (const double height : { 0.3, 0.6 })
  {
    for (const bool isRound : { false, true })
    {
      SceneStage stage(pixels, size);
      stage.Add(
        MakeRectangle({ { -1.0, -1.0, 0.0 } }, { { 2.0, 0.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }));
      stage.Add(
        MakeRectangle({ { 0.0, -1.0, 0.0 } }, { { 0.0, 2.0, 0.0 } }, { { 0.0, 0.0, height } }));
      vtkNew<vtkAreaLight> light;
      light->SetPosition(offset, 0.0, lightHeight);
      light->SetFocalPoint(offset, 0.0, 0.0);
      light->PositionalOn();
      light->SetConeAngle(180.0);
      light->SetShape(isRound ? vtkAreaLight::ROUND : vtkAreaLight::SQUARE);
      light->SetSize(lightSize, lightSize);
      light->SetShadowAttenuation(1.0F);
      stage.Stage.SetLights({ light.Get() });
      const RgbaImage with = stage.Draw();
      stage.Pass->ShadowsOff();
      const RgbaImage without = stage.Draw();
      double largest = 0.0;
      for (int i = pixels / 2; i < pixels / 2 + 40; ++i)
      {
        const double x = ((i + 0.5) / pixels - 0.5) * size;
        const double edge = offset + x * (lightHeight - height) / height;
        const double exact = isRound ? ReferencePenumbra::GetDiskLightFraction(edge, lightSize)
                                     : ReferencePenumbra::GetRamp(edge, lightSize);
        const double found = with.At(i, pixels / 2)[0] / without.At(i, pixels / 2)[0];
        reference::KeepLargest(largest, std::abs(found - exact));
      }
      const std::string name =
        std::string(isRound ? "round" : "square") + " light, wall height " + std::to_string(height);
      std::cout << name << ": largest error of the floor at the wall " << largest << std::endl;
      check.Near(largest, 0.0, 0.05, name + ": floor", 1.0);
    }
  }
}

}

int TestSurfacePenumbra(int, char*[])
{
  Check check;
  for (const bool isRound : { false, true })
  {
    Case half;
    half.IsRound = isRound;
    const std::string shape = isRound ? "round" : "square";
    half.ProfileBound = isRound ? 0.035 : 0.02;
    half.WidthBound = 0.015;
    for (const double ratio : { 0.05, 0.3, 1.0, 5.0 })
    {
      half.Ratio = ratio;
      half.Name = shape + ", dZ/Z " + std::to_string(ratio);
      TestProfile(check, half);
    }
    half.Ratio = 1.0;
    // With this rotation, no two samples have the same distance from the edge, but the outermost
    // samples cause visible steps in the profile.
    half.Rotation = 30.0;
    half.WidthBound = 0.06;
    half.ProfileBound = 0.07;
    half.Name = shape + ", rotated";
    TestProfile(check, half);
    half.Rotation = 0.0;
    half.WidthBound = 0.015;
    half.ProfileBound = isRound ? 0.045 : 0.03;
    half.IsPositional = false;
    half.Name = shape + ", directional";
    TestProfile(check, half);
    half.Tilt = 45.0;
    half.Name = shape + ", directional, tilted";
    TestProfile(check, half);
    half.IsPositional = true;
    half.Name = shape + ", tilted";
    TestProfile(check, half);
  }
  TestColors(check);
  TestFoot(check);
  // The profile converges with the number of samples and the resolution.
  double last = 1.0;
  for (const int samples : { 4, 16, 64, 256 })
  {
    Case half;
    half.Samples = samples;
    half.Resolution = samples == 256 ? 2048 : 1024;
    half.Name = std::to_string(samples) + " samples";
    half.WidthBound = samples == 4 ? 0.1 : 0.01;
    half.ProfileBound = samples == 4 ? 0.12 : samples == 16 ? 0.016 : 0.01;
    const double mean = TestProfile(check, half);
    check.That(mean < 0.7 * last, half.Name + ": the mean error decreases");
    last = mean;
  }
  return check.Result();
}
