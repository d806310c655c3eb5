// SPDX-License-Identifier: BSD-3-Clause
// Cropping, clipping planes and the camera's clipping range cut the volume of
// vtkShadowedSliceMapper along view rays, for any direction matrix of the vtkImageData. Frames are
// compared with the reference, with equivalent cuts, and with smaller vtkImageData.
#include "Light/ShadowComparison.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceRay.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceRandom.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace
{

using namespace reference;

/// Error bound for homogeneous media, whose opacity is exact for any slice spacing.
constexpr ImageBound Exact = { 2e-5, 2e-6 };
constexpr ImageBound Similar = { 1e-5, 1e-6 };

struct Axes
{
  std::string Name;
  std::array<double, 9> Matrix;
};

/// Returns direction matrices: identity, rotation, rotation with reflection, permuted axes, and one
/// reversed axis.
std::vector<Axes> GetAxes()
{
  return { { "identity", { { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } } },
    { "rotated", { { 0.8, -0.6, 0.0, 0.48, 0.64, -0.6, 0.36, 0.48, 0.8 } } },
    { "mirrored", { { 0.8, -0.6, 0.0, 0.48, 0.64, -0.6, -0.36, -0.48, -0.8 } } },
    { "permuted", { { 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 1.0, 0.0 } } },
    { "reversed", { { -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } } } };
}

/// Returns samples of a field in a vtkImageData with a direction matrix, centered at \a center.
vtkSmartPointer<vtkImageData> MakeOrientedImage(
  const Axes& axes, const Field& field, const Double3& center = { { 0.0, 0.0, 0.0 } })
{
  auto image = MakeImage({ { 20, 16, 12 } }, { { 0.05, 0.055, 0.06 } }, field);
  image->SetDirectionMatrix(axes.Matrix.data());
  const Double3 first = { { 0.0, 0.0, 0.0 } };
  const Double3 last = { { 20.0, 16.0, 12.0 } };
  Double3 ends[2];
  image->TransformContinuousIndexToPhysicalPoint(first.data(), ends[0].data());
  image->TransformContinuousIndexToPhysicalPoint(last.data(), ends[1].data());
  Double3 origin;
  image->GetOrigin(origin.data());
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] += center[axis] - 0.5 * (ends[0][axis] + ends[1][axis]);
  }
  image->SetOrigin(origin.data());
  return image;
}

/// Returns a scene of a homogeneous medium without lighting.
ShadowScene MakeHomogeneous(vtkImageData* image, bool isParallel)
{
  auto scene = MakeHomogeneousScene(2, 1.5);
  scene.Image = image;
  scene.Camera = LookAt(image, { { -0.3, -0.4, -1.0 } }, isParallel);
  scene.Shadows = false;
  scene.Size = { { 40, 40 } };
  return scene;
}

double One(const Double3&)
{
  return 1.0;
}

/// Compares a scene with the reference, for slices that are about three voxels thick.
void ExpectExact(
  Check& check, const std::string& name, const ShadowScene& scene, const ImageBound& bound = Exact)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetSliceSpacing(0.15);
  ExpectSimilarToReference(check, name, mapper, scene, bound);
}

constexpr std::array<double, 6> CroppingPlanes = { { -0.22, 0.31, -0.27, 0.13, -0.4, 0.17 } };

std::vector<vtkSmartPointer<vtkPlane>> MakePlanes()
{
  std::vector<vtkSmartPointer<vtkPlane>> planes;
  for (int side = 0; side < 6; ++side)
  {
    Double3 normal{};
    Double3 origin{};
    normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
    origin[side / 2] = CroppingPlanes[side];
    planes.push_back(vtkSmartPointer<vtkPlane>::New());
    planes.back()->SetNormal(normal.data());
    planes.back()->SetOrigin(origin.data());
  }
  return planes;
}

