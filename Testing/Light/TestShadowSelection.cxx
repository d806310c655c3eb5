// SPDX-License-Identifier: BSD-3-Clause
// vtkHardwareSelector finds a sliced volume at pixels that show it, and a prop at pixels where it
// hides the volume.
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
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

/// Returns the prop at a position in the image, with coordinates from 0 to 1.
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
  const unsigned int pixel[2] = { static_cast<unsigned int>(x * size[0]),
    static_cast<unsigned int>(y * size[1]) };
  return selector->GetPixelInformation(pixel, 0).Prop;
}
}

int TestShadowSelection(int, char*[])
{
  Check check;
  const ShadowScene scene =
    MakeScene(MakeImage(16, MakeSphere(0.15, 0.45)), MakeTranslucentProperty(0.6, true));
  vtkNew<vtkShadowedSliceMapper> mapper;
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  stage.Render();
  const auto isVolume = [](vtkProp* prop) { return prop && prop->IsA("vtkVolume"); };
  check.That(isVolume(FindProp(stage, 0.5, 0.5)), "the volume at the center");
  check.That(FindProp(stage, 0.02, 0.02) == nullptr, "no prop in the corner");
  check.Equal(mapper->GetReport()->GetCount("LightPasses"), 0, "a selection has no light passes");

  // A sphere between the volume and the camera, which looks along (-0.3, -0.4, -1).
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.24, 0.32, 0.8);
  sphere->SetRadius(0.1);
  vtkNew<vtkPolyDataMapper> surface;
  surface->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(surface);
  stage.AddActor(actor);
  check.That(FindProp(stage, 0.5, 0.5) == actor, "the sphere in front of the volume");
  check.That(isVolume(FindProp(stage, 0.62, 0.5)), "the volume next to the sphere");
  stage.Render();
  check.That(mapper->GetReport()->GetNumber("LightPasses") > 0, "the next image has light passes");
  return check.Result();
}
