// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowVolumeFromVectors.h"

#include "Common/AbortCheck.h"
#include "Common/NamedValue.h"
#include "Samples/OutputPiece.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTerminationInflow.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkFlowVolumeFromVectors);

namespace
{
/// Progress of the chain when the field is done.
constexpr double FieldEnd = 0.9;

/// Returns the text of a message without its file, line and object.
std::string GetText(const char* message)
{
  std::string text = message;
  const std::size_t start = text.find("): ");
  text = start == std::string::npos ? text : text.substr(start + 3);
  text.erase(text.find_last_not_of('\n') + 1);
  return text;
}
}

vtkFlowVolumeFromVectors::vtkFlowVolumeFromVectors()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::VECTORS);
  // With a controller, the inner filter would expect the partitions of a distributed field.
  this->Field->SetController(nullptr);
  this->Field->AddTerminationSurface(this->Inflow);
  this->Field->SetRefinementLevels(vtkImplicitFlowField::CUT_BOUNDARY);
  this->Mapping->SetInputConnection(this->Field->GetOutputPort());
  this->Volume->SetInputConnection(this->Mapping->GetOutputPort());
  this->Forwarding->SetClientData(this);
  this->Forwarding->SetCallback([](vtkObject* caller, unsigned long event, void* owner, void* data)
    { static_cast<vtkFlowVolumeFromVectors*>(owner)->Forward(caller, event, data); });
  for (vtkAlgorithm* filter : { static_cast<vtkAlgorithm*>(this->Field.Get()),
         static_cast<vtkAlgorithm*>(this->Mapping.Get()),
         static_cast<vtkAlgorithm*>(this->Volume.Get()) })
  {
    for (const unsigned long event :
      { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
    {
      filter->AddObserver(event, this->Forwarding);
    }
  }
  this->SetNumberOfBands(this->NumberOfBands);
  this->Report->PassData(this->Field->GetReport());
  this->Report->PassData(this->Volume->GetReport());
}

vtkFlowVolumeFromVectors::~vtkFlowVolumeFromVectors() = default;

void vtkFlowVolumeFromVectors::SetTerminationSurface(vtkTerminationSurface* surface)
{
  if (surface != this->GetTerminationSurface())
  {
    this->Field->RemoveAllTerminationSurfaces();
    this->Field->AddTerminationSurface(surface ? surface : this->Inflow.Get());
    this->Modified();
  }
}

vtkTerminationSurface* vtkFlowVolumeFromVectors::GetTerminationSurface() const
{
  vtkTerminationSurface* surface = this->Field->GetTerminationSurface(0);
  return surface == this->Inflow.Get() ? nullptr : surface;
}

void vtkFlowVolumeFromVectors::SetNumberOfBands(int number)
{
  constexpr int maximum = 1000;
  this->NumberOfBands = std::clamp(number, 1, maximum);
  this->Volume->SetNumberOfIntervals(this->NumberOfBands);
  for (int band = 0; band < this->NumberOfBands; ++band)
  {
    this->Volume->SetInterval(
      band, (band + 0.25) / this->NumberOfBands, (band + 0.75) / this->NumberOfBands);
  }
  this->Modified();
}

void vtkFlowVolumeFromVectors::SetResolution(int resolution)
{
  this->Resolution = std::clamp<int>(resolution, PREVIEW, FULL);
  this->Field->SetSampleMode(this->Resolution == FULL ? vtkImplicitFlowField::SAMPLES_OF_FIELD
                                                      : vtkImplicitFlowField::SAMPLES_AUTOMATIC);
  this->Field->SetRefinementLevels(
    this->Resolution == PREVIEW ? 0 : vtkImplicitFlowField::CUT_BOUNDARY);
  this->Modified();
}

void vtkFlowVolumeFromVectors::SetDirection(int direction)
{
  this->Field->SetDirection(direction);
  this->Modified();
}

int vtkFlowVolumeFromVectors::GetDirection() const
{
  return this->Field->GetDirection();
}

void vtkFlowVolumeFromVectors::SetMaximumTime(double time)
{
  this->Field->SetMaximumTime(time);
  this->Modified();
}

double vtkFlowVolumeFromVectors::GetMaximumTime() const
{
  return this->Field->GetMaximumTime();
}

vtkMTimeType vtkFlowVolumeFromVectors::GetMTime()
{
  vtkTerminationSurface* surface = this->GetTerminationSurface();
  return std::max(this->Superclass::GetMTime(), surface ? surface->GetMTime() : 0);
}

const char* vtkFlowVolumeFromVectors::GetSummary()
{
  this->Summary = this->Field->GetSummary();
  const std::string volume = this->Volume->GetSummary();
  this->Summary += (this->Summary.empty() || volume.empty() ? "" : " ") + volume;
  return this->Summary.c_str();
}

int vtkFlowVolumeFromVectors::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkFlowVolumeFromVectors::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Requests the whole field, because streamlines may visit all of it.
  interlume::OutputPiece::RequestEntireInput(inputs[0]->GetInformationObject(0));
  return 1;
}

