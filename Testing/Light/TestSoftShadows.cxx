// SPDX-License-Identifier: BSD-3-Clause
// Soft shadows of area lights: the penumbra of a half plane compared with the exact ramp, sample
// layers compared with one light per sample, and no cost without soft shadows.
#include "Light/ShadowComparison.h"
#include "Support/Checks/LargestError.h"
#include "Support/Images/HalfPlane.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Light/ReferencePenumbra.h"

#include "vtkAreaLight.h"
#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

namespace
{

using namespace reference;
using Mapper = vtkShadowedSliceMapper;

vtkSmartPointer<vtkAreaLight> MakeAreaLight(
  const Double3& position, double size, int shape = vtkAreaLight::SQUARE, bool positional = true)
{
  auto light = vtkSmartPointer<vtkAreaLight>::New();
  light->SetPosition(position.data());
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPositional(positional);
  light->SetConeAngle(180.0);
  light->SetShape(shape);
  light->SetSize(size, size);
  return light;
}

/// Distance of the half plane from the receiver, and width of the volume that contains both.
constexpr double Gap = 0.5;
constexpr double Width = 0.5;

/// Returns the x coordinate of value \a i of a profile. The center of the image is at x = 0.
double GetPosition(std::size_t i)
{
  return (static_cast<double>(i) - 57.5) * GetHalfPlanePixelWidth();
}

double GetRamp(double x, double width)
{
  return width > 0.0 ? ReferencePenumbra::GetRamp(x, width) : x > 0.0 ? 1.0 : 0.0;
}

/// Returns the distance by which the lit part of a profile extends past the lit part of the ramp.
double GetShift(const std::vector<double>& profile, double width)
{
  double shift = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    shift += (profile[i] - GetRamp(GetPosition(i), width)) * GetHalfPlanePixelWidth();
  }
  return shift;
}

/// Returns the fraction of the light that passes the half plane. The profile is divided by the
/// profile without an occluder, since the receiver is not uniformly lit.
std::vector<double> GetVisibleFraction(
  double ratio, double width, const std::function<void(Mapper*)>& set, vtkInterlumeReport* report)
{
  const auto draw = [&](const ShadowScene& plane)
  {
    vtkNew<Mapper> mapper;
    set(mapper);
    const std::vector<double> profile = GetPenumbra(DrawByMapper(mapper, plane));
    if (report)
    {
      report->DeepCopy(mapper->GetReport());
    }
    return profile;
  };
  const ShadowScene open = MakeHalfPlane(ratio, width);
  vtkPiecewiseFunction* opacity = open.Property->GetScalarOpacity();
  opacity->AddPoint(0.6, 0.0);
  opacity->AddPoint(1.0, 0.0);
  const std::vector<double> lit = draw(open);
  std::vector<double> profile = draw(MakeHalfPlane(ratio, width));
  std::transform(profile.begin(), profile.end(), lit.begin(), profile.begin(), std::divides<>());
  return profile;
}

