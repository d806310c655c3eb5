// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAnalyticFlowSource.h"

#include "Analytic/ElementaryFlows.h"
#include "Analytic/VortexFlows.h"
#include "Common/NamedValue.h"
#include "Common/Vectors.h"
#include "Sampling/ClampedValue.h"
#include "Sampling/ExtentRows.h"
#include "Sampling/SourceReport.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkAnalyticFlowSource);

namespace
{
constexpr double MinimumLength = 1e-12;

// Returns the normalized vector. It is scaled first, because the squared length of a very small
// vector may be 0.
glm::dvec3 GetDirection(const glm::dvec3& v)
{
  return glm::normalize(v / interlume::Vectors::InfinityNorm(v));
}

// Return the components of a vector parallel and perpendicular to a direction.
glm::dvec3 GetParallel(const glm::dvec3& direction, const glm::dvec3& v)
{
  return glm::dot(direction, v) * direction;
}

glm::dvec3 GetPerpendicular(const glm::dvec3& direction, const glm::dvec3& v)
{
  return v - GetParallel(direction, v);
}
}

const char* vtkAnalyticFlowSource::GetFieldName(int field)
{
  static const char* const names[NUMBER_OF_FIELDS] = { "uniform", "rotation", "saddle", "node",
    "source and sink", "coupled charge", "sphere", "cylinder", "ABC", "shear", "hurricane",
    "tornado" };
  return field >= 0 && field < NUMBER_OF_FIELDS ? names[field] : nullptr;
}

const char* vtkAnalyticFlowSource::GetInsideName(int inside)
{
  static const char* const names[NUMBER_OF_INSIDES] = { "zero", "not a number", "hidden" };
  return inside >= 0 && inside < NUMBER_OF_INSIDES ? names[inside] : nullptr;
}

void vtkAnalyticFlowSource::SetNumber(double& member, double value)
{
  interlume::ClampedValue::Set(this, member, value);
}

void vtkAnalyticFlowSource::SetLength(double& member, double value)
{
  interlume::ClampedValue::Set(
    this, member, value, MinimumLength, interlume::ClampedValue::Largest);
}

void vtkAnalyticFlowSource::SetVector(double (&member)[3], double x, double y, double z)
{
  interlume::ClampedValue::Set(this, member, { x, y, z });
}

void vtkAnalyticFlowSource::SetVector(double (&member)[2], double x, double y)
{
  interlume::ClampedValue::Set(this, member, { x, y });
}

void vtkAnalyticFlowSource::SetAxis(double x, double y, double z)
{
  const double largest = std::max({ std::abs(x), std::abs(y), std::abs(z) });
  if (!std::isfinite(x + y + z) || largest == 0.0)
  {
    vtkErrorMacro("Axis " << x << " " << y << " " << z << " is zero or not finite. "
                          << "Pass a finite vector with a nonzero component.");
    return;
  }
  this->SetVector(this->Axis, x, y, z);
}

void vtkAnalyticFlowSource::SetOutputScalarType(int type)
{
  const int valid = type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
  if (valid != this->OutputScalarType)
  {
    this->OutputScalarType = valid;
    this->Modified();
  }
}

template <typename Visitor>
void vtkAnalyticFlowSource::Visit(const Visitor& visit) const
{
  using namespace interlume::ElementaryFlows;
  const glm::dvec3 axis = GetDirection(glm::make_vec3(this->Axis));
  const glm::dvec3 velocity = glm::make_vec3(this->Velocity);
  const interlume::VortexFlows::BentAxis bentAxis = { this->Height,
    { { this->AxisTilt[0], this->AxisTilt[1] } }, { { this->AxisBend[0], this->AxisBend[1] } } };
  const glm::dvec3 zero(0.0);
  switch (this->Field)
  {
    case UNIFORM:
      return visit(Uniform{ velocity });
    case ROTATION:
      return visit(Linear{ zero, this->AngularVelocity * axis });
    case SADDLE:
      return visit(Linear{ glm::make_vec3(this->SaddleRates), zero });
    case NODE:
      return visit(Linear{ glm::make_vec3(this->NodeRates), this->Swirl * axis });
    case SOURCE_SINK:
    case COUPLED_CHARGE:
      return visit(Pair{ this->Strength, glm::make_vec3(this->Separation), this->CoreRadius,
        this->Field == COUPLED_CHARGE });
    case SPHERE:
      return visit(Sphere{ velocity, this->Radius });
    case CYLINDER:
      return visit(Cylinder{ GetPerpendicular(axis, velocity),
        GetParallel(axis, velocity) + this->SpanwiseVelocity * axis, axis, this->Radius });
    case ABC:
      return visit(Beltrami{ glm::make_vec3(this->Amplitudes),
        2.0 * interlume::VortexFlows::BentAxis::Pi / this->Period });
    case SHEAR:
      return visit(Shear{ GetPerpendicular(axis, velocity), axis, this->Thickness });
    case HURRICANE:
      return visit(interlume::VortexFlows::Hurricane{
        bentAxis, this->MaximumWind, this->EyeRadius, this->Updraft });
    default:
      return visit(interlume::VortexFlows::Tornado{
        bentAxis, this->Circulation, this->CoreRadius, this->Strain });
  }
}