void vtkFlowVolumeFromVectors::SetInnerInput(vtkDataObject* input)
{
  if (input != this->Input || input->GetMTime() > this->InputTime)
  {
    const auto copy = vtk::TakeSmartPointer(input->NewInstance());
    copy->ShallowCopy(input);
    this->Field->SetInputDataObject(copy);
    this->Input = input;
    this->InputTime = input->GetMTime();
  }
  vtkInformation* array = this->GetInputArrayInformation(0);
  if (array->GetMTime() > this->ArrayTime)
  {
    this->Field->SetInputArrayToProcess(0, array);
    this->ArrayTime = array->GetMTime();
  }
}

int vtkFlowVolumeFromVectors::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* info = outputs->GetInformationObject(0);
  this->HasError = false;
  this->SetInnerInput(vtkDataObject::GetData(inputs[0], 0));
  this->Volume->UpdatePiece(info->Get(Pipeline::UPDATE_PIECE_NUMBER()),
    info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()),
    info->Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()));
  this->Report->PassData(this->Field->GetReport());
  this->Report->PassData(this->Volume->GetReport());
  if (this->GetAbortExecute())
  {
    for (vtkAlgorithm* filter : { static_cast<vtkAlgorithm*>(this->Field.Get()),
           static_cast<vtkAlgorithm*>(this->Mapping.Get()),
           static_cast<vtkAlgorithm*>(this->Volume.Get()) })
    {
      filter->SetAbortExecute(0);
      filter->Modified();
    }
    return interlume::AbortCheck::Leave(outputs);
  }
  vtkUnstructuredGrid::GetData(outputs)->ShallowCopy(this->Volume->GetOutput());
  return 1;
}

void vtkFlowVolumeFromVectors::Forward(vtkObject* caller, unsigned long event, void* data)
{
  if ((this->GetAbortExecute() || this->HasError) && event != vtkCommand::ProgressEvent)
  {
    // The filters after one that was aborted or failed have no valid input.
    return;
  }
  if (event == vtkCommand::ErrorEvent)
  {
    this->HasError = true;
    vtkErrorMacro(<< GetText(static_cast<const char*>(data)));
  }
  else if (event == vtkCommand::WarningEvent)
  {
    vtkWarningMacro(<< GetText(static_cast<const char*>(data)));
  }
  else
  {
    auto* filter = vtkAlgorithm::SafeDownCast(caller);
    const double part = *static_cast<double*>(data);
    if (filter == this->Field || filter == this->Volume)
    {
      this->SetProgressText(filter->GetProgressText());
      this->UpdateProgress(
        filter == this->Field ? FieldEnd * part : FieldEnd + (1.0 - FieldEnd) * part);
    }
    if (this->GetAbortExecute())
    {
      filter->SetAbortExecute(1);
    }
  }
}

void vtkFlowVolumeFromVectors::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TerminationSurface: " << this->GetTerminationSurface() << "\n";
  interlume::NamedValue::Print(os, indent,
    { { "NumberOfBands", this->NumberOfBands }, { "Resolution", this->Resolution },
      { "Direction", this->GetDirection() }, { "MaximumTime", this->GetMaximumTime() } });
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
