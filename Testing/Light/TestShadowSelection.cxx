// SPDX-License-Identifier: BSD-3-Clause
// vtkHardwareSelector finds a volume in slices where a line of sight meets it, and a prop before
// it.
#include "Support/Pictures/ShadowCases.h"
#include "Support/Drawing/ShadowPicture.h"
#include "Support/Pictures/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSphereSource.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
using namespace reference;

/// The prop at a place of the picture, 0 to 1.
vtkProp* FindProp(VolumeStage& stage, double x, double y)
{
  const int* size = stage.GetWindow()->GetSize();
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.GetRenderer());
  selector->SetArea(
    0, 0, static_cast<unsigned int>(size[0] - 1), static_cast<unsigned int>(size[1] - 1));
  if (!selector->CaptureBuffers())
  {
    return nullptr;
  }
  const unsigned int place[2] = { static_cast<unsigned int>(x * size[0]),
    static_cast<unsigned int>(y * size[1]) };
  return selector->GetPixelInformation(place, 0).Prop;
}
}

int TestShadowSelection(int, char*[])
{
  Check check;
  const ShadowScene scene =
    MakeScene(MakeImage(16, MakeSphere(0.15, 0.45)), MakeSoftProperty(0.6, true));
  vtkNew<vtkShadowedSliceMapper> mapper;
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  stage.Render();
  const auto isVolume = [](vtkProp* prop) { return prop && prop->IsA("vtkVolume"); };
  check.That(isVolume(FindProp(stage, 0.5, 0.5)), "the volume in the middle");
  check.That(FindProp(stage, 0.02, 0.02) == nullptr, "nothing in the corner");
  check.Near(mapper->GetReport()->GetNumber("LightPasses"), 0, 0.0, "light passes of a selection");

  // A ball towards the eye, which looks along (-0.3, -0.4, -1).
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.24, 0.32, 0.8);
  sphere->SetRadius(0.1);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(surface);
  stage.AddActor(ball);
  check.That(FindProp(stage, 0.5, 0.5) == ball, "the ball before the volume");
  check.That(isVolume(FindProp(stage, 0.62, 0.5)), "the volume beside the ball");
  stage.Render();
  check.That(mapper->GetReport()->GetNumber("LightPasses") > 0, "light passes of the next picture");
  return check.Result();
}
