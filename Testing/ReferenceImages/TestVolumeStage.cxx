// SPDX-License-Identifier: BSD-3-Clause
// Compares floating-point images of VTK's mappers with the reference, within the rounding error of
// each mapper.
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/ReferenceVolumeImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkProjectedTetrahedraMapper.h"
#include "vtkRenderer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridVolumeMapper.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <cmath>
#include <iostream>

namespace
{

using namespace reference;

constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };

/// Returns true if a channel has a value that 8 bits cannot represent.
bool IsFinerThanBytes(const RgbaImage& image)
{
  for (double value : image.Values)
  {
    const double steps = 255.0 * value;
    if (std::abs(steps - std::round(steps)) > 1e-3)
    {
      return true;
    }
  }
  return false;
}

void Compare(
  Check& check, vtkUnstructuredGridVolumeMapper* mapper, vtkUnstructuredGrid* grid, bool parallel)
{
  // The opacity function is at most 1, since VTK's mappers store opacity in 8 bits.
  auto property = MakeRamp(0.1, 1.0, 0.5);
  auto camera = LookAt(grid, Slanted, parallel);
  CameraSettings settings;
  settings.Size = { { 96, 64 } };
  const RgbaImage expected = MakeReferenceImage(grid, property, camera, settings);
  VolumeStage stage(settings.Size);
  mapper->SetInputData(static_cast<vtkDataSet*>(grid));
  stage.SetVolume(mapper, property);
  stage.SetCamera(camera);
  const RgbaImage found = stage.Capture(2);
  const ImageError error = CompareImages(found, expected);
  const std::string name =
    std::string(mapper->GetClassName()) + (parallel ? ", parallel" : ", perspective");
  std::cout << name << ": " << error << '\n';
  check.That(LargestAlpha(found) > 0.5, name + " is visible");
  check.Near(error.Max, 0.0, 0.04, name + ", largest error", 1.0);
  check.Near(error.Mean, 0.0, 0.002, name + ", mean error", 1.0);
  check.That(IsFinerThanBytes(found), name + " is captured in floating point");
}

/// Setting the same lights again does not modify the renderer's light collection, so no mapper
/// detects a change.
void TestLights(Check& check)
{
  check.SetContext("lights");
  const std::array<int, 2> size = { { 8, 8 } };
  VolumeStage stage(size);
  const auto first = vtkSmartPointer<vtkLight>::New();
  const auto second = vtkSmartPointer<vtkLight>::New();
  vtkLightCollection* lights = stage.GetRenderer()->GetLights();
  stage.SetLights({ first, second });
  const vtkMTimeType before = lights->GetMTime();
  stage.SetLights({ first, second });
  check.That(lights->GetMTime() == before, "the same lights do not modify the collection");
  stage.SetLights({ second, first });
  check.That(lights->GetMTime() > before, "another order modifies the collection");
  check.That(lights->GetItemAsObject(0) == second.Get(), "the lights have the new order");
  stage.SetLights({ second });
  check.Equal(lights->GetNumberOfItems(), 1, "one light remains");
  stage.SetLights({});
  check.Equal(lights->GetNumberOfItems(), 0, "no lights remain");
  VolumeStage dark(size);
  dark.SetLights({});
  check.That(!dark.GetRenderer()->GetAutomaticLightCreation(), "no light is created automatically");
}
}

int TestVolumeStage(int, char*[])
{
  Check check;
  for (bool parallel : { true, false })
  {
    auto grid = MakeCube(4);
    vtkNew<vtkProjectedTetrahedraMapper> projected;
    Compare(check, projected, grid, parallel);
  }
  TestLights(check);
  return check.Result();
}
