// SPDX-License-Identifier: BSD-3-Clause
// The Beer-Lambert law in vtkShadowedSliceMapper: light buffers compared with analytic
// transmittances, for different slice spacings and angles between view and light.
#include "Support/Checks/LargestError.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceMedium.h"
#include "Support/Images/ReferenceShadow.h"
#include "Support/Images/ReferenceShadowImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeProperty.h"

#include <functional>
#include <iostream>

namespace
{

using namespace reference;

constexpr double DefaultBound = 1e-3;
constexpr double AngleBound = 2e-3;

/// Returns a property that maps a value v to the extinction v * \a largest.
vtkSmartPointer<vtkVolumeProperty> MakeProportional(double largest)
{
  constexpr int pieces = 1024;
  std::vector<FunctionNode> nodes;
  for (int i = 0; i <= pieces; ++i)
  {
    const double v = static_cast<double>(i) / pieces;
    nodes.push_back({ v, { { 1.0, 1.0, 1.0 } }, -std::expm1(-largest * v) });
  }
  auto property = MakeProperty(nodes);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  return property;
}

/// A light buffer, sampled at world positions.
class LightBuffer
{
public:
  LightBuffer(vtkShadowedSliceMapper* mapper, const ShadowScene& scene)
  {
    VolumeStage stage(scene.Size);
    SetScene(stage, mapper, scene);
    stage.Render();
    this->IsRead = mapper->ReadLightBuffer(stage.GetRenderer(), scene.Lights[0], this->Image);
    if (this->IsRead)
    {
      vtkDataArray* matrix = this->Image->GetFieldData()->GetArray("BufferFromWorld");
      for (int i = 0; matrix && i < 16; ++i)
      {
        this->Matrix[i] = matrix->GetComponent(matrix->GetNumberOfComponents() == 16 ? 0 : i,
          matrix->GetNumberOfComponents() == 16 ? i : 0);
      }
    }
  }

  /// Returns the interpolated value of a channel, or NaN outside the buffer or if there is no
  /// buffer.
  double At(const Double3& world, int channel = 0)
  {
    if (!this->IsRead)
    {
      return std::nan("");
    }
    const double x[4] = { world[0], world[1], world[2], 1.0 };
    double uv[4];
    vtkMatrix4x4::MultiplyPoint(this->Matrix.data(), x, uv);
    const int* size = this->Image->GetDimensions();
    std::array<int, 2> lower;
    std::array<double, 2> fraction;
    for (int axis = 0; axis < 2; ++axis)
    {
      const double at = uv[axis] / uv[3] * size[axis] - 0.5;
      if (!(at >= 0.0 && at <= size[axis] - 1.0))
      {
        return std::nan("");
      }
      lower[axis] = std::min(static_cast<int>(at), size[axis] - 2);
      fraction[axis] = at - lower[axis];
    }
    vtkDataArray* values = this->Image->GetPointData()->GetScalars();
    const auto value = [&](int i, int j)
    { return values->GetComponent((lower[1] + j) * size[0] + lower[0] + i, channel); };
    const double bottom = value(0, 0) + fraction[0] * (value(1, 0) - value(0, 0));
    const double top = value(0, 1) + fraction[0] * (value(1, 1) - value(0, 1));
    return bottom + fraction[1] * (top - bottom);
  }

