// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAnalyticFlowSource.h"

#include "Analytic/ElementaryFlows.h"
#include "Analytic/VortexFlows.h"
#include "Common/NamedValue.h"
#include "Sampling/ClampedValue.h"
#include "Sampling/ExtentRows.h"

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
using Vector = interlume::ElementaryFlows::Vector;

constexpr double Limit = 1e12;
constexpr double LeastLength = 1e-12;

Vector MakeVector(const double v[3])
{
  return { { v[0], v[1], v[2] } };
}

Vector Scale(const Vector& v, double factor)
{
  return { { factor * v[0], factor * v[1], factor * v[2] } };
}

// Returns the direction of a vector. Sums of squares of numbers up to the limit are finite, but
// those of very small ones may be 0.
Vector GetDirection(const double v[3])
{
  const double largest = std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
  const Vector scaled = { { v[0] / largest, v[1] / largest, v[2] / largest } };
  return Scale(scaled, 1.0 / std::sqrt(interlume::ElementaryFlows::SquaredLength(scaled.data())));
}

// Return the parts of a vector along a direction and across it.
Vector GetPartAlong(const Vector& direction, const double v[3])
{
  return Scale(direction, interlume::ElementaryFlows::Dot(direction, v));
}

Vector GetPartAcross(const Vector& direction, const double v[3])
{
  const Vector along = GetPartAlong(direction, v);
  return { { v[0] - along[0], v[1] - along[1], v[2] - along[2] } };
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
  interlume::ClampedValue::Set(this, member, value, -Limit, Limit);
}

void vtkAnalyticFlowSource::SetLength(double& member, double value)
{
  interlume::ClampedValue::Set(this, member, value, LeastLength, Limit);
}

void vtkAnalyticFlowSource::SetVector(double (&member)[3], double x, double y, double z)
{
  interlume::ClampedValue::Set(this, member, { x, y, z }, -Limit, Limit);
}

void vtkAnalyticFlowSource::SetVector(double (&member)[2], double x, double y)
{
  interlume::ClampedValue::Set(this, member, { x, y }, -Limit, Limit);
}

void vtkAnalyticFlowSource::SetAxis(double x, double y, double z)
{
  const double largest = std::max({ std::abs(x), std::abs(y), std::abs(z) });
  if (!std::isfinite(x + y + z) || largest == 0.0)
  {
    vtkErrorMacro("Axis " << x << " " << y << " " << z << " is no direction.");
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
  const Vector axis = GetDirection(this->Axis);
  const interlume::VortexFlows::BentAxis bentAxis = { this->Height,
    { { this->AxisTilt[0], this->AxisTilt[1] } }, { { this->AxisBend[0], this->AxisBend[1] } } };
  const Vector zero = { { 0.0, 0.0, 0.0 } };
  switch (this->Field)
  {
    case UNIFORM:
      return visit(Uniform{ MakeVector(this->Velocity) });
    case ROTATION:
      return visit(Linear{ zero, Scale(axis, this->AngularVelocity) });
    case SADDLE:
      return visit(Linear{ MakeVector(this->SaddleRates), zero });
    case NODE:
      return visit(Linear{ MakeVector(this->NodeRates), Scale(axis, this->Swirl) });
    case SOURCE_SINK:
    case COUPLED_CHARGE:
      return visit(Pair{ this->Strength, MakeVector(this->Separation), this->CoreRadius,
        this->Field == COUPLED_CHARGE });
    case SPHERE:
      return visit(Sphere{ MakeVector(this->Velocity), this->Radius });
    case CYLINDER:
    {
      Vector along = GetPartAlong(axis, this->Velocity);
      for (int i = 0; i < 3; ++i)
      {
        along[i] += this->SpanwiseVelocity * axis[i];
      }
      return visit(Cylinder{ GetPartAcross(axis, this->Velocity), along, axis, this->Radius });
    }
    case ABC:
      return visit(Beltrami{
        MakeVector(this->Amplitudes), 2.0 * interlume::VortexFlows::BentAxis::Pi / this->Period });
    case SHEAR:
      return visit(Shear{ GetPartAcross(axis, this->Velocity), axis, this->Thickness });
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
    interlume::ElementaryFlows::Cylinder{ {}, {}, GetDirection(this->Axis), this->Radius }.IsInside(
      relative);
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
  this->SetReport({});
  this->Place(image, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
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
  this->SetReport(vtkSourceReport::Of(image, image->GetNumberOfPoints()));
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
