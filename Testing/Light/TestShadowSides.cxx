// SPDX-License-Identifier: BSD-3-Clause
// The image of a dense surface changes continuously when a light crosses the plane perpendicular to
// the view. Slices are drawn from front to back on one side of this plane, and from back to front
// on the other side.
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"
#include "SceneStage.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>

namespace
{
using namespace reference;

constexpr int VOXELS = 24;
constexpr double VOXEL = 1.0 / VOXELS;

// Returns a vtkImageData of distances to a sphere of radius 0.4, in voxels, positive inside the
// sphere.
vtkSmartPointer<vtkImageData> MakeSphereImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(VOXELS + 1, VOXELS + 1, VOXELS + 1);
  image->SetOrigin(-0.5, -0.5, -0.5);
  image->SetSpacing(VOXEL, VOXEL, VOXEL);
  vtkNew<vtkFloatArray> values;
  values->SetName("Depth");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* position = image->GetPoint(i);
    const double depth = (0.4 - vtkMath::Norm(position)) / VOXEL;
    values->InsertNextValue(static_cast<float>(std::min(std::max(depth, -3.0), 3.0)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

// Returns a medium that becomes dense within three voxels. Slices are optically thick, but the
// opacity function has no step.
vtkSmartPointer<vtkVolumeProperty> MakeMedium(double opacity)
{
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(-1.0, 0.0);
  opacities->AddPoint(2.0, opacity);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(VOXEL);
  property->SetColor(colors);
  property->SetInterpolationTypeToLinear();
  property->SetShade(0);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  return property;
}

struct Case
{
  std::string Name;
  double Opacity;
  /// Slice spacing in voxels.
  double Spacing;
  /// Allowed relative difference in mean brightness between front-to-back and back-to-front order.
  double Bound;
  /// True if the medium has a transmission color.
  bool IsColored = false;
};

double GetMean(const RgbaImage& rendered)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < rendered.Values.size(); k += 4)
  {
    sum += rendered.Values[k] + rendered.Values[k + 1] + rendered.Values[k + 2];
  }
  return 4.0 / 3.0 * sum / static_cast<double>(rendered.Values.size());
}

void TestSides(Check& check, const Case& settings)
{
  check.SetContext(settings.Name);
  constexpr int pixels = 96;
  VolumeStage stage(std::array<int, 2>{ { pixels, pixels } });
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputData(MakeSphereImage());
  mapper->SetSliceSpacing(settings.Spacing * VOXEL);
  mapper->SetLightBufferSize(192);
  if (settings.IsColored)
  {
    vtkNew<vtkColorTransferFunction> transmission;
    transmission->AddRGBPoint(0.0, 0.6, 0.3, 0.1);
    mapper->SetTransmissionColor(transmission);
  }
  mapper->AutoAdjustSampleDistancesOff();
  stage.SetVolume(mapper, MakeMedium(settings.Opacity));
  vtkNew<vtkCamera> camera;
  camera->SetParallelProjection(1);
  camera->SetParallelScale(0.5);
  camera->SetPosition(0.0, 0.0, 4.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(1.0, 8.0);
  stage.SetCamera(camera);
  // The camera looks along -z, so the sign of the light's z direction determines the slice order.
  constexpr double tiny = 1e-4;
  stage.SetLights({ MakeSun({ { 0.8, 0.6, -tiny } }) });
  const double along = GetMean(stage.Capture());
  check.Equal(mapper->GetReport()->GetCount("FrontToBackSweeps"), 1,
    "front-to-back sweeps, light along the view");
  stage.SetLights({ MakeSun({ { 0.8, 0.6, tiny } }) });
  const double against = GetMean(stage.Capture());
  check.Equal(mapper->GetReport()->GetCount("FrontToBackSweeps"), 0,
    "front-to-back sweeps, light against the view");
  std::cout << settings.Name << ": mean " << along << " front to back, relative difference "
            << against / along - 1.0 << " back to front" << std::endl;
  check.That(along > 0.05, "the image is not black");
  check.Near(against, along, settings.Bound, "mean of back to front");
}

}

int TestShadowSides(int, char*[])
{
  Check check;
  // The difference in brightness between front-to-back and back-to-front order decreases with the
  // slice spacing.
  TestSides(check, { "dense, spacing of two voxels", 0.998, 2.0, 0.08 });
  TestSides(check, { "dense, spacing of half a voxel", 0.998, 0.5, 0.01 });
  TestSides(check, { "dense, spacing of a quarter of a voxel", 0.998, 0.25, 0.003 });
  TestSides(check, { "smoke, spacing of one voxel", 0.2, 1.0, 0.002 });
  TestSides(check, { "dense and colored, spacing of one voxel", 0.998, 1.0, 0.03, true });
  return check.Result();
}
