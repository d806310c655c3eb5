// SPDX-License-Identifier: BSD-3-Clause
// Settings of vtkShadowedSliceMapper that the reference does not implement: SurfaceGradient,
// two-sided lighting and automatic adjustment.
#include "Light/ShadowComparison.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeProperty.h"

#include <string>

namespace
{

using namespace reference;

constexpr int Cells = 16;

/// Returns a scene with a linear ramp. Each gradient component is constant, except at both ends of
/// its axis, where it is halved. The light direction is chosen such that there is a highlight.
ShadowScene RampScene(bool shade)
{
  auto scene =
    MakeScene(MakeImage(Cells, [](const Double3& x) { return 0.3 * x[0] + 0.7 * (1.0 - x[2]); }),
      MakeTranslucentProperty(0.4, shade));
  scene.Lights = { MakeDirectionalLight({ { 0.832, 0.358, -0.422 } }) };
  return scene;
}

RgbaImage DrawAt(const ShadowScene& scene, double surfaceGradient)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetSurfaceGradient(surfaceGradient);
  return DrawByMapper(mapper, scene);
}

/// Returns a + weight (b - a).
RgbaImage Mix(const RgbaImage& a, const RgbaImage& b, double weight)
{
  RgbaImage mixed = a;
  for (int j = 0; j < a.Height; ++j)
  {
    for (int i = 0; i < a.Width; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        mixed.At(i, j)[k] += weight * (b.At(i, j)[k] - a.At(i, j)[k]);
      }
    }
  }
  return mixed;
}

/// The surface fraction is the gradient divided by SurfaceGradient, but at most 1. Colors are
/// interpolated linearly by this fraction between scattering, as without Shade, and surface
/// shading.
void TestSurfaceGradient(Check& check)
{
  // The largest gradient component, as a fraction of the data range per cell, is 0.7 / Cells.
  constexpr double change = 0.7 / Cells;
  const ShadowScene shaded = RampScene(true);
  const RgbaImage full = DrawAt(shaded, change);
  const RgbaImage half = DrawAt(shaded, 2.0 * change);
  const RgbaImage quarter = DrawAt(shaded, 4.0 * change);
  const RgbaImage isotropic = DrawAt(RampScene(false), 0.0);
  check.That(CompareImages(full, isotropic).Mean > 1e-2, "surface shading differs from scattering");
  const ImageBound bound{ 2e-5, 5e-6 };
  ExpectSimilar(check, "half surface shading", half, Mix(isotropic, full, 0.5), bound);
  ExpectSimilar(check, "a quarter surface shading", quarter, Mix(isotropic, full, 0.25), bound);
  // If SurfaceGradient does not exceed the smallest gradient, the surface fraction is 1 everywhere.
  const RgbaImage below = DrawAt(shaded, 0.5 * change);
  const RgbaImage none = DrawAt(shaded, 0.0);
  ExpectSimilar(
    check, "every gradient is a surface if SurfaceGradient is small", below, none, bound);
}

