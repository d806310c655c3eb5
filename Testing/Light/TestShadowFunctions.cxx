// SPDX-License-Identifier: BSD-3-Clause
// Transfer functions of vtkShadowedSliceMapper with details finer than the data range: one outlier
// voxel, peaks and steps as narrow as one 16-bit unit, curved functions.
#include "Light/ShadowComparison.h"
#include "Support/Images/CameraSettings.h"
#include "Support/Images/ReferenceShadowImage.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkUnsignedShortArray.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <string>

namespace
{

using namespace reference;

constexpr int Cells = 24;

void ToShorts(vtkImageData* image)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedShortArray> shorts;
  shorts->SetName("f");
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    shorts->InsertNextValue(static_cast<unsigned short>(std::lround(values->GetComponent(id, 0))));
  }
  image->GetPointData()->SetScalars(shorts);
}

/// Returns a scene with a sphere whose values are 0 outside and increase to 255 near the center.
ShadowScene SphereScene(bool shade)
{
  const Field sphere = MakeSphere(0.1, 0.45);
  auto scene = MakeScene(MakeImage(Cells, [&](const Double3& x) { return 255.0 * sphere(x); }),
    MakeProperty({ { 0.0, { { 0.2, 0.3, 0.9 } }, 0.0 }, { 100.0, { { 0.9, 0.2, 0.2 } }, 0.1 },
                   { 255.0, { { 0.9, 0.7, 0.4 } }, 0.5 } },
      0.1));
  scene.Property->SetShade(shade ? 1 : 0);
  scene.Property->SetAmbient(0.2);
  scene.Size = { { 48, 48 } };
  return scene;
}

/// An outlier with the same material as its neighbors does not change the image.
void TestOutlier(Check& check)
{
  for (bool shade : { false, true })
  {
    for (double outlier : { 65535.0, 1e7, 1e30 })
    {
      auto scene = SphereScene(shade);
      if (outlier == 65535.0)
      {
        ToShorts(scene.Image);
      }
      vtkNew<vtkShadowedSliceMapper> without;
      const RgbaImage expected = DrawByMapper(without, scene);
      vtkDataArray* values = scene.Image->GetPointData()->GetScalars();
      values->SetComponent(values->GetNumberOfTuples() / 2, 0, outlier);
      values->Modified();
      scene.Image->Modified();
      const std::string name =
        "a voxel of " + std::to_string(outlier) + (shade ? ", shaded" : ", not shaded");
      vtkNew<vtkShadowedSliceMapper> with;
      const RgbaImage found = DrawByMapper(with, scene);
      if (!shade)
      {
        ExpectSimilar(check, name, found, expected, { 1e-4, 1e-5 });
      }
      ExpectSimilarToReference(check, name + ", reference", scene, { 6e-3, 2e-4 });
    }
  }
}

/// Returns 16-bit values that increase from 30000 to 30012 along a diagonal. Outliers of 0 and
/// 65535 along a cropped edge widen the data range.
ShadowScene GentleScene(vtkVolumeProperty* property)
{
  auto scene = MakeScene(MakeImage(Cells,
                           [](const Double3& x)
                           {
                             const bool isEnd = x[0] == 0.0 && x[1] == 0.0;
                             return isEnd ? 65535.0 * std::floor(x[2] + 0.5)
                                          : 30000.0 + 6.0 * (x[0] + 1.0 - x[2]);
                           }),
    property);
  scene.CroppingFlags = VTK_CROP_SUBVOLUME;
  scene.CroppingPlanes = { { -0.44, 0.5, -0.44, 0.5, -0.5, 0.5 } };
  scene.Size = { { 48, 48 } };
  return scene;
}

/// Compares a frame with the reference. Both use slabs so thin that their thickness has no effect.
void ExpectThin(
  Check& check, const std::string& name, const ShadowScene& scene, const ImageBound& bound)
{
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetSliceSpacing(0.002);
  ExpectSimilar(check, name, DrawByMapper(mapper, scene), MakeShadowImage(scene, 8), bound);
}

