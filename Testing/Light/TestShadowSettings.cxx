// SPDX-License-Identifier: BSD-3-Clause
// Settings of vtkShadowedSliceMapper that no reference has: how much of a surface a gradient makes,
// and what is given up where time is short.
#include "Light/ShadowComparison.h"
#include "Support/Pictures/PictureSettings.h"
#include "Support/Pictures/ShadowCases.h"
#include "Support/Drawing/ShadowPicture.h"
#include "Support/Pictures/VolumeStage.h"
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

/// A ramp over the range of its scalar: the change from voxel to voxel is the same everywhere but
/// at both ends, where it is a half of that. Lit so that it shines.
ShadowScene RampScene(bool shade)
{
  auto scene =
    MakeScene(MakeImage(Cells, [](const Double3& x) { return 0.3 * x[0] + 0.7 * (1.0 - x[2]); }),
      MakeSoftProperty(0.4, shade));
  scene.Lights = { MakeDirectionalLight({ { 0.832, 0.358, -0.422 } }) };
  return scene;
}

RgbaPicture DrawAt(const ShadowScene& scene, double surfaceGradient)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetSurfaceGradient(surfaceGradient);
  return DrawByMapper(mapper, scene);
}

/// a + weight (b - a).
RgbaPicture Mix(const RgbaPicture& a, const RgbaPicture& b, double weight)
{
  RgbaPicture mixed = a;
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

/// The share of a surface is the change over SurfaceGradient, up to 1, and a picture is linear in
/// it: from evenly scattered light, as without Shade, to the one of surfaces.
void TestSurfaceGradient(Check& check)
{
  // The largest change along an axis, as a share of the range, is 0.7 / Cells.
  constexpr double change = 0.7 / Cells;
  const ShadowScene shaded = RampScene(true);
  const RgbaPicture whole = DrawAt(shaded, change);
  const RgbaPicture half = DrawAt(shaded, 2.0 * change);
  const RgbaPicture quarter = DrawAt(shaded, 4.0 * change);
  const RgbaPicture even = DrawAt(RampScene(false), 0.0);
  check.That(ComparePictures(whole, even).Mean > 1e-2, "surfaces differ from even scattering");
  const PictureBound bound{ 2e-5, 5e-6 };
  ExpectAlike(check, "half of a surface", half, Mix(even, whole, 0.5), bound);
  ExpectAlike(check, "a quarter of a surface", quarter, Mix(even, whole, 0.25), bound);
  // Below the change there is no more than a surface but at the ends.
  const RgbaPicture below = DrawAt(shaded, 0.5 * change);
  const RgbaPicture none = DrawAt(shaded, 0.0);
  ExpectAlike(check, "below both changes, every gradient is one of a surface", below, none, bound);
}

/// The picture is that of the turned values where surfaces are lit from both sides, and at least as
/// bright as from one; the lines of the shader are there for shaded matter alone.
void TestTwoSidedLighting(Check& check)
{
  const auto draw = [](bool isTurned, bool isTwoSided, bool isShaded, std::string& features)
  {
    const auto ramp = [isTurned](const Double3& x)
    {
      const double value = 0.3 * x[0] + 0.7 * (1.0 - x[2]);
      return isTurned ? 1.0 - value : value;
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
    const RgbaPicture picture = DrawByMapper(mapper, scene);
    features = mapper->GetReport()->GetText("Features");
    return picture;
  };
  std::string features;
  const RgbaPicture lit = draw(false, false, true, features);
  check.That(features.find("two-sided") == std::string::npos, "one side asks for no lines");
  const RgbaPicture dark = draw(true, false, true, features);
  const RgbaPicture both = draw(false, true, true, features);
  check.That(features.find("two-sided") != std::string::npos, "both sides ask for lines");
  const RgbaPicture turned = draw(true, true, true, features);
  draw(false, true, false, features);
  check.That(features.find("two-sided") == std::string::npos, "even matter has no sides");
  check.That(ComparePictures(lit, dark).Mean > 1e-2, "one side differs from the other");
  ExpectAlike(check, "values and turned values from both sides", both, turned, { 2e-5, 5e-6 });
}

ReportCopy DrawAtRate(VolumeStage& stage, vtkShadowedSliceMapper* mapper, double rate)
{
  stage.GetWindow()->SetDesiredUpdateRate(rate);
  // The first picture at a rate tells how long it takes.
  stage.GetWindow()->Render();
  stage.GetWindow()->Render();
  return CopyReport(mapper->GetReport());
}

/// Coarser while there is no time, as before when there is, and never what was set.
void TestAutoAdjust(Check& check)
{
  constexpr double hurried = 1e6;
  constexpr double patient = 1e-4;
  const ShadowScene scene = RampScene(true);
  VolumeStage stage(scene.Size);
  vtkNew<vtkShadowedSliceMapper> mapper;
  SetScene(stage, mapper, scene);
  const ReportCopy still = DrawAtRate(stage, mapper, patient);
  const ReportCopy moving = DrawAtRate(stage, mapper, hurried);
  check.Near(still->GetNumber("ImageSampleDistance"), 1.0, 0.0,
    "image sample distance of a still view", 1.0);
  check.Near(
    moving->GetNumber("ImageSampleDistance"), 4.0, 0.0, "image sample distance while hurried", 1.0);
  check.Near(moving->GetNumber("SliceSpacing") / still->GetNumber("SliceSpacing"), 4.0, 0.3,
    "spacing while hurried", 1.0);
  const ReportCopy again = DrawAtRate(stage, mapper, patient);
  check.Near(again->GetNumber("SliceSpacing"), still->GetNumber("SliceSpacing"), 0.0,
    "spacing of a still view again", 1.0);
  check.Near(
    again->GetNumber("Slices"), still->GetNumber("Slices"), 0.0, "slices of a still view again");

  mapper->SetSliceSpacing(still->GetNumber("SliceSpacing"));
  const ReportCopy fixed = DrawAtRate(stage, mapper, hurried);
  check.Near(
    fixed->GetNumber("Slices"), still->GetNumber("Slices"), 0.0, "slices at a spacing that is set");
  check.Near(
    fixed->GetNumber("ImageSampleDistance"), 4.0, 0.0, "pixels at a spacing that is set", 1.0);

  mapper->SetSliceSpacing(0.0);
  mapper->AutoAdjustSampleDistancesOff();
  const ReportCopy off = DrawAtRate(stage, mapper, hurried);
  check.Near(
    off->GetNumber("Slices"), still->GetNumber("Slices"), 0.0, "slices without adjustment");
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