bool vtkAnalyticFlowSource::IsInside(const double x[3]) const
{
  const double relative[3] = { x[0] - this->Center[0], x[1] - this->Center[1],
    x[2] - this->Center[2] };
  if (this->Field == SPHERE)
  {
    return interlume::ElementaryFlows::Sphere{ {}, this->Radius }.IsInside(relative);
  }
  return this->Field == CYLINDER &&
    interlume::ElementaryFlows::Cylinder{ {}, {}, GetDirection(glm::make_vec3(this->Axis)),
      this->Radius }
      .IsInside(relative);
}

void vtkAnalyticFlowSource::Evaluate(const double x[3], double velocity[3]) const
{
  if (this->Inside == NOT_A_NUMBER && this->IsInside(x))
  {
    std::fill_n(velocity, 3, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  const double relative[3] = { x[0] - this->Center[0], x[1] - this->Center[1],
    x[2] - this->Center[2] };
  this->Visit([&](const auto& flow) { flow(relative, velocity); });
}

void vtkAnalyticFlowSource::EvaluateJacobian(const double x[3], double jacobian[9]) const
{
  if (this->Inside == NOT_A_NUMBER && this->IsInside(x))
  {
    std::fill_n(jacobian, 9, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  interlume::DualNumber relative[3];
  for (int i = 0; i < 3; ++i)
  {
    relative[i] = interlume::DualNumber(x[i] - this->Center[i], 3, i);
  }
  interlume::DualNumber velocity[3];
  this->Visit([&](const auto& flow) { flow(relative, velocity); });
  for (int i = 0; i < 3; ++i)
  {
    std::copy_n(velocity[i].derivatives().data(), 3, jacobian + 3 * i);
  }
}

int vtkAnalyticFlowSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkImageData* image = vtkImageData::GetData(info);
  interlume::SourceReport().CopyTo(this->GetReport());
  this->SetGeometry(image, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
  auto values = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(this->OutputScalarType));
  values->SetName("Velocity");
  values->SetNumberOfComponents(3);
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  vtkNew<vtkUnsignedCharArray> ghosts;
  const bool isHiding =
    this->Inside == HIDDEN && (this->Field == SPHERE || this->Field == CYLINDER);
  if (isHiding)
  {
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    ghosts->SetNumberOfValues(image->GetNumberOfPoints());
  }
  const auto makeValue = [&](const double x[3], vtkIdType point)
  {
    double velocity[3];
    this->Evaluate(x, velocity);
    values->SetTuple(point, velocity);
    if (isHiding)
    {
      ghosts->SetValue(point, this->IsInside(x) ? vtkDataSetAttributes::HIDDENPOINT : 0);
    }
  };
  if (!interlume::ExtentRows::RunPoints(image, this, makeValue))
  {
    image->Initialize();
    return 1;
  }
  image->GetPointData()->SetVectors(values);
  if (isHiding)
  {
    image->GetPointData()->AddArray(ghosts);
  }
  interlume::SourceReport::Of(image, image->GetNumberOfPoints()).CopyTo(this->GetReport());
  this->UpdateProgress(1.0);
  return 1;
}

void vtkAnalyticFlowSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Field", GetFieldName(this->Field) }, { "OutputScalarType", this->OutputScalarType },
      { "Center", this->Center }, { "Velocity", this->Velocity }, { "Axis", this->Axis },
      { "AngularVelocity", this->AngularVelocity }, { "SaddleRates", this->SaddleRates },
      { "NodeRates", this->NodeRates }, { "Swirl", this->Swirl }, { "Strength", this->Strength },
      { "Separation", this->Separation }, { "CoreRadius", this->CoreRadius },
      { "Radius", this->Radius }, { "Inside", GetInsideName(this->Inside) },
      { "SpanwiseVelocity", this->SpanwiseVelocity }, { "Amplitudes", this->Amplitudes },
      { "Period", this->Period }, { "Thickness", this->Thickness }, { "Height", this->Height },
      { "AxisTilt", this->AxisTilt }, { "AxisBend", this->AxisBend },
      { "MaximumWind", this->MaximumWind }, { "EyeRadius", this->EyeRadius },
      { "Updraft", this->Updraft }, { "Circulation", this->Circulation },
      { "Strain", this->Strain } });
}
