// SPDX-License-Identifier: BSD-3-Clause
// The window can abort vtkShadowedSliceMapper while it renders, and later frames are not affected.
#include "Support/Drawing/DrawingAborts.h"
#include "Support/Images/ShadowCases.h"
#include "Support/Drawing/ShadowImage.h"
#include "Support/Images/VolumeStage.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkVolumeProperty.h"

int TestShadowAbort(int, char*[])
{
  using namespace reference;
  Check check;
  for (const bool shadows : { false, true })
  {
    check.SetContext(shadows ? "with shadows" : "without shadows");
    ShadowScene scene =
      MakeScene(MakeImage(16, MakeSphere(0.15, 0.45)), MakeTranslucentProperty(0.6, true));
    scene.Shadows = shadows;
    vtkNew<vtkShadowedSliceMapper> mapper;
    VolumeStage stage(scene.Size);
    SetScene(stage, mapper, scene);
    CheckDrawingAborts(stage.GetWindow(), check);
  }
  return check.Result();
}
