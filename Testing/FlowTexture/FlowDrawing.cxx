// SPDX-License-Identifier: BSD-3-Clause
#include "FlowDrawing.h"

#include "Pictures/VolumeStage.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkVolumeProperty.h"

namespace reference
{

RgbaPicture DrawFlow(vtkImplicitFlowVolumeMapper* mapper, vtkImageData* voxels,
  const FlowScene& scene, vtkVolumeProperty* property)
{
  vtkNew<vtkVolumeProperty> plain;
  vtkVolumeProperty* used = property ? property : plain.Get();
  used->SetScalarOpacityUnitDistance(scene.UnitDistance);
  mapper->SetInputData(static_cast<vtkDataSet*>(voxels));
  VolumeStage stage(scene.Size);
  stage.SetVolume(mapper, used);
  stage.SetCamera(scene.Camera);
  const RgbaPicture picture = stage.Capture();
  mapper->ReleaseGraphicsResources(nullptr);
  return picture;
}

}
