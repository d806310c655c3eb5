// SPDX-License-Identifier: BSD-3-Clause
// A surface of dense matter where light passes the plane across the view, so that slices go from
// front to back on one side of it and from back to front on the other: the picture is the same.
#include "Support/Pictures/VolumeStage.h"
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

// The distance to the surface of a ball of radius 0.4, in voxels, positive inside.
vtkSmartPointer<vtkImageData> MakeBallImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(VOXELS + 1, VOXELS + 1, VOXELS + 1);
  image->SetOrigin(-0.5, -0.5, -0.5);
  image->SetSpacing(VOXEL, VOXEL, VOXEL);
  vtkNew<vtkFloatArray> values;
  values->SetName("Depth");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* place = image->GetPoint(i);
    const double depth = (0.4 - vtkMath::Norm(place)) / VOXEL;
    values->InsertNextValue(static_cast<float>(std::min(std::max(depth, -3.0), 3.0)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

// Matter that gets dense within three voxels: a slice is thick, and its function is no step.
vtkSmartPointer<vtkVolumeProperty> MakeMatter(double opacity)
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
  /// Slices, in voxels.
  double Spacing;
  /// What the means of both sides may differ by, as a share.
  double Bound;
  /// Whether light gets a colour inside.
  bool IsColored = false;
};

double GetMean(const RgbaPicture& picture)
{
  double sum = 0.0;
  for (std::size_t k = 0; k < picture.Values.size(); k += 4)
  {
    sum += picture.Values[k] + picture.Values[k + 1] + picture.Values[k + 2];
  }
  return 4.0 / 3.0 * sum / static_cast<double>(picture.Values.size());
}

void TestSides(Check& check, const Case& matter)
{
  check.SetContext(matter.Name);
  constexpr int pixels = 96;
  VolumeStage stage(std::array<int, 2>{ { pixels, pixels } });
  vtkNew<vtkShadowedSliceMapper> mapper;
  mapper->SetInputData(MakeBallImage());
  mapper->SetSliceSpacing(matter.Spacing * VOXEL);
  mapper->SetLightBufferSize(192);
  if (matter.IsColored)
  {
    vtkNew<vtkColorTransferFunction> transmission;
    transmission->AddRGBPoint(0.0, 0.6, 0.3, 0.1);
    mapper->SetTransmissionColor(transmission);
  }
  mapper->AutoAdjustSampleDistancesOff();
  stage.SetVolume(mapper, MakeMatter(matter.Opacity));
  vtkNew<vtkCamera> camera;
  camera->SetParallelProjection(1);
  camera->SetParallelScale(0.5);
  camera->SetPosition(0.0, 0.0, 4.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetClippingRange(1.0, 8.0);
  stage.SetCamera(camera);
  // The eye looks along -z.
  constexpr double tiny = 1e-4;
  stage.SetLights({ MakeSun({ { 0.8, 0.6, -tiny } }) });
  const double along = GetMean(stage.Capture());
  check.Near(mapper->GetReport()->GetNumber("FrontToBackSweeps"), 1, 0.0,
    "sweeps from front to back, with the view");
  stage.SetLights({ MakeSun({ { 0.8, 0.6, tiny } }) });
  const double against = GetMean(stage.Capture());
  check.Near(mapper->GetReport()->GetNumber("FrontToBackSweeps"), 0, 0.0,
    "sweeps from front to back, against it");
  std::cout << matter.Name << ": mean " << along << " from front to back, " << against / along - 1.0
            << " more from back to front" << std::endl;
  check.That(along > 0.05, "there is light to be seen");
  check.Near(against, along, matter.Bound, "mean from back to front");
}

}

int TestShadowSides(int, char*[])
{
  Check check;
  // What is left falls with the distance of slices.
  TestSides(check, { "dense, slices of two voxels", 0.998, 2.0, 0.08 });
  TestSides(check, { "dense, slices of half a voxel", 0.998, 0.5, 0.01 });
  TestSides(check, { "dense, slices of a quarter of a voxel", 0.998, 0.25, 0.003 });
  TestSides(check, { "smoke, slices of a voxel", 0.2, 1.0, 0.002 });
  TestSides(check, { "dense and coloured, slices of a voxel", 0.998, 1.0, 0.03, true });
  return check.Result();
}
