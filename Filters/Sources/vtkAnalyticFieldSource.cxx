// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAnalyticFieldSource.h"

#include "Common/NamedValue.h"
#include "Common/Vectors.h"
#include "Sampling/ClampedValue.h"
#include "Sampling/FieldSampler.h"
#include "Sampling/SourceReport.h"
#include "Vortices/VortexTubes.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>

vtkStandardNewMacro(vtkAnalyticFieldSource);

namespace
{
constexpr double LargestCoordinate = 1e6;

// Returns base + rate * time.
glm::dvec3 Advance(const double base[3], const double rate[3], double time)
{
  return glm::make_vec3(base) + glm::make_vec3(rate) * time;
}
}

const char* vtkAnalyticFieldSource::GetFieldName(int field)
{
  static const char* const names[NUMBER_OF_FIELDS] = { "wave", "vortex", "linear", "ball",
    "gyroid" };
  return field >= 0 && field < NUMBER_OF_FIELDS ? names[field] : nullptr;
}

void vtkAnalyticFieldSource::SetVector(double (&member)[3], double x, double y, double z)
{
  interlume::ClampedValue::Set(this, member, { x, y, z }, -LargestCoordinate, LargestCoordinate);
}

void vtkAnalyticFieldSource::SetNumber(double& member, double value)
{
  interlume::ClampedValue::Set(this, member, value, -LargestCoordinate, LargestCoordinate);
}

interlume::FieldSampler::Field vtkAnalyticFieldSource::GetFieldAtTime(double t) const
{
  switch (this->Field)
  {
    case WAVE:
      return [t](const double x[3])
      { return x[2] - 0.4 * std::cos(vtkMath::Pi() * (x[0] + 0.25 * x[1] - 0.5 * t)); };
    case LINEAR:
      return [t, constant = this->Constant, gradient = glm::make_vec3(this->Gradient),
               rate = this->Rate](const double x[3])
      { return constant + glm::dot(gradient, glm::make_vec3(x)) + rate * t; };
    case SPHERE_DISTANCE:
      return [center = Advance(this->Center, this->Velocity, t),
               radius = this->Radius + this->Growth * t](const double x[3])
      { return glm::distance(glm::make_vec3(x), center) - radius; };
    case GYROID:
      return [shift = Advance(this->Center, this->Velocity, t)](const double x[3])
      {
        const glm::dvec3 angle = 2.0 * vtkMath::Pi() * (glm::make_vec3(x) - shift);
        return std::sin(angle[0]) * std::cos(angle[1]) + std::sin(angle[1]) * std::cos(angle[2]) +
          std::sin(angle[2]) * std::cos(angle[0]);
      };
    default:
      return interlume::VortexTubes(t);
  }
}

void vtkAnalyticFieldSource::SetTimeRange(double first, double last)
{
  if (const interlume::Error error =
        interlume::FieldSampler::SetTimeRange(this->TimeRange, first, last, this))
  {
    vtkErrorMacro(<< error);
  }
}

void vtkAnalyticFieldSource::SetOutputScalarType(int type)
{
  interlume::FieldSampler::SetScalarType(this->OutputScalarType, type, this);
}

void vtkAnalyticFieldSource::SetArrayName(const char* name)
{
  interlume::FieldSampler::SetArrayName(this->ArrayName, name, "f", this);
}

interlume::FieldSampler vtkAnalyticFieldSource::GetSampler() const
{
  return { this->NumberOfTimeSteps, { { this->TimeRange[0], this->TimeRange[1] } },
    this->OutputScalarType, this->ArrayName.c_str() };
}

int vtkAnalyticFieldSource::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->Superclass::RequestInformation(request, inputs, outputs);
  this->GetSampler().FillInformation(outputs->GetInformationObject(0), this->GetWholeExtent());
  return 1;
}

int vtkAnalyticFieldSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  const interlume::FieldSampler sampler = this->GetSampler();
  double time = 0.0;
  interlume::SourceReport().CopyTo(this->GetReport());
  if (const interlume::Error error = sampler.FindTime(info, time))
  {
    vtkErrorMacro(<< error);
    return 1;
  }
  double origin[3];
  double spacing[3];
  this->GetOriginAndSpacing(origin, spacing);
  this->SetGeometry(image, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
  const auto positions = [&origin, &spacing](const int ijk[3], vtkIdType, double x[3])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = origin[axis] + ijk[axis] * spacing[axis];
    }
  };
  if (!sampler.Sample(image, image->GetExtent(), time, this->GetFieldAtTime(time), positions, this))
  {
    image->Initialize();
    return 1;
  }
  interlume::SourceReport::Of(image, image->GetNumberOfPoints(), time).CopyTo(this->GetReport());
  return 1;
}

void vtkAnalyticFieldSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  this->GetSampler().Print(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Field", GetFieldName(this->Field) }, { "Constant", this->Constant },
      { "Gradient", this->Gradient }, { "Rate", this->Rate }, { "Center", this->Center },
      { "Velocity", this->Velocity }, { "Radius", this->Radius }, { "Growth", this->Growth } });
}
