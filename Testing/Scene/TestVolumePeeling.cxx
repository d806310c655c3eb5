// SPDX-License-Identifier: BSD-3-Clause
// UseDepthPeelingForVolumes: the mappers cannot draw between two peels. Each mapper draws the same
// frame as without the option, and warns once.
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <iostream>
#include <string>

namespace
{

using namespace reference;

constexpr std::array<int, 2> Size = { { 64, 64 } };

/// Compares frames with and without volume peeling, with and without a translucent sphere.
void TestMapper(Check& check, const std::string& name, vtkAbstractVolumeMapper* mapper,
  vtkVolumeProperty* property, vtkCamera* camera, const Double3& center)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::WarningEvent, observer);
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  VolumeStage stage(Size);
  stage.SetVolume(mapper, property);
  stage.SetLights({ MakeDirectionalLight({ { 1.0, -1.0, -1.0 } }) });
  stage.SetCamera(camera);
  vtkRenderer* renderer = stage.GetRenderer();
  renderer->SetBackground(0.3, 0.4, 0.5);
  renderer->SetUseDepthPeeling(1);
  renderer->SetOcclusionRatio(0.0);
  stage.GetWindow()->SetAlphaBitPlanes(1);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center[0], center[1], center[2] + 0.3);
  sphere->SetRadius(0.4);
  vtkNew<vtkPolyDataMapper> polygons;
  polygons->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(polygons);
  actor->GetProperty()->SetOpacity(0.4);
  actor->GetProperty()->SetColor(0.9, 0.3, 0.2);

  for (const bool hasSphere : { true, false })
  {
    if (hasSphere)
    {
      renderer->AddActor(actor);
    }
    else
    {
      renderer->RemoveActor(actor);
    }
    renderer->SetUseDepthPeelingForVolumes(false);
    const RgbaImage expected = stage.CaptureBytes();
    check.That(!observer->GetWarning() && !observer->GetError(), name + ": no warnings or errors");
    renderer->SetUseDepthPeelingForVolumes(true);
    for (int frame = 0; frame < 2; ++frame)
    {
      const ImageError error = CompareImages(stage.CaptureBytes(), expected);
      const std::string context =
        name + (hasSphere ? ", with" : ", without") + " polygons, frame " + std::to_string(frame);
      std::cout << context << ": " << error << std::endl;
      // Peeling rounds 8-bit colors differently.
      check.Near(error.Max, 0.0, 2.5 / 255.0, context, 1.0);
      check.That(observer->GetWarning() == (hasSphere && frame == 0) && !observer->GetError(),
        context + ": one warning, in the first frame with polygons");
      observer->Clear();
    }
  }
  renderer->RemoveAllViewProps();
  const RgbaImage empty = stage.CaptureBytes();
  check.Near(empty.At(Size[0] / 2, Size[1] / 2)[0], 0.3, 0.005,
    name + ": the window shows only the background", 1.0);
}

}

int TestVolumePeeling(int, char*[])
{
  Check check;
  const auto scene =
    MakeScene(MakeImage(16, MakeSphere(0.1, 0.45)), MakeTranslucentProperty(0.4, true));
  vtkNew<vtkShadowedSliceMapper> slices;
  slices->SetInputData(scene.Image);
  TestMapper(check, "slices", slices, scene.Property, scene.Camera, { { 0.0, 0.0, 0.0 } });

  const auto grid = MakeCube(3);
  for (const int path : { vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH,
         vtkTimeWeightedTetrahedraMapper::OPENGL_PATH })
  {
    vtkNew<vtkTimeWeightedTetrahedraMapper> tetrahedra;
    tetrahedra->SetInputData(grid);
    tetrahedra->SetRenderPath(path);
    TestMapper(check, "tetrahedra by path " + std::to_string(path), tetrahedra, MakeRamp(0.0, 2.0),
      LookAt(grid, { { -0.3, -0.4, -1.0 } }, false), { { 0.5, 0.5, 0.5 } });
  }
  return check.Result();
}
