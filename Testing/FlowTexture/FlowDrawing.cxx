// SPDX-License-Identifier: BSD-3-Clause
#include "FlowDrawing.h"

#include "Support/Pictures/VolumeStage.h"

#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <cmath>

namespace reference
{

namespace
{
FlowEnd TwoSurfaces(const Place3& x)
{
  const bool isLeft = x[0] < 0.1;
  return { x[1] < 0.35, isLeft ? 0 : 8, x[1] + 0.5, x[2] + 0.5, isLeft ? x[0] + 0.6 : x[0] };
}
}

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

vtkSmartPointer<vtkImageData> MakeTwoFlows()
{
  vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(13, &TwoSurfaces, { { { 8, 1, 0 } } });
  vtkNew<vtkFloatArray> speed;
  speed->SetName("Speed");
  vtkNew<vtkFloatArray> ways;
  ways->SetName("Ways");
  ways->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < voxels->GetNumberOfPoints(); ++i)
  {
    const double* x = voxels->GetPoint(i);
    speed->InsertNextValue(static_cast<float>(x[0] * x[0] + x[2]));
    ways->InsertNextTuple3(1.0, x[1], -x[0]);
  }
  voxels->GetPointData()->AddArray(speed);
  voxels->GetPointData()->AddArray(ways);
  return voxels;
}

vtkSmartPointer<vtkImageData> MakeStripes(double frequency, double alpha)
{
  return MakePaint(33, 17,
    [=](double u, double v) {
      return Color4{ { 0.5 + 0.5 * std::sin(frequency * u), v, 0.3, alpha } };
    });
}

}