/// Compares a cropped subvolume with the reference, and with a volume cut by six clipping planes.
void TestSubvolume(Check& check)
{
  for (const Axes& axes : GetAxes())
  {
    auto homogeneous = MakeHomogeneous(MakeOrientedImage(axes, &One), false);
    homogeneous.CroppingPlanes = CroppingPlanes;
    homogeneous.CroppingFlags = VTK_CROP_SUBVOLUME;
    ExpectExact(check, "subvolume, " + axes.Name, homogeneous);
    auto lit =
      MakeScene(MakeOrientedImage(axes, MakeSphere(0.15, 0.6)), MakeTranslucentProperty(0.9, true));
    lit.Size = { { 48, 48 } };
    lit.CroppingPlanes = CroppingPlanes;
    lit.CroppingFlags = VTK_CROP_SUBVOLUME;
    vtkNew<vtkShadowedSliceMapper> cropping;
    const RgbaImage cropped = DrawByMapper(cropping, lit);
    lit.CroppingFlags = 0;
    lit.ClippingPlanes = MakePlanes();
    vtkNew<vtkShadowedSliceMapper> clipping;
    const RgbaImage clipped = DrawByMapper(clipping, lit);
    check.That(LargestAlpha(cropped) > 0.5, "the cropped image is not empty");
    // For an axis-aligned vtkImageData, slices are fitted to the cropped box, so frames differ
    // slightly.
    const bool isOblique = axes.Matrix[0] == 0.8;
    ExpectSimilar(check, "same as clipping planes, " + axes.Name, cropped, clipped,
      isOblique ? Similar : ImageBound{ 0.03, 2e-4 });
  }
}

/// Compares a volume cropped at sample positions with a vtkImageData of only the samples that
/// remain.
void TestExtracted(Check& check)
{
  for (const Axes& axes : GetAxes())
  {
    auto scene = MakeScene(
      MakeOrientedImage(axes, MakeSphere(0.15, 0.6)), MakeTranslucentProperty(0.9, false));
    scene.Size = { { 48, 48 } };
    const int extent[6] = { 3, 15, 5, 16, 0, 7 };
    const Double3 first = { { 3.0, 5.0, 0.0 } };
    const Double3 last = { { 15.0, 16.0, 7.0 } };
    Double3 ends[2];
    scene.Image->TransformContinuousIndexToPhysicalPoint(first.data(), ends[0].data());
    scene.Image->TransformContinuousIndexToPhysicalPoint(last.data(), ends[1].data());
    scene.CroppingFlags = VTK_CROP_SUBVOLUME;
    for (int axis = 0; axis < 3; ++axis)
    {
      scene.CroppingPlanes[2 * axis] = std::min(ends[0][axis], ends[1][axis]);
      scene.CroppingPlanes[2 * axis + 1] = std::max(ends[0][axis], ends[1][axis]);
    }
    if (axes.Matrix[0] == 0.8)
    {
      continue;
    }
    vtkNew<vtkShadowedSliceMapper> cropping;
    const RgbaImage cropped = DrawByMapper(cropping, scene);
    scene.CroppingFlags = 0;
    auto extracted = vtkSmartPointer<vtkImageData>::New();
    extracted->DeepCopy(scene.Image);
    extracted->Crop(extent);
    scene.Image = extracted;
    vtkNew<vtkShadowedSliceMapper> extracting;
    check.That(LargestAlpha(cropped) > 0.5, "the cropped image is not empty");
    ExpectSimilar(check, "same as a smaller image, " + axes.Name, cropped,
      DrawByMapper(extracting, scene), Similar);
  }
}

/// Checks cropping regions with gaps, for predefined and random flags, near the origin and far from
/// it.
void TestGaps(Check& check)
{
  Random random(12);
  std::vector<int> flags = { VTK_CROP_FENCE, VTK_CROP_INVERTED_FENCE, VTK_CROP_CROSS,
    VTK_CROP_INVERTED_CROSS, 0x0600018 };
  while (flags.size() < 12)
  {
    flags.push_back(static_cast<int>(random.Get(1.0, 134217727.0)));
  }
  const std::vector<Axes> orientations = GetAxes();
  for (std::size_t i = 0; i < flags.size(); ++i)
  {
    const Axes& axes = orientations[i % orientations.size()];
    const double far = i % 3 == 1 ? 1e5 : 0.0;
    auto scene =
      MakeHomogeneous(MakeOrientedImage(axes, &One, { { far, -far, 0.5 * far } }), i % 2 == 0);
    scene.CroppingFlags = flags[i];
    for (int side = 0; side < 6; ++side)
    {
      scene.CroppingPlanes[side] = CroppingPlanes[side] +
        (side / 2 == 0      ? far
            : side / 2 == 1 ? -far
                            : 0.5 * far);
    }
    ExpectExact(check, "flags " + std::to_string(flags[i]) + ", " + axes.Name, scene);
  }
}