void TestHalfPlane(Check& check)
{
  constexpr double width = 0.2;
  for (const double ratio : { 0.05, 1.0, 5.0 })
  {
    double lastError = 1.0;
    double lastLargest = 1.0;
    for (const int size : { 128, 256 })
    {
      const auto set = [size](Mapper* mapper)
      {
        mapper->SetLightBufferSize(size);
        mapper->SetNumberOfLightSamples(size == 128 ? 16 : 32);
      };
      vtkNew<vtkInterlumeReport> report;
      const auto profile = GetVisibleFraction(ratio, width, set, report);
      const double error = GetRampWidth(profile) / width - 1.0;
      const double fit = FitRampWidth(profile) / width - 1.0;
      // The profile is compared with a ramp that is shifted to the profile's edge. This edge must
      // coincide with the edge of the hard shadow.
      const double shift = GetShift(profile, width);
      const double hardShift = GetShift(GetVisibleFraction(ratio, 0.0, set, nullptr), 0.0);
      double largest = 0.0;
      for (std::size_t i = 0; i < profile.size(); ++i)
      {
        const double x = GetPosition(i) + shift;
        reference::KeepLargest(largest, std::abs(profile[i] - GetRamp(x, width)));
      }
      const std::string name =
        "half plane, dZ/Z " + std::to_string(ratio) + ", buffer of " + std::to_string(size) + "^2";
      std::cout << name << ": width error " << 100.0 * error << " %, fitted width error "
                << 100.0 * fit << " %, largest profile error " << largest << ", edge shift "
                << (shift - hardShift) / Width * size << " texels, "
                << report->GetNumber("LightLayers") << " layers, "
                << report->GetNumber("SoftShadowPasses") << " passes for "
                << report->GetNumber("LightPasses") << std::endl;
      check.Near(error, 0.0, 0.05, name + ": width", 1.0);
      check.Near(fit, 0.0, 0.05, name + ": fitted width", 1.0);
      check.Near(largest, 0.0, size == 128 ? 0.035 : 0.015, name + ": profile", 1.0);
      // Below 2 %, the positions of the slab batches dominate the error of the width.
      check.That(std::abs(error) < std::max(lastError, 0.02) && largest < 0.8 * lastLargest,
        name + ": width and profile converge");
      lastError = std::abs(error);
      lastLargest = largest;
      check.Near((shift - hardShift) / Width * size, 0.0, 1.1,
        name + ": shift from the edge of hard shadows, in texels", 1.0);
    }
  }
}

/// Errors of a half plane's penumbra: relative error of the width, root mean square error of the
/// profile after aligning its edge, and signed relative error of the best-fitting ramp width.
struct PenumbraError
{
  double Width = 0.0;
  double Profile = 0.0;
  double Fit = 0.0;
};

/// Returns the errors if slices, texels and light samples are refined by a factor of \a steps.
PenumbraError MeasureHalfPlane(double ratio, double width, int steps)
{
  const auto set = [steps](Mapper* mapper)
  {
    mapper->SetLightBufferSize(64 * steps);
    mapper->SetNumberOfLightSamples(8 * steps);
    mapper->SetSliceSpacing(Gap / (86.0 * steps));
  };
  const std::vector<double> profile = GetVisibleFraction(ratio, width, set, nullptr);
  const double shift = GetShift(profile, width);
  PenumbraError error;
  error.Width = std::abs(GetRampWidth(profile) / width - 1.0);
  error.Fit = FitRampWidth(profile) / width - 1.0;
  for (std::size_t i = 0; i < profile.size(); ++i)
  {
    const double difference = profile[i] - GetRamp(GetPosition(i) + shift, width);
    error.Profile += difference * difference / static_cast<double>(profile.size());
  }
  error.Profile = std::sqrt(error.Profile);
  return error;
}

/// The profile converges to the ramp while slices, texels and samples are refined together.
void TestRefinement(Check& check)
{
  constexpr double width = 0.2;
  for (const double ratio : { 0.05, 1.0, 5.0 })
  {
    PenumbraError first;
    PenumbraError last;
    for (const int steps : { 2, 4, 8 })
    {
      last = MeasureHalfPlane(ratio, width, steps);
      first = steps == 2 ? last : first;
      std::cout << "half plane, dZ/Z " << ratio << ", steps of 1/" << steps << ": width error "
                << 100.0 * last.Width << " %, fit " << 100.0 * last.Fit << " %, profile error "
                << last.Profile << std::endl;
    }
    const double order = 0.5 * std::log2(first.Profile / last.Profile);
    std::cout << "half plane, dZ/Z " << ratio << ": order " << order << std::endl;
    const std::string name = "half plane, dZ/Z " + std::to_string(ratio);
    check.That(order > 0.7 || last.Profile < 0.004,
      name + ": order of the profile, " + std::to_string(order));
    check.Near(last.Width, 0.0, 0.012, name + ": width with the finest steps", 1.0);
    check.Near(last.Fit, 0.0, 0.02, name + ": fitted width with the finest steps", 1.0);
  }
}