void TestPeaks(Check& check)
{
  const Double3 red = { { 0.9, 0.2, 0.1 } };
  const Double3 blue = { { 0.1, 0.3, 0.9 } };
  std::vector<FunctionNode> nodes = { { 0.0, blue, 0.0 } };
  for (double peak : { 30002.5, 30005.0, 30009.25 })
  {
    nodes.push_back({ peak - 0.5, blue, 0.0 });
    nodes.push_back({ peak, red, 0.7 });
    nodes.push_back({ peak + 0.5, blue, 0.0 });
  }
  nodes.push_back({ 65535.0, blue, 0.0 });
  auto scene = GentleScene(MakeProperty(nodes, 0.1));
  scene.Shadows = false;
  ExpectThin(check, "peaks, floating-point values", scene, { 5e-3, 2e-4 });
  ToShorts(scene.Image);
  ExpectThin(check, "peaks, 16-bit values", scene, { 5e-3, 5e-4 });
}

void TestSteps(Check& check)
{
  const Double3 red = { { 0.9, 0.2, 0.1 } };
  const Double3 blue = { { 0.1, 0.3, 0.9 } };
  constexpr double edge = 1e-3;
  auto scene = GentleScene(MakeProperty(
    { { 0.0, blue, 0.0 }, { 30003.5 - edge, blue, 0.0 }, { 30003.5 + edge, blue, 0.3 },
      { 30006.4 - edge, blue, 0.3 }, { 30006.4 + edge, red, 0.3 }, { 30008.25 - edge, red, 0.3 },
      { 30008.25 + edge, red, 0.0 }, { 65535.0, red, 0.0 } },
    0.1));
  scene.Shadows = false;
  ExpectThin(check, "steps, floating-point values", scene, { 1e-2, 4e-4 });
  ToShorts(scene.Image);
  ExpectThin(check, "steps, 16-bit values", scene, { 1e-2, 4e-4 });

  // Two consecutive integer values, one in each half of the volume.
  auto halves = GentleScene(MakeProperty({ { 0.0, blue, 0.0 }, { 30006.5 - edge, blue, 0.02 },
                                           { 30006.5 + edge, red, 0.3 }, { 65535.0, red, 0.3 } },
    0.1));
  halves.Image = MakeImage(Cells,
    [](const Double3& x)
    {
      const bool isEnd = x[0] == 0.0 && x[1] == 0.0;
      return isEnd ? 65535.0 * std::floor(x[2] + 0.5) : 30006.0 + (x[0] > 0.5 ? 1.0 : 0.0);
    });
  ToShorts(halves.Image);
  halves.Shadows = false;
  ExpectThin(check, "consecutive 16-bit values", halves, { 1e-2, 2e-4 });
}

/// Tests gradient opacity, colored transmission and an unclamped opacity function, all in one scene
/// with an outlier.
void TestOthers(Check& check)
{
  auto scene = SphereScene(false);
  scene.TransmissionColor = vtkSmartPointer<vtkColorTransferFunction>::New();
  scene.TransmissionColor->AddRGBPoint(0.0, 0.1, 0.5, 0.9);
  scene.TransmissionColor->AddRGBPoint(255.0, 0.8, 0.2, 0.5);
  vtkNew<vtkPiecewiseFunction> gradients;
  gradients->AddPoint(0.0, 0.0);
  gradients->AddPoint(20.0, 1.0);
  scene.Property->SetGradientOpacity(gradients);
  scene.Property->GetScalarOpacity()->ClampingOff();
  scene.Image->GetPointData()->GetScalars()->SetComponent(0, 0, 1e7);
  ExpectSimilarToReference(check,
    "an outlier with gradient opacity, transmission and unclamped ends", scene, { 3e-3, 2e-4 });
}