/// With two-sided lighting, inverting the values does not change the image. Only shaded volumes
/// have shader code for two-sided lighting.
void TestTwoSidedLighting(Check& check)
{
  const auto draw = [](bool isInverted, bool isTwoSided, bool isShaded, std::string& features)
  {
    const auto ramp = [isInverted](const Double3& x)
    {
      const double value = 0.3 * x[0] + 0.7 * (1.0 - x[2]);
      return isInverted ? 1.0 - value : value;
    };
    auto property = MakeProperty(
      { { 0.0, { { 1.0, 1.0, 1.0 } }, 0.3 }, { 1.0, { { 1.0, 1.0, 1.0 } }, 0.3 } }, 0.1);
    property->SetShade(isShaded);
    property->SetDiffuse(0.8);
    property->SetSpecular(0.3);
    auto scene = MakeScene(MakeImage(Cells, ramp), property);
    scene.Lights = { MakeDirectionalLight({ { 0.832, 0.358, -0.422 } }) };
    vtkNew<vtkShadowedSliceMapper> mapper;
    mapper->SetTwoSidedLighting(isTwoSided);
    const RgbaImage image = DrawByMapper(mapper, scene);
    features = mapper->GetReport()->GetText("Features");
    return image;
  };
  std::string features;
  const RgbaImage lit = draw(false, false, true, features);
  check.That(
    features.find("two-sided") == std::string::npos, "no shader code for one-sided lighting");
  const RgbaImage dark = draw(true, false, true, features);
  const RgbaImage both = draw(false, true, true, features);
  check.That(features.find("two-sided") != std::string::npos, "shader code for two-sided lighting");
  const RgbaImage inverted = draw(true, true, true, features);
  draw(false, true, false, features);
  check.That(features.find("two-sided") == std::string::npos, "no shader code without shading");
  check.That(CompareImages(lit, dark).Mean > 1e-2, "one-sided lighting depends on the side");
  ExpectSimilar(
    check, "two-sided lighting of values and inverted values", both, inverted, { 2e-5, 5e-6 });
}

ReportCopy DrawAtRate(VolumeStage& stage, vtkShadowedSliceMapper* mapper, double rate)
{
  stage.GetWindow()->SetDesiredUpdateRate(rate);
  // The first frame at a new rate only measures the rendering time; the second frame is adjusted to
  // it.
  stage.GetWindow()->Render();
  stage.GetWindow()->Render();
  return CopyReport(mapper->GetReport());
}

/// Automatic adjustment coarsens frames at a high update rate, and restores full resolution at a
/// low rate. It does not change explicit settings.
void TestAutoAdjust(Check& check)
{
  constexpr double fastRate = 1e6;
  constexpr double slowRate = 1e-4;
  const ShadowScene scene = RampScene(true);
  VolumeStage stage(scene.Size);
  vtkNew<vtkShadowedSliceMapper> mapper;
  SetScene(stage, mapper, scene);
  const ReportCopy still = DrawAtRate(stage, mapper, slowRate);
  const ReportCopy moving = DrawAtRate(stage, mapper, fastRate);
  check.Near(still->GetNumber("ImageSampleDistance"), 1.0, 0.0,
    "image sample distance of a still view", 1.0);
  constexpr double coarsest = 8.0;
  check.Near(moving->GetNumber("ImageSampleDistance"), coarsest, 0.0,
    "image sample distance at a high rate", 1.0);
  check.Near(moving->GetNumber("SliceSpacing") / still->GetNumber("SliceSpacing"), coarsest, 1.0,
    "spacing at a high rate", 1.0);
  const ReportCopy again = DrawAtRate(stage, mapper, slowRate);
  check.Near(again->GetNumber("SliceSpacing"), still->GetNumber("SliceSpacing"), 0.0,
    "spacing of a still view again");
  check.Equal(again->GetCount("Slices"), still->GetCount("Slices"), "slices of a still view again");

  mapper->SetSliceSpacing(still->GetNumber("SliceSpacing"));
  const ReportCopy fixed = DrawAtRate(stage, mapper, fastRate);
  check.Equal(fixed->GetCount("Slices"), still->GetCount("Slices"), "slices with a fixed spacing");
  check.Near(
    fixed->GetNumber("ImageSampleDistance"), coarsest, 0.0, "pixels with a fixed spacing", 1.0);

  mapper->SetSliceSpacing(0.0);
  mapper->AutoAdjustSampleDistancesOff();
  const ReportCopy off = DrawAtRate(stage, mapper, fastRate);
  check.Equal(off->GetCount("Slices"), still->GetCount("Slices"), "slices without adjustment");
  check.Near(off->GetNumber("ImageSampleDistance"), 1.0, 0.0, "pixels without adjustment", 1.0);
}

}

int TestShadowSettings(int, char*[])
{
  Check check;
  TestSurfaceGradient(check);
  TestTwoSidedLighting(check);
  TestAutoAdjust(check);
  return check.Result();
}