/// Tests penumbras that are only a few texels wide. Interpolating between layers and averaging them
/// would widen a penumbra of 4 texels by two thirds, and a penumbra of 6 texels by a quarter.
void TestNarrow(Check& check)
{
  constexpr int size = 128;
  for (const auto& [texels, bound] : { std::pair<double, double>{ 3.0, 0.45 }, { 4.0, 0.17 },
         { 6.0, 0.07 }, { 8.0, 0.08 }, { 12.0, 0.07 } })
  {
    const PenumbraError error = MeasureHalfPlane(0.05, texels * Width / size, size / 64);
    std::cout << "penumbra of " << texels << " texels: width error " << 100.0 * error.Width
              << " %, fit " << 100.0 * error.Fit << " %, profile error " << error.Profile
              << std::endl;
    check.Near(error.Width, 0.0, bound, "narrow penumbra: width", 1.0);
  }
}

/// Compares square and round lights, upright or tilted by 45 degrees, with the exact visible
/// fraction of a rectangle or disk.
void TestShapes(Check& check)
{
  constexpr double width = 0.2;
  constexpr int size = 256;
  const auto draw = [](const ShadowScene& plane)
  {
    vtkNew<Mapper> mapper;
    mapper->SetLightBufferSize(size);
    mapper->SetNumberOfLightSamples(32);
    return GetPenumbra(DrawByMapper(mapper, plane));
  };
  const double hardShift = GetShift(draw(MakeHalfPlane(1.0, 0.0)), 0.0);
  for (const bool isRound : { false, true })
  {
    for (const bool isTilted : { false, true })
    {
      const ShadowScene plane = MakeHalfPlane(1.0, width);
      auto* light = vtkAreaLight::SafeDownCast(plane.Lights.front());
      light->SetShape(isRound ? vtkAreaLight::ROUND : vtkAreaLight::SQUARE);
      const double tilt = isTilted ? std::sqrt(0.5) : 0.0;
      const double upright = isTilted ? std::sqrt(0.5) : 1.0;
      light->SetFocalPoint(Gap * tilt, 0.0, Gap - Gap * upright);
      const ReferencePenumbra exact{ isRound, { 0.0, 0.0, Gap }, true,
        { width * glm::dvec3(upright, 0.0, tilt), glm::dvec3(0.0, 0.01 * width, 0.0) }, 0.0 };
      const std::vector<double> profile = draw(plane);
      double largest = 0.0;
      double mean = 0.0;
      for (std::size_t i = 0; i < profile.size(); ++i)
      {
        const double x = GetPosition(i) + hardShift;
        const double error = std::abs(profile[i] - exact.GetLightFraction({ x, 0.0, -Gap }));
        reference::KeepLargest(largest, error);
        mean += error / static_cast<double>(profile.size());
      }
      const std::string name =
        std::string(isTilted ? "tilted " : "") + (isRound ? "disk" : "square");
      std::cout << name << ": largest profile error " << largest << ", mean " << mean << std::endl;
      check.Near(largest, 0.0, 0.03, name + ": profile", 1.0);
      check.Near(mean, 0.0, 0.008, name + ": mean of the profile", 1.0);
    }
  }
}

/// With ACCUMULATED_CONVOLUTION, the published method, the blur grows only with the square root of
/// the number of convolutions. The penumbra is narrower than the exact penumbra, and narrows
/// further with finer buffers.
void TestConvolution(Check& check)
{
  double last = 1.0;
  for (const int size : { 64, 256 })
  {
    constexpr double width = 0.2;
    vtkNew<Mapper> mapper;
    mapper->SetSoftShadowMethodToAccumulatedConvolution();
    mapper->SetLightBufferSize(size);
    const auto profile = GetPenumbra(DrawByMapper(mapper, MakeHalfPlane(1.0, width)));
    const double fraction = GetRampWidth(profile) / width;
    vtkInterlumeReport* report = mapper->GetReport();
    std::cout << "convolution in a buffer of " << size << "^2: " << fraction << " of the width, "
              << report->GetNumber("SoftShadowPasses") << " passes" << std::endl;
    check.That(fraction < 0.9 * last, "convolution: the width decreases with finer buffers");
    check.Near(fraction, size == 64 ? 0.488 : 0.166, 0.015, "convolution: width", 1.0);
    check.That(report->GetNumber("SoftShadowPasses") > 0 && report->GetNumber("LightLayers") == 0,
      "convolution: passes");
    check.Equal(report->GetCount("SoftShadowBytes"), 4 * size * size, "convolution: bytes");
    last = fraction;
  }
}

