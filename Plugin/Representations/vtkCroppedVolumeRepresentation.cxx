// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCroppedVolumeRepresentation.h"

#include "vtkCommunicator.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPVView.h"
#include "vtkVolumeMapper.h"

vtkStandardNewMacro(vtkCroppedVolumeRepresentation);

vtkCroppedVolumeRepresentation::vtkCroppedVolumeRepresentation() = default;

vtkCroppedVolumeRepresentation::~vtkCroppedVolumeRepresentation() = default;

int vtkCroppedVolumeRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->GatherBounds();
  }
  return 1;
}

void vtkCroppedVolumeRepresentation::GatherBounds()
{
  this->GlobalBounds.Reset();
  // The bounds are invalid (lower above upper) in a process without data.
  if (vtkMath::AreBoundsInitialized(this->DataBounds))
  {
    this->GlobalBounds.SetBounds(this->DataBounds);
  }
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    const vtkBoundingBox localBounds = this->GlobalBounds;
    double lower[3];
    double upper[3];
    controller->AllReduce(localBounds.GetMinPoint(), lower, 3, vtkCommunicator::MIN_OP);
    controller->AllReduce(localBounds.GetMaxPoint(), upper, 3, vtkCommunicator::MAX_OP);
    this->GlobalBounds.SetBounds(lower[0], upper[0], lower[1], upper[1], lower[2], upper[2]);
  }
}

vtkDataObject* vtkCroppedVolumeRepresentation::GetInput(vtkInformationVector** inputVector)
{
  return inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkDataObject::GetData(inputVector[0], 0)
    : nullptr;
}

int vtkCroppedVolumeRepresentation::RequestDataOf(vtkImageData* image, vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkNew<vtkInformation> information;
  information->Copy(inputVector[0]->GetInformationObject(0));
  information->Set(vtkDataObject::DATA_OBJECT(), image);
  vtkNew<vtkInformationVector> imageVector;
  imageVector->Append(information);
  vtkInformationVector* imageVectors[] = { imageVector };
  return this->Superclass::RequestData(request, imageVectors, outputVector);
}

void vtkCroppedVolumeRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  if (!this->VolumeMapper->GetCropping())
  {
    return;
  }
  double bounds[6];
  if (this->GlobalBounds.IsValid())
  {
    this->GlobalBounds.GetBounds(bounds);
  }
  else
  {
    // A client that renders data from a server has no input, so GatherBounds() finds no bounds.
    this->VolumeMapper->GetBounds(bounds);
  }
  double planes[6];
  for (int i = 0; i < 6; ++i)
  {
    planes[i] = this->CroppingOrigin[i / 2] + bounds[i] * this->CroppingScale[i / 2];
  }
  this->VolumeMapper->SetCroppingRegionPlanes(planes);
}

void vtkCroppedVolumeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  double bounds[6];
  this->GlobalBounds.GetBounds(bounds);
  os << indent << "GlobalBounds: " << bounds[0] << ", " << bounds[1] << ", " << bounds[2] << ", "
     << bounds[3] << ", " << bounds[4] << ", " << bounds[5] << "\n";
}
