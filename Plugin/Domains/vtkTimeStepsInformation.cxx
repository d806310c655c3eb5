// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTimeStepsInformation.h"

#include "vtkAlgorithm.h"
#include "vtkClientServerStream.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include <algorithm>

vtkStandardNewMacro(vtkTimeStepsInformation);

void vtkTimeStepsInformation::CopyFromObject(vtkObject* object)
{
  this->Stride = 1;
  this->LastStep = VTK_INT_MAX;
  this->Tetrahedra = 0.0;
  const Request& settings = this->Settings;
  auto* source = vtkAlgorithm::SafeDownCast(object);
  if (!source || settings.Port >= source->GetNumberOfOutputPorts())
  {
    return;
  }
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort(settings.Port));
  filter->SetInputArrayToProcess(0, 0, 0, settings.Association, settings.Array.c_str());
  const int intervals = static_cast<int>(settings.Intervals.size() / 2);
  for (int i = 0; i < intervals; ++i)
  {
    filter->SetInterval(i, settings.Intervals[2 * i], settings.Intervals[2 * i + 1]);
  }
  filter->SetTimeStepRange(settings.Range[0], settings.Range[1]);
  filter->SetSizeWarningLimit(static_cast<vtkIdType>(settings.Limit));
  this->Tetrahedra = static_cast<double>(filter->LimitTimeSteps());
  this->Stride = filter->GetTimeStepStride();
  this->LastStep = filter->GetTimeStepRange()[1];
}

void vtkTimeStepsInformation::AddInformation(vtkPVInformation* other)
{
  if (auto* steps = vtkTimeStepsInformation::SafeDownCast(other))
  {
    this->Stride = std::max(this->Stride, steps->Stride);
    this->LastStep = std::min(this->LastStep, steps->LastStep);
    this->Tetrahedra += steps->Tetrahedra;
  }
}

void vtkTimeStepsInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << this->Stride << this->LastStep << this->Tetrahedra
          << vtkClientServerStream::End;
}

void vtkTimeStepsInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  stream->GetArgument(0, 0, &this->Stride);
  stream->GetArgument(0, 1, &this->LastStep);
  stream->GetArgument(0, 2, &this->Tetrahedra);
}

void vtkTimeStepsInformation::CopyParametersToStream(vtkMultiProcessStream& stream)
{
  stream << this->Settings.Port << this->Settings.Association << this->Settings.Array
         << this->Settings.Range[0] << this->Settings.Range[1] << this->Settings.Limit
         << static_cast<int>(this->Settings.Intervals.size());
  for (const double bound : this->Settings.Intervals)
  {
    stream << bound;
  }
}

void vtkTimeStepsInformation::CopyParametersFromStream(vtkMultiProcessStream& stream)
{
  int bounds = 0;
  stream >> this->Settings.Port >> this->Settings.Association >> this->Settings.Array >>
    this->Settings.Range[0] >> this->Settings.Range[1] >> this->Settings.Limit >> bounds;
  this->Settings.Intervals.assign(static_cast<std::size_t>(std::max(bounds, 0)), 0.0);
  for (double& bound : this->Settings.Intervals)
  {
    stream >> bound;
  }
}

void vtkTimeStepsInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stride: " << this->Stride << "\n";
  os << indent << "LastStep: " << this->LastStep << "\n";
}
