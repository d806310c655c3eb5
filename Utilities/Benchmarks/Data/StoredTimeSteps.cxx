// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Data/StoredTimeSteps.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <algorithm>

vtkStandardNewMacro(StoredTimeSteps);

StoredTimeSteps::StoredTimeSteps()
{
  this->SetNumberOfInputPorts(0);
}

void StoredTimeSteps::AddStepsFrom(vtkAlgorithm* source)
{
  source->UpdateInformation();
  vtkInformation* info = source->GetOutputInformation(0);
  vtkInformationDoubleVectorKey* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  // Copy the times, because each update may overwrite the array.
  const std::vector<double> times(info->Get(key), info->Get(key) + info->Length(key));
  for (const double time : times)
  {
    source->UpdateTimeStep(time);
    this->AddStep(time, source->GetOutputDataObject(0));
  }
}

void StoredTimeSteps::AddStep(double time, vtkDataObject* data)
{
  auto copy = vtk::TakeSmartPointer(data->NewInstance());
  copy->ShallowCopy(data);
  this->Times.push_back(time);
  this->Steps.push_back(copy);
  this->Modified();
}

int StoredTimeSteps::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  if (!info->Has(vtkDataObject::DATA_OBJECT()))
  {
    info->Set(
      vtkDataObject::DATA_OBJECT(), vtk::TakeSmartPointer(this->Steps.front()->NewInstance()));
  }
  return 1;
}

int StoredTimeSteps::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkTrivialProducer::FillOutputDataInformation(this->Steps.front(), info);
  const double range[2] = { this->Times.front(), this->Times.back() };
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), this->Times.data(),
    static_cast<int>(this->Times.size()));
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  return 1;
}

int StoredTimeSteps::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkInformationDoubleKey* key = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  const double requested = info->Has(key) ? info->Get(key) : this->Times.front();
  const auto after = std::upper_bound(this->Times.begin(), this->Times.end(), requested);
  const auto step = std::max<std::ptrdiff_t>(after - this->Times.begin() - 1, 0);
  vtkDataObject* output = vtkDataObject::GetData(info);
  output->ShallowCopy(this->Steps[step]);
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), this->Times[step]);
  return 1;
}