ShadowScene BoxesScene(vtkLight* light)
{
  auto scene = MakeScene(MakeImage(24, TwoBoxes), MakeTranslucentProperty(0.8, false));
  scene.Lights = { light };
  scene.Size = { { 48, 48 } };
  return scene;
}

/// Compares SAMPLE_LAYERS with SAMPLED_LIGHTS for the same samples, with different lights and
/// scenes.
void TestSamples(Check& check)
{
  const auto compare = [&check](const std::string& name, const ShadowScene& scene, int sweeps)
  {
    vtkNew<Mapper> layers;
    layers->SetNumberOfLightSamples(16);
    vtkNew<Mapper> sampled;
    sampled->SetSoftShadowMethodToSampledLights();
    sampled->SetNumberOfLightSamples(16);
    const RgbaImage image = DrawByMapper(layers, scene);
    ExpectSimilar(check, name, image, DrawByMapper(sampled, scene), { 0.021, 0.0005 });
    check.Equal(layers->GetReport()->GetCount("Sweeps"), sweeps, name + ": sweeps of layers");
    check.Equal(layers->GetReport()->GetCount("AreaLightsWithHardShadows"), 0,
      name + ": lights without layers");
    check.That(
      layers->GetReport()->GetNumber("SoftShadowPasses") > 0, name + ": passes over layers");
    vtkNew<Mapper> hard;
    ShadowScene point = scene;
    for (vtkSmartPointer<vtkLight>& light : point.Lights)
    {
      auto other = vtkSmartPointer<vtkLight>::New();
      other->DeepCopy(light);
      other->SetShadowAttenuation(1.0);
      light = other;
    }
    const ImageError error = CompareImages(image, DrawByMapper(hard, point));
    std::cout << name << ": difference from hard shadows: largest " << error.Max << ", mean "
              << error.Mean << "\n";
    check.That(error.Mean > (name == "light behind" ? 0.0002 : 0.0004),
      name + ": differs from hard shadows");
  };
  const Double3 front{ { -2.0, 2.0, 2.0 } };
  compare("square light", BoxesScene(MakeAreaLight(front, 1.5)), 1);
  compare("round light", BoxesScene(MakeAreaLight(front, 1.5, vtkAreaLight::ROUND)), 1);
  compare("round light, far", BoxesScene(MakeAreaLight(front, 1.5, vtkAreaLight::ROUND, false)), 1);
  compare("light behind", BoxesScene(MakeAreaLight({ { -1.0, 1.5, -1.8 } }, 1.2)), 1);
  auto scene = BoxesScene(MakeAreaLight({ { -1.0, 1.0, 1.0 } }, 0.6));
  scene.TransmissionColor = vtkSmartPointer<vtkColorTransferFunction>::New();
  scene.TransmissionColor->AddRGBPoint(0.0, 1.0, 0.5, 0.2);
  compare("colored transmission", scene, 1);
  scene = BoxesScene(MakeAreaLight(front, 1.5));
  scene.Lights.push_back(MakeAreaLight({ { 1.0, 1.0, -2.5 } }, 1.2));
  compare("two lights", scene, 2);
  scene = BoxesScene(MakeAreaLight(front, 1.5));
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.3);
  plane->SetNormal(0.0, 0.1, -1.0);
  scene.ClippingPlanes = { plane.Get() };
  compare("clipping plane", scene, 1);
}

