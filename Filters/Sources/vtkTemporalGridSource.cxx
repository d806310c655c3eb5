// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalGridSource.h"

#include "Common/NamedValue.h"
#include "Sampling/FieldSampler.h"
#include "Sampling/SourceReport.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"

#include <algorithm>

namespace
{
constexpr int MinimumDimension = 2;
constexpr int MaximumDimension = 32768;
}

vtkTemporalGridSource::vtkTemporalGridSource(const char* arrayName, int i, int j, int k)
  : Dimensions{ i, j, k }
  , DefaultArrayName(arrayName)
  , ArrayName(arrayName)
{
  this->SetNumberOfInputPorts(0);
  interlume::SourceReport().CopyTo(this->Report);
}

void vtkTemporalGridSource::SetDimensions(int i, int j, int k)
{
  int clamped[3] = { i, j, k };
  for (int& dimension : clamped)
  {
    dimension = std::max(MinimumDimension, std::min(dimension, MaximumDimension));
  }
  if (!std::equal(clamped, clamped + 3, this->Dimensions))
  {
    std::copy_n(clamped, 3, this->Dimensions);
    this->Modified();
  }
}

void vtkTemporalGridSource::SetTimeRange(double first, double last)
{
  if (const interlume::Error error =
        interlume::FieldSampler::SetTimeRange(this->TimeRange, first, last, this))
  {
    vtkErrorMacro(<< error);
  }
}

void vtkTemporalGridSource::SetOutputScalarType(int type)
{
  interlume::FieldSampler::SetScalarType(this->OutputScalarType, type, this);
}

void vtkTemporalGridSource::SetArrayName(const char* name)
{
  interlume::FieldSampler::SetArrayName(this->ArrayName, name, this->DefaultArrayName, this);
}

interlume::FieldSampler vtkTemporalGridSource::GetSampler() const
{
  return { this->NumberOfTimeSteps, { { this->TimeRange[0], this->TimeRange[1] } },
    this->OutputScalarType, this->ArrayName.c_str() };
}

int vtkTemporalGridSource::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const int wholeExtent[6] = { 0, this->Dimensions[0] - 1, 0, this->Dimensions[1] - 1, 0,
    this->Dimensions[2] - 1 };
  this->GetSampler().FillInformation(outputs->GetInformationObject(0), wholeExtent);
  return 1;
}

int vtkTemporalGridSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkStructuredGrid* grid = vtkStructuredGrid::GetData(info);
  const interlume::FieldSampler sampler = this->GetSampler();
  double time = 0.0;
  interlume::SourceReport().CopyTo(this->Report);
  if (const interlume::Error error = sampler.FindTime(info, time))
  {
    vtkErrorMacro(<< error);
    return 1;
  }
  int* extent = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT());
  vtkNew<vtkPoints> points;
  points->SetDataType(this->OutputScalarType);
  points->SetNumberOfPoints(vtkStructuredData::GetNumberOfPoints(extent));
  grid->SetExtent(extent);
  grid->SetPoints(points);
  const auto positions = [this, &points](const int ijk[3], vtkIdType point, double x[3])
  {
    this->GetPosition(ijk, x);
    points->SetPoint(point, x);
  };
  if (!sampler.Sample(grid, extent, time, this->GetFieldAtTime(time), positions, this))
  {
    grid->Initialize();
    return 1;
  }
  interlume::SourceReport::Of(grid, grid->GetNumberOfPoints(), time).CopyTo(this->Report);
  return 1;
}

void vtkTemporalGridSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent, { { "Dimensions", this->Dimensions } });
  this->GetSampler().Print(os, indent);
  os << indent << "Report:\n";
  this->Report->PrintSelf(os, indent.GetNextIndent());
}
