// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Inputs/ExodusTimeSource.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataObject.h"
#include "vtkExodusIIReader.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

namespace interlume
{
vtkStandardNewMacro(ExodusTimeSource);

ExodusTimeSource::ExodusTimeSource()
{
  this->SetNumberOfInputPorts(0);
  this->Reader->GenerateObjectIdCellArrayOff();
}

ExodusTimeSource::~ExodusTimeSource() = default;

void ExodusTimeSource::SetFileName(const std::string& path)
{
  this->Reader->SetFileName(path.c_str());
  this->Modified();
}

int ExodusTimeSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  this->Reader->UpdateInformation();
  this->Reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkInformation* from = this->Reader->GetOutputInformation(0);
  info->CopyEntry(from, vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  info->CopyEntry(from, vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  return 1;
}

int ExodusTimeSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  if (info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    this->Reader->UpdateTimeStep(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()));
  }
  else
  {
    this->Reader->Update();
  }
  vtkMultiBlockDataSet* blocks = this->Reader->GetOutput();
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  iterator->InitTraversal();
  auto* block = iterator->IsDoneWithTraversal()
    ? nullptr
    : vtkUnstructuredGrid::SafeDownCast(iterator->GetCurrentDataObject());
  if (!block)
  {
    vtkErrorMacro("SetFileName: the file's first block is not an unstructured grid: "
      << this->Reader->GetFileName());
    return 1;
  }
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::GetData(info);
  grid->ShallowCopy(block);
  grid->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
    blocks->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
  return 1;
}
}