/// Checks that light passes through gaps in the cropping region, for lights outside and inside the
/// volume.
void TestLitGaps(Check& check)
{
  const std::vector<Axes> orientations = GetAxes();
  for (const bool isWithin : { false, true })
  {
    for (const int flags : { VTK_CROP_FENCE, VTK_CROP_CROSS })
    {
      auto scene = MakeScene(MakeOrientedImage(orientations[1], MakeSphere(0.15, 0.7)),
        MakeTranslucentProperty(0.5, false));
      scene.Size = { { 40, 40 } };
      scene.CroppingPlanes = CroppingPlanes;
      scene.CroppingFlags = flags;
      if (isWithin)
      {
        scene.Lights = { MakePositionalLight({ { 0.05, 0.1, 0.12 } }) };
      }
      ExpectSimilarToReference(check,
        "light through gaps, flags " + std::to_string(flags) + (isWithin ? ", from inside" : ""),
        scene, { 0.02, 1.5e-4 });
    }
  }
}

/// The camera's clipping range cuts the volume, but does not affect the light.
void TestCameraPlanes(Check& check)
{
  const std::vector<Axes> orientations = GetAxes();
  for (const bool isParallel : { false, true })
  {
    const std::string projection = isParallel ? ", parallel" : ", perspective";
    auto scene = MakeHomogeneous(MakeOrientedImage(orientations[1], &One), isParallel);
    const double distance = scene.Camera->GetDistance();
    const auto expect = [&](const std::string& name, double near, double far)
    {
      scene.Camera->SetClippingRange(distance + near, distance + far);
      ExpectExact(check, name + projection, scene);
    };
    expect("far plane behind the center", -2.0, 0.113);
    expect("far plane in front of the center", -2.0, -0.22);
    expect("near plane", -0.13, 2.0);
    expect("both planes", -0.21, 0.017);
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.05, 0.1, 0.12);
    plane->SetNormal(-0.8, 0.2, -0.5);
    scene.ClippingPlanes = { plane.Get() };
    expect("both planes and a clipping plane", -0.21, 0.07);

    // Tests lit scenes: a medium of low density, and an opacity step whose slabs are treated as
    // optically thick.
    for (const bool isThick : { false, true })
    {
      auto lit = MakeScene(MakeOrientedImage(orientations[1], MakeSphere(0.15, 0.6)),
        MakeTranslucentProperty(0.6, false));
      if (isThick)
      {
        vtkNew<vtkPiecewiseFunction> steps;
        steps->AddPoint(0.0, 0.0);
        steps->AddPoint(0.3, 0.0);
        steps->AddPoint(0.3 + 1e-5, 0.97);
        lit.Property->SetScalarOpacity(steps);
      }
      lit.Camera = LookAt(lit.Image, { { -0.3, -0.4, -1.0 } }, isParallel);
      lit.Camera->SetClippingRange(distance - 2.0, distance + 0.03);
      // The light comes from behind the far plane.
      lit.Lights = { MakeDirectionalLight({ { 0.2, 0.5, 1.0 } }) };
      ExpectSimilarToReference(check,
        std::string("far plane in light, ") + (isThick ? "thick" : "thin") + projection, lit,
        { isThick ? 0.5 : 0.06, 0.0015 });
    }
  }
}

}

int TestShadowCuts(int, char*[])
{
  Check check;
  TestSubvolume(check);
  TestExtracted(check);
  TestGaps(check);
  TestLitGaps(check);
  TestCameraPlanes(check);
  return check.Result();
}