/// Returns an image with the same values at the same positions, but with axes reversed by negative
/// spacing or by the direction matrix.
vtkSmartPointer<vtkImageData> Reverse(
  vtkImageData* image, const std::array<bool, 3>& isReversed, bool isByDirection)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->CopyStructure(image);
  Double3 spacing;
  Double3 origin;
  image->GetSpacing(spacing.data());
  image->GetOrigin(origin.data());
  std::array<double, 9> direction{ { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } };
  const int* size = image->GetDimensions();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (isReversed[axis])
    {
      origin[axis] += (size[axis] - 1) * spacing[axis];
      (isByDirection ? direction[4 * axis] : spacing[axis]) *= -1.0;
    }
  }
  result->SetOrigin(origin.data());
  result->SetSpacing(spacing.data());
  result->SetDirectionMatrix(direction.data());
  vtkDataArray* from = image->GetPointData()->GetScalars();
  const auto to = vtkSmartPointer<vtkDataArray>::Take(from->NewInstance());
  to->SetName(from->GetName());
  to->SetNumberOfComponents(from->GetNumberOfComponents());
  to->SetNumberOfTuples(from->GetNumberOfTuples());
  for (vtkIdType id = 0; id < from->GetNumberOfTuples(); ++id)
  {
    int index[3] = { static_cast<int>(id % size[0]), static_cast<int>(id / size[0] % size[1]),
      static_cast<int>(id / size[0] / size[1]) };
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = isReversed[axis] ? size[axis] - 1 - index[axis] : index[axis];
    }
    to->SetTuple(id, image->ComputePointId(index), from);
  }
  result->GetPointData()->SetScalars(to);
  return result;
}

/// Gradients, shading and multiple scattering do not depend on the order of samples.
void TestReversed(Check& check)
{
  // The three spacings have a mean of 0 if only the z axis is reversed by negative spacing.
  auto scene =
    MakeScene(MakeImage({ { 16, 22, 10 } }, { { 0.06, 0.04, 0.1 } },
                [](const Double3& x) { return MakeSphere(0.05, 0.45)(x) * (0.4 + 0.6 * x[0]); }),
      MakeTranslucentProperty(0.8, true));
  scene.Size = { { 48, 48 } };
  vtkNew<vtkPiecewiseFunction> gradients;
  gradients->AddPoint(0.0, 0.0);
  gradients->AddPoint(0.12, 1.0);
  scene.Property->SetGradientOpacity(gradients);
  ExpectSimilarToReference(check, "gradients, anisotropic voxels", scene, { 0.02, 6e-4 });
  for (const bool isScattered : { false, true })
  {
    const auto draw = [&](vtkImageData* image)
    {
      auto drawn = scene;
      drawn.Image = image;
      vtkNew<vtkShadowedSliceMapper> mapper;
      mapper->SetScatteringMode(isScattered ? vtkShadowedSliceMapper::FULL_SCATTERING
                                            : vtkShadowedSliceMapper::NO_SCATTERING);
      return DrawByMapper(mapper, drawn);
    };
    const RgbaImage expected = draw(scene.Image);
    for (const bool isByDirection : { false, true })
    {
      for (const std::array<bool, 3>& isReversed : { std::array<bool, 3>{ { false, false, true } },
             std::array<bool, 3>{ { true, true, false } },
             std::array<bool, 3>{ { true, true, true } } })
      {
        const std::string name = std::string(isReversed[0] ? "x" : "") +
          (isReversed[1] ? "y" : "") + (isReversed[2] ? "z" : "") + " reversed by " +
          (isByDirection ? "direction" : "spacing") + (isScattered ? ", scattered" : "");
        ExpectSimilar(check, name, draw(Reverse(scene.Image, isReversed, isByDirection)), expected,
          isScattered ? ImageBound{ 5e-3, 2e-4 } : ImageBound{ 1e-4, 1e-5 });
      }
    }
  }
}

}

int TestShadowFunctions(int, char*[])
{
  Check check;
  TestOutlier(check);
  TestPeaks(check);
  TestSteps(check);
  TestOthers(check);
  TestReversed(check);
  return check.Result();
}
