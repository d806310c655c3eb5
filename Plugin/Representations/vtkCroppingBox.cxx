// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCroppingBox.h"

#include "vtkCommunicator.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkVolumeMapper.h"

void vtkCroppingBox::Gather(const double bounds[6])
{
  this->Bounds.Reset();
  if (vtkMath::AreBoundsInitialized(bounds))
  {
    this->Bounds.SetBounds(bounds);
  }
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    const vtkBoundingBox own = this->Bounds;
    double lower[3];
    double upper[3];
    controller->AllReduce(own.GetMinPoint(), lower, 3, vtkCommunicator::MIN_OP);
    controller->AllReduce(own.GetMaxPoint(), upper, 3, vtkCommunicator::MAX_OP);
    this->Bounds.SetBounds(lower[0], upper[0], lower[1], upper[1], lower[2], upper[2]);
  }
}

void vtkCroppingBox::Apply(
  vtkVolumeMapper* mapper, const double origin[3], const double scale[3]) const
{
  if (!mapper->GetCropping())
  {
    return;
  }
  double bounds[6];
  if (this->Bounds.IsValid())
  {
    this->Bounds.GetBounds(bounds);
  }
  else
  {
    mapper->GetBounds(bounds);
  }
  double planes[6];
  for (int i = 0; i < 6; ++i)
  {
    planes[i] = origin[i / 2] + bounds[i] * scale[i / 2];
  }
  mapper->SetCroppingRegionPlanes(planes);
}