/// An area light of size 0 results in the same image as a light without extent, and requires no
/// work for soft shadows.
void TestPoint(Check& check)
{
  for (const int method :
    { Mapper::ACCUMULATED_CONVOLUTION, Mapper::SAMPLE_LAYERS, Mapper::SAMPLED_LIGHTS })
  {
    const Double3 position{ { -1.0, 1.0, 1.5 } };
    vtkNew<Mapper> area;
    area->SetSoftShadowMethod(method);
    const RgbaImage found = DrawByMapper(area, BoxesScene(MakeAreaLight(position, 0.0)));
    vtkNew<Mapper> hard;
    auto light = MakePositionalLight(position);
    light->SetIntensity(1.0);
    const RgbaImage expected = DrawByMapper(hard, BoxesScene(light));
    check.Near(CompareImages(found, expected).Max, 0.0, 0.0, "frame with a light of size 0");
    vtkInterlumeReport* a = area->GetReport();
    vtkInterlumeReport* b = hard->GetReport();
    check.Equal(a->GetCount("SoftShadowLights"), 0, "soft shadow lights with a light of size 0");
    check.That(
      a->GetText("SoftShadowMethod").empty() && a->GetText("Features") == b->GetText("Features"),
      "features with a light of size 0");
    check.Equal(a->GetCount("LightPasses"), b->GetCount("LightPasses"),
      "light passes with a light of size 0");
    check.Equal(a->GetCount("OcclusionPasses"), b->GetCount("OcclusionPasses"),
      "occlusion passes with a light of size 0");
    check.Equal(a->GetCount("LightBufferBytes"), b->GetCount("LightBufferBytes"),
      "light buffer bytes with a light of size 0");
    check.Equal(
      a->GetCount("LightLayers") + a->GetCount("SampledLights") + a->GetCount("SoftShadowPasses"),
      0, "layers with a light of size 0");
    check.Equal(a->GetCount("SoftShadowBytes"), 0, "bytes of layers with a light of size 0");
  }
}

/// An area light inside the volume is reduced to its center, or replaced with one light per sample
/// if the method is SAMPLED_LIGHTS. The report contains the numbers of both kinds of lights.
void TestInside(Check& check)
{
  const Double3 inside{ { 0.1, 0.1, 0.1 } };
  vtkNew<Mapper> mapper;
  mapper->SetNumberOfLightSamples(2);
  const RgbaImage found = DrawByMapper(mapper, BoxesScene(MakeAreaLight(inside, 0.2)));
  check.Equal(mapper->GetReport()->GetCount("SoftShadowLights"), 1, "inside: soft shadow lights");
  check.Equal(mapper->GetReport()->GetCount("AreaLightsWithHardShadows"), 1,
    "inside: lights with hard shadows");
  check.Equal(mapper->GetReport()->GetCount("SampledLights"), 0, "inside: no sampled lights");
  const RgbaImage expected = DrawByMapper(mapper, BoxesScene(MakeAreaLight(inside, 0.0)));
  check.Near(CompareImages(found, expected).Max, 0.0, 0.0, "inside: image of hard shadows");
  mapper->SetSoftShadowMethodToSampledLights();
  DrawByMapper(mapper, BoxesScene(MakeAreaLight(inside, 0.2)));
  check.Equal(mapper->GetReport()->GetCount("AreaLightsWithHardShadows"), 0,
    "inside: no hard shadows with sampled lights");
  check.Equal(mapper->GetReport()->GetCount("SampledLights"), 2, "inside: sampled lights");
  check.Equal(mapper->GetReport()->GetCount("ShadowedLights"), 1, "inside: lights with shadows");
  check.Equal(mapper->GetReport()->GetCount("LightBuffers"), 2, "inside: buffers");
  mapper->SetSoftShadowMethodToSampleLayers();
  DrawByMapper(mapper, BoxesScene(MakeAreaLight({ { -1.0, 1.0, 1.5 } }, 0.5)));
  vtkInterlumeReport* report = mapper->GetReport();
  check.Equal(report->GetCount("LightLayers"), 2, "outside: layers");
  check.Equal(report->GetCount("LightBuffers"), 1, "outside: buffers");
  const int texels = report->GetNumber("LightBufferSize") * report->GetNumber("LightBufferSize");
  check.Equal(report->GetCount("SoftShadowBytes"), 3 * 4 * texels + 3 * texels,
    "outside: bytes of three batches, two layers and their mean");
  check.That(report->GetText("SoftShadowMethod") == "SampleLayers", "outside: method");
  check.That(report->GetNumber("SoftShadowPasses") <= 4 * report->GetNumber("LightPasses"),
    "outside: passes over layers");
}
}

int TestSoftShadows(int, char*[])
{
  Check check;
  TestPoint(check);
  TestSamples(check);
  TestHalfPlane(check);
  TestRefinement(check);
  TestNarrow(check);
  TestShapes(check);
  TestConvolution(check);
  TestInside(check);
  return check.Result();
}
