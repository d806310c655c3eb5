// SPDX-License-Identifier: BSD-3-Clause
// UseDepthPeelingForVolumes: neither mapper can draw between two peels, so each draws the picture
// that it draws without, and says so once.
#include "Support/Drawing/PictureCases.h"
#include "Support/Pictures/ShadowCases.h"
#include "Support/Drawing/ShadowPicture.h"
#include "Support/Pictures/VolumeStage.h"
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

/// Pictures without and with peeling of volumes, with and without a translucent ball in the scene.
void TestMapper(Check& check, const std::string& name, vtkAbstractVolumeMapper* mapper,
  vtkVolumeProperty* property, vtkCamera* camera, const Double3& middle)
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
  sphere->SetCenter(middle[0], middle[1], middle[2] + 0.3);
  sphere->SetRadius(0.4);
  vtkNew<vtkPolyDataMapper> polygons;
  polygons->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(polygons);
  ball->GetProperty()->SetOpacity(0.4);
  ball->GetProperty()->SetColor(0.9, 0.3, 0.2);

  for (const bool hasBall : { true, false })
  {
    if (hasBall)
    {
      renderer->AddActor(ball);
    }
    else
    {
      renderer->RemoveActor(ball);
    }
    renderer->SetUseDepthPeelingForVolumes(false);
    const RgbaPicture expected = ReadWindow(stage.GetWindow());
    check.That(!observer->GetWarning() && !observer->GetError(), name + ": nothing to say");
    renderer->SetUseDepthPeelingForVolumes(true);
    for (int frame = 0; frame < 2; ++frame)
    {
      const PictureError error = ComparePictures(ReadWindow(stage.GetWindow()), expected);
      const std::string context =
        name + (hasBall ? ", with" : ", without") + " polygons, frame " + std::to_string(frame);
      std::cout << context << ": " << error << std::endl;
      // Bytes, which peels round differently.
      check.Near(error.Max, 0.0, 2.5 / 255.0, context, 1.0);
      check.That(observer->GetWarning() == (hasBall && frame == 0) && !observer->GetError(),
        context + ": one warning");
      observer->Clear();
    }
  }
  renderer->RemoveAllViewProps();
  const RgbaPicture empty = ReadWindow(stage.GetWindow());
  check.Near(empty.At(Size[0] / 2, Size[1] / 2)[0], 0.3, 0.005, name + ": nothing is left", 1.0);
}

}

int TestVolumePeeling(int, char*[])
{
  Check check;
  const auto scene = MakeScene(MakeImage(16, MakeSphere(0.1, 0.45)), MakeSoftProperty(0.4, true));
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
