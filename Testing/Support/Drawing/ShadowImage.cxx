// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Drawing/ShadowImage.h"

#include "Support/Images/VolumeStage.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace reference
{

void Configure(vtkShadowedSliceMapper* mapper, const ShadowScene& scene)
{
  mapper->SetInputData(scene.Image);
  const bool ofCells = scene.Array.OfCells;
  if (scene.Array.Name.empty())
  {
    mapper->SetScalarMode(ofCells ? VTK_SCALAR_MODE_USE_CELL_DATA : VTK_SCALAR_MODE_USE_POINT_DATA);
  }
  else
  {
    mapper->SetScalarMode(
      ofCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
    mapper->SelectScalarArray(scene.Array.Name.c_str());
  }
  mapper->SetShadows(scene.Shadows);
  mapper->SetTransmissionColor(scene.TransmissionColor);
  mapper->SetCropping(scene.CroppingFlags != 0);
  mapper->SetCroppingRegionFlags(scene.CroppingFlags);
  mapper->SetCroppingRegionPlanes(scene.CroppingPlanes.data());
  mapper->RemoveAllClippingPlanes();
  for (vtkPlane* plane : scene.ClippingPlanes)
  {
    mapper->AddClippingPlane(plane);
  }
}

void SetScene(VolumeStage& stage, vtkShadowedSliceMapper* mapper, const ShadowScene& scene)
{
  Configure(mapper, scene);
  stage.SetVolume(mapper, scene.Property);
  stage.GetVolume()->SetUserMatrix(scene.Matrix);
  stage.SetCamera(scene.Camera);
  stage.SetLights(scene.Lights);
  for (vtkActor* actor : scene.Actors)
  {
    stage.AddActor(actor);
  }
}

RgbaImage DrawByMapper(vtkShadowedSliceMapper* mapper, const ShadowScene& scene)
{
  VolumeStage stage(scene.Size);
  SetScene(stage, mapper, scene);
  return stage.Capture();
}

}