  bool IsRead = false;

private:
  vtkNew<vtkImageData> Image;
  std::array<double, 16> Matrix{};
};

/// Returns a cube whose extinction follows a profile along z. A directional light, tilted by \a
/// slope, shines from above.
ShadowScene LayeredScene(const std::function<double(double)>& profile, double largest, double slope)
{
  auto scene = MakeScene(
    MakeImage(16, [&](const Double3& x) { return profile(x[2]); }), MakeProportional(largest));
  scene.Lights = { MakeDirectionalLight({ { slope, 0.5 * slope, -1.0 } }) };
  scene.Camera = LookAt(scene.Image, { { -0.3, -0.4, -1.0 } }, true);
  scene.Size = { { 32, 32 } };
  return scene;
}

/// Returns the largest error for light rays that enter through the top and exit through the bottom,
/// or NaN if a value is missing.
double GetLargestError(LightBuffer& buffer, double slope, double depth)
{
  const double expected = std::exp(-depth * std::sqrt(1.0 + 1.25 * slope * slope));
  double largest = 0.0;
  for (int j = -4; j <= 4; ++j)
  {
    for (int i = -4; i <= 4; ++i)
    {
      const double error = std::abs(buffer.At({ { 0.05 * i, 0.05 * j, 0.0 } }) - expected);
      largest = std::isnan(error) ? error : std::max(largest, error);
    }
  }
  return largest;
}

void TestMedia(Check& check)
{
  const struct
  {
    const char* Name;
    std::function<double(double)> Profile;
    /// Integral of the profile from z to the top at z = 1.
    std::function<double(double)> Integral;
  } media[] = { { "homogeneous", [](double) { return 1.0; }, [](double z) { return 1.0 - z; } },
    { "linear", [](double z) { return z; }, [](double z) { return 0.5 * (1.0 - z * z); } },
    // Between the two slabs, the extinction changes linearly over one voxel.
    { "two slabs", [](double z) { return z > 0.5 ? 0.2 : 1.0; },
      [](double z)
      {
        const double ramp = 0.5 / 8.0;
        const double top = 0.2 * (0.5 - ramp);
        return z > 0.5 ? 0.2 * (1.0 - z) : top + 0.6 * ramp + (0.5 - z);
      } },
    { "quadratic", [](double z) { return z * z; },
      [](double z) { return (1.0 - z * z * z) / 3.0 + (1.0 - z) / (6.0 * 256.0); } } };
  constexpr double largest = 3.0;
  for (const auto& medium : media)
  {
    for (double slope : { 0.0, 0.25 })
    {
      const std::string name =
        std::string(medium.Name) + (slope == 0.0 ? ", light straight" : ", oblique light");
      auto scene = LayeredScene(medium.Profile, largest, slope);
      vtkNew<vtkShadowedSliceMapper> mapper;
      LightBuffer full(mapper, scene);
      const double error = GetLargestError(full, slope, largest * medium.Integral(0.0));
      std::cout << name << ", default spacing: " << error << std::endl;
      check.Near(error, 0.0, DefaultBound, name + ", default spacing", 1.0);
      // If the region below z is cropped, the light buffer contains the transmittance down to z.
      for (double z : { 0.75, 0.25 })
      {
        scene.CroppingPlanes = { { -1.0, 1.0, -1.0, 1.0, z - 0.5, 1.0 } };
        scene.CroppingFlags = VTK_CROP_SUBVOLUME;
        LightBuffer cropped(mapper, scene);
        check.Near(GetLargestError(cropped, slope, largest * medium.Integral(z)), 0.0, DefaultBound,
          name + ", at a depth", 1.0);
      }
      scene.CroppingFlags = 0;
      std::vector<double> errors;
      for (double spacing : { 0.25, 0.125, 0.0625, 0.03125, 0.015625 })
      {
        mapper->SetSliceSpacing(spacing);
        LightBuffer buffer(mapper, scene);
        errors.push_back(GetLargestError(buffer, slope, largest * medium.Integral(0.0)));
        // The spacing is reduced such that an integer number of slices fills the volume.
        const double inUse = mapper->GetReport()->GetNumber("SliceSpacing");
        check.That(
          inUse <= 1.000001 * spacing && inUse > 0.8 * spacing, "the mapper uses the spacing");
        std::cout << "  spacing " << spacing << ": " << errors.back() << std::endl;
        // The error is of first order in the spacing, up to rounding error.
        check.That(errors.back() <= errors.front() * spacing / 0.25 + 1e-4,
          name + ": the error decreases with spacing " + std::to_string(spacing));
      }
      mapper->SetSliceSpacing(0.0);
    }
  }
}

/// With a transmission color, light buffers have three channels.
void TestTransmission(Check& check)
{
  auto scene = LayeredScene([](double) { return 1.0; }, 3.0, 0.0);
  scene.TransmissionColor = vtkSmartPointer<vtkColorTransferFunction>::New();
  scene.TransmissionColor->AddRGBPoint(0.0, 1.0, 0.5, 0.0);
  vtkNew<vtkShadowedSliceMapper> mapper;
  LightBuffer buffer(mapper, scene);
  for (int channel = 0; channel < 3; ++channel)
  {
    check.Near(buffer.At({ { 0.1, 0.1, 0.0 } }, channel), std::exp(-1.5 * channel), DefaultBound,
      "transmittance of channel " + std::to_string(channel), 1.0);
  }
}

/// A sphere with a soft boundary, so that light buffers have no sharp edges.
ShadowScene SphereScene()
{
  auto scene = MakeScene(MakeImage(32,
                           [](const Double3& x)
                           {
                             const double r2 = (x[0] - 0.5) * (x[0] - 0.5) +
                               (x[1] - 0.5) * (x[1] - 0.5) + (x[2] - 0.5) * (x[2] - 0.5);
                             const double inside = std::max(0.0, 1.0 - r2 / 0.2);
                             return inside * inside;
                           }),
    MakeProportional(6.0));
  scene.Lights = { MakeDirectionalLight({ { 0.0, 0.0, -1.0 } }) };
  scene.Size = { { 48, 48 } };
  return scene;
}

void TestAngles(Check& check)
{
  auto scene = SphereScene();
  const ReferenceMedium medium(scene);
  std::vector<Double3> positions;
  std::vector<double> expected;
  for (int j = -9; j <= 9; ++j)
  {
    for (int i = -9; i <= 9; ++i)
    {
      positions.push_back({ { 0.045 * i, 0.045 * j, -0.5 } });
      expected.push_back(ToTransmittance(
        GetOpticalDepth(medium, positions.back(), { { 0.0, 0.0, 1.0 } }, 10.0, 2))[0]);
    }
  }
  std::vector<double> minimum(positions.size(), 2.0);
  std::vector<double> maximum(positions.size(), -2.0);
  double error = 0.0;
  double imageError = 0.0;
  for (int angle = 0; angle <= 180; angle += 5)
  {
    const double radians = vtkMath::RadiansFromDegrees(static_cast<double>(angle));
    scene.Camera = LookAt(scene.Image, { { std::sin(radians), 0.0, -std::cos(radians) } }, true);
    vtkNew<vtkShadowedSliceMapper> mapper;
    // With a large buffer, the error of interpolation between texels is negligible.
    mapper->SetLightBufferSize(256);
    LightBuffer buffer(mapper, scene);
    mapper->SetLightBufferSize(0);
    const std::string name = "angle " + std::to_string(angle);
    check.That(buffer.IsRead, name + ": the buffer exists");
    for (std::size_t at = 0; at < positions.size(); ++at)
    {
      const double found = buffer.At(positions[at]);
      check.That(std::isfinite(found), name + ": the value is finite");
      minimum[at] = std::min(minimum[at], found);
      maximum[at] = std::max(maximum[at], found);
      reference::KeepLargest(error, std::abs(found - expected[at]));
    }
    const ImageError image = CompareImages(DrawByMapper(mapper, scene), MakeShadowImage(scene));
    std::cout << name << ": " << image << std::endl;
    check.Near(image.Max, 0.0, AngleBound, name + ": image error", 1.0);
    reference::KeepLargest(imageError, image.Max);
  }
  double difference = 0.0;
  for (std::size_t at = 0; at < positions.size(); ++at)
  {
    difference = std::max(difference, maximum[at] - minimum[at]);
  }
  std::cout << "all angles: light buffer " << error << ", difference between angles " << difference
            << ", images " << imageError << std::endl;
  check.Near(difference, 0.0, AngleBound, "difference of light buffers between angles", 1.0);
  check.Near(error, 0.0, AngleBound, "light buffers of all angles", 1.0);
}

/// ReadLightBuffer fails for lights without light buffers.
void TestWithout(Check& check)
{
  auto scene = SphereScene();
  vtkNew<vtkShadowedSliceMapper> mapper;
  scene.Lights[0]->SetShadowAttenuation(0.0);
  check.That(!LightBuffer(mapper, scene).IsRead, "a light without shadows");
  scene.Lights = { MakePositionalLight({ { 0.1, 0.0, 0.1 } }) };
  check.That(!LightBuffer(mapper, scene).IsRead, "a light inside");
  scene.Lights = { MakePositionalLight({ { 0.1, 0.0, 5.0 } }) };
  mapper->SetLightBufferSize(256);
  LightBuffer far(mapper, scene);
  check.That(far.IsRead, "a light outside");
  const Double3 position = { { 0.05, 0.05, -0.5 } };
  Double3 direction = { { 0.05, -0.05, 5.5 } };
  const double distance = vtkMath::Normalize(direction.data());
  check.Near(far.At(position),
    ToTransmittance(GetOpticalDepth(ReferenceMedium(scene), position, direction, distance, 2))[0],
    DefaultBound, "transmittance from a point", 1.0);
}

/// A large area light above a homogeneous medium: the light buffer is the mean over the light's
/// samples, whose rays are longer than the ray from the center.
void TestArea(Check& check)
{
  constexpr double largest = 3.0;
  auto scene = LayeredScene([](double) { return 1.0; }, largest, 0.0);
  vtkNew<vtkAreaLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetPosition(0.0, 0.0, 1.5);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetSize(1.0, 1.0);
  scene.Lights = { light.Get() };
  vtkNew<vtkShadowedSliceMapper> mapper;
  LightBuffer buffer(mapper, scene);
  const Double3 point{ { 0.0, 0.0, -0.5 } };
  double expected = 0.0;
  for (const vtkAreaLight::Sample& sample : light->GetSamples(mapper->GetNumberOfLightSamples()))
  {
    const double distance =
      std::sqrt(vtkMath::Distance2BetweenPoints(sample.Position, point.data()));
    expected += sample.Weight[0] * std::exp(-largest * distance / (sample.Position[2] - point[2]));
  }
  std::cout << "area light: " << buffer.At(point) << ", expected " << expected
            << ", from the center " << std::exp(-largest) << std::endl;
  check.Near(buffer.At(point), expected, 3e-4, "area light", 1.0);
}
}

int TestShadowTransmittance(int, char*[])
{
  Check check;
  TestMedia(check);
  TestTransmission(check);
  TestAngles(check);
  TestArea(check);
  TestWithout(check);
  return check.Result();
}
