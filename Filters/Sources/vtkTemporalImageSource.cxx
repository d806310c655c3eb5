// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalImageSource.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkTemporalImageSource::vtkTemporalImageSource()
  : Sampler("f")
{
}

void vtkTemporalImageSource::SetTimeRange(double first, double last)
{
  const std::string wrong = this->Sampler.SetTimeRange(first, last, this);
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
  }
}

int vtkTemporalImageSource::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestInformation(request, inputs, outputs);
  this->Sampler.Announce(outputs->GetInformationObject(0), this->GetWholeExtent());
  return 1;
}

int vtkTemporalImageSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  double time = 0.0;
  this->SetReport({});
  const std::string wrong = this->Sampler.FindTime(info, time);
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
    return 1;
  }
  double origin[3];
  double spacing[3];
  this->GetLattice(origin, spacing);
  this->Place(image, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
  const auto positions = [&origin, &spacing](const int ijk[3], vtkIdType, double x[3])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = origin[axis] + ijk[axis] * spacing[axis];
    }
  };
  if (!this->Sampler.Sample(
        image, image->GetExtent(), time, this->GetFieldAtTime(time), positions, this))
  {
    image->Initialize();
    return 1;
  }
  this->SetReport(vtkSourceReport::Of(image, image->GetNumberOfPoints(), time));
  return 1;
}

void vtkTemporalImageSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->Sampler.Print(os, indent);
}
