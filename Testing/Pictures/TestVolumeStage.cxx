// SPDX-License-Identifier: BSD-3-Clause
// Pictures in floating point of VTK's mappers, against the reference within what each of them
// rounds.
#include "Support/Drawing/PictureCases.h"
#include "Support/Pictures/ReferenceVolumePicture.h"
#include "Support/Pictures/VolumeStage.h"
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

/// Whether a picture has a channel that 8 bits cannot hold.
bool IsFinerThanBytes(const RgbaPicture& picture)
{
  for (double value : picture.Values)
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
  // Opacity to 1: VTK's mapper keeps it in 8 bits.
  auto property = MakeRamp(0.1, 1.0, 0.5);
  auto camera = LookAt(grid, Slanted, parallel);
  PictureSettings settings;
  settings.Size = { { 96, 64 } };
  const RgbaPicture expected = MakeReferencePicture(grid, property, camera, settings);
  VolumeStage stage(settings.Size);
  mapper->SetInputData(static_cast<vtkDataSet*>(grid));
  stage.SetVolume(mapper, property);
  stage.SetCamera(camera);
  const RgbaPicture found = stage.Capture();
  const PictureError error = ComparePictures(found, expected);
  const std::string name =
    std::string(mapper->GetClassName()) + (parallel ? ", parallel" : ", perspective");
  std::cout << name << ": " << error << '\n';
  check.That(LargestAlpha(found) > 0.5, name + " is seen");
  check.Near(error.Max, 0.0, 0.04, name + ", largest error", 1.0);
  check.Near(error.Mean, 0.0, 0.002, name + ", mean error", 1.0);
  check.That(IsFinerThanBytes(found), name + " is captured in floating point");
}

/// The same lights leave the renderer's collection as it is, so that no mapper takes it for a
/// change.
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
  check.That(lights->GetMTime() == before, "the same lights are no change");
  stage.SetLights({ second, first });
  check.That(lights->GetMTime() > before, "another order is a change");
  check.That(lights->GetItemAsObject(0) == second.Get(), "the first in that order");
  stage.SetLights({ second });
  check.Equal(lights->GetNumberOfItems(), 1, "one of them");
  stage.SetLights({});
  check.Equal(lights->GetNumberOfItems(), 0, "none");
  VolumeStage dark(size);
  dark.SetLights({});
  check.That(!dark.GetRenderer()->GetAutomaticLightCreation(), "none, and none by itself");
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
