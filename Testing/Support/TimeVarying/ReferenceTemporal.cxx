// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TimeVarying/ReferenceTemporal.h"

#include "vtkCallbackCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace reference
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkDataSet* FirstDataSet(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return vtkDataSet::SafeDownCast(data);
  }
  vtkSmartPointer<vtkCompositeDataIterator> leaf;
  leaf.TakeReference(composite->NewIterator());
  leaf->InitTraversal();
  return leaf->IsDoneWithTraversal() ? nullptr
                                     : vtkDataSet::SafeDownCast(leaf->GetCurrentDataObject());
}

vtkSmartPointer<vtkDataObject> Copy(vtkDataObject* data)
{
  vtkSmartPointer<vtkDataObject> copy;
  copy.TakeReference(data->NewInstance());
  copy->DeepCopy(data);
  return copy;
}

}

vtkStandardNewMacro(TimeStepSource);

TimeStepSource::TimeStepSource()
  : Alive(std::make_shared<Population>())
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(1);
}

void TimeStepSource::SetSteps(const TimeSteps& steps)
{
  this->Steps = steps;
  this->Alive = std::make_shared<Population>();
  this->Modified();
}

void TimeStepSource::SetReportTimeSteps(bool isReported)
{
  this->ReportsTimes = isReported;
  this->Modified();
}

int TimeStepSource::GetMaximumStepsInMemory() const
{
  return this->Alive->Maximum;
}

int TimeStepSource::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

vtkTypeBool TimeStepSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    vtkDataObject* current = info->Get(vtkDataObject::DATA_OBJECT());
    vtkDataObject* first = this->Steps.front().Data;
    if (!current || current->GetDataObjectType() != first->GetDataObjectType())
    {
      vtkSmartPointer<vtkDataObject> empty;
      empty.TakeReference(first->NewInstance());
      info->Set(vtkDataObject::DATA_OBJECT(), empty);
    }
    return 1;
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    this->ReportInformation(info);
    return 1;
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    this->ReturnStep(info);
    return 1;
  }
  return this->Superclass::ProcessRequest(request, input, output);
}

void TimeStepSource::ReportInformation(vtkInformation* info)
{
  vtkDataObject* first = this->Steps.front().Data;
  if (first->GetExtentType() == VTK_3D_EXTENT)
  {
    info->Set(
      Pipeline::WHOLE_EXTENT(), first->GetInformation()->Get(vtkDataObject::DATA_EXTENT()), 6);
  }
  if (auto* image = vtkImageData::SafeDownCast(first))
  {
    info->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
    info->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
  }
  if (!this->ReportsTimes)
  {
    info->Remove(Pipeline::TIME_STEPS());
    info->Remove(Pipeline::TIME_RANGE());
    return;
  }
  std::vector<double> times;
  for (const TimeStep& step : this->Steps)
  {
    times.push_back(step.Time);
  }
  const double range[2] = { times.front(), times.back() };
  info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  info->Set(Pipeline::TIME_RANGE(), range, 2);
}

int TimeStepSource::FindStep(vtkInformation* info) const
{
  int found = 0;
  if (info->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    const double time = info->Get(Pipeline::UPDATE_TIME_STEP());
    for (size_t i = 0; i < this->Steps.size(); ++i)
    {
      found = this->Steps[i].Time <= time ? static_cast<int>(i) : found;
    }
  }
  return found;
}

void TimeStepSource::ReturnStep(vtkInformation* info)
{
  const int step = this->FindStep(info);
  this->Requests.push_back(step);
  // Releases the previous step first, like a reader that reuses its output.
  info->Get(vtkDataObject::DATA_OBJECT())->Initialize();
  const vtkSmartPointer<vtkDataObject> data = Copy(this->Steps[step].Data);
  this->ShareArrays(step, data);
  this->Count(data);
  data->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), this->Steps[step].Time);
  info->Set(vtkDataObject::DATA_OBJECT(), data);
}

void TimeStepSource::ShareArrays(int step, vtkDataObject* copy) const
{
  const auto getArrays = [this](int index)
  {
    vtkDataSet* data = vtkDataSet::SafeDownCast(this->Steps[index].Data);
    return data ? data->GetPointData() : nullptr;
  };
  vtkPointData* const arrays = getArrays(step);
  vtkPointData* const others = this->Steps.size() < 2 ? nullptr : getArrays(step == 0 ? 1 : 0);
  for (int a = 0; arrays && others && a < arrays->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(a);
    if (array->GetName() && array == others->GetAbstractArray(array->GetName()))
    {
      vtkDataSet::SafeDownCast(copy)->GetPointData()->AddArray(array);
    }
  }
}

void TimeStepSource::Count(vtkDataObject* data)
{
  vtkDataSet* first = FirstDataSet(data);
  vtkDataArray* watched = first ? first->GetPointData()->GetArray(0) : nullptr;
  if (!watched)
  {
    return;
  }
  ++this->Alive->Alive;
  this->Alive->Maximum = std::max(this->Alive->Maximum, this->Alive->Alive);
  // The callback shares ownership of the counter, since the data may outlive this object.
  vtkNew<vtkCallbackCommand> deleted;
  deleted->SetClientData(new std::shared_ptr<Population>(this->Alive));
  deleted->SetClientDataDeleteCallback(
    [](void* client) { delete static_cast<std::shared_ptr<Population>*>(client); });
  deleted->SetCallback([](vtkObject*, unsigned long, void* client, void*)
    { --(*static_cast<std::shared_ptr<Population>*>(client))->Alive; });
  watched->AddObserver(vtkCommand::DeleteEvent, deleted);
}

}
