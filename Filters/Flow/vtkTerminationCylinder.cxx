// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationCylinder.h"

#include "Common/FiniteNumbers.h"
#include "Common/NamedValue.h"
#include "Common/Vectors.h"
#include "Termination/AxialFrame.h"
#include "Termination/DiskParameters.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTerminationCylinder);

vtkTerminationCylinder::vtkTerminationCylinder()
  : Frame(std::make_unique<interlume::AxialFrame>())
{
}

vtkTerminationCylinder::~vtkTerminationCylinder() = default;

std::string vtkTerminationCylinder::Update()
{
  if (!interlume::FiniteNumbers::AreFinite(this->Point1, 3) ||
    !interlume::FiniteNumbers::AreFinite(this->Point2, 3))
  {
    return "an end of the cylinder's axis is not finite";
  }
  if (!interlume::FiniteNumbers::IsSize(this->Radius))
  {
    return "the cylinder's radius must be finite and greater than 0";
  }
  const glm::dvec3 axis = interlume::Vectors::Difference(this->Point2, this->Point1);
  this->Length = interlume::Vectors::SafeLength(axis);
  if (!interlume::FiniteNumbers::IsSize(this->Length))
  {
    return "the cylinder's axis has no length: its ends are the same point";
  }
  this->Frame->SetAxis(axis);
  return {};
}

vtkTerminationCylinder::LocalPosition vtkTerminationCylinder::GetLocalPosition(
  const double x[3]) const
{
  const glm::dvec3 p = this->Frame->GetComponents(glm::make_vec3(x), glm::make_vec3(this->Point1));
  LocalPosition position;
  position.Offset[0] = p[0];
  position.Offset[1] = p[1];
  position.Along = p[2];
  position.Wall = std::hypot(p[0], p[1]) - this->Radius;
  position.End = std::max(-p[2], p[2] - this->Length);
  position.Part = WALL;
  if (this->Capped && position.End > position.Wall)
  {
    position.Part = p[2] < 0.5 * this->Length ? CAP_1 : CAP_2;
  }
  return position;
}

double vtkTerminationCylinder::EvaluateDistance(const double x[3]) const
{
  const LocalPosition position = this->GetLocalPosition(x);
  if (!this->Capped)
  {
    return position.Wall;
  }
  return position.Wall > 0.0 && position.End > 0.0 ? std::hypot(position.Wall, position.End)
                                                   : std::max(position.Wall, position.End);
}

bool vtkTerminationCylinder::IsOn(const double x[3]) const
{
  return this->Capped || this->GetLocalPosition(x).End <= BorderTolerance * this->Length;
}

int vtkTerminationCylinder::EvaluatePart(const double x[3]) const
{
  return this->GetLocalPosition(x).Part;
}

void vtkTerminationCylinder::EvaluateParameters(const double x[3], double uv[2]) const
{
  const LocalPosition position = this->GetLocalPosition(x);
  if (position.Part == WALL)
  {
    uv[0] = interlume::AxialFrame::GetAngleInTurns(position.Offset[0], position.Offset[1]);
    uv[1] = std::max(0.0, std::min(position.Along / this->Length, 1.0));
    return;
  }
  interlume::DiskParameters::FromPoint(
    position.Offset[0] / this->Radius, position.Offset[1] / this->Radius, uv);
}

void vtkTerminationCylinder::EvaluateNormal(const double x[3], double normal[3]) const
{
  const LocalPosition position = this->GetLocalPosition(x);
  glm::dvec3 outward = this->Frame->GetVector(0.0, 0.0, position.Part == CAP_1 ? -1.0 : 1.0);
  if (position.Part == WALL)
  {
    outward = this->Frame->GetVector(position.Offset[0], position.Offset[1], 0.0);
    const double length = interlume::Vectors::SafeLength(outward);
    outward = length > 0.0 ? outward / length : this->Frame->X;
  }
  std::copy_n(glm::value_ptr(outward), 3, normal);
}

bool vtkTerminationCylinder::EvaluatePoint(int part, const double uv[2], double x[3]) const
{
  double taken[2];
  if (!this->NormalizeParameters(part, uv, taken))
  {
    return false;
  }
  const double angle = 2.0 * vtkMath::Pi() * taken[0];
  double a = std::cos(angle);
  double b = std::sin(angle);
  if (part != WALL && !interlume::DiskParameters::ToPoint(taken, a, b))
  {
    return false;
  }
  const double along = part == WALL ? this->Length * taken[1] : 0.0;
  const glm::dvec3 point = glm::make_vec3(part == CAP_2 ? this->Point2 : this->Point1) +
    this->Frame->GetVector(this->Radius * a, this->Radius * b, along);
  std::copy_n(glm::value_ptr(point), 3, x);
  return true;
}

bool vtkTerminationCylinder::IsPeriodic(int direction, int part) const
{
  return direction == 0 && part == WALL;
}

void vtkTerminationCylinder::GetBounds(double bounds[6]) const
{
  for (int i = 0; i < 3; ++i)
  {
    const double extent = this->Radius * std::hypot(this->Frame->X[i], this->Frame->Y[i]);
    bounds[2 * i] = std::min(this->Point1[i], this->Point2[i]) - extent;
    bounds[2 * i + 1] = std::max(this->Point1[i], this->Point2[i]) + extent;
  }
}

void vtkTerminationCylinder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Point1", this->Point1 }, { "Point2", this->Point2 }, { "Radius", this->Radius },
      { "Capped", this->Capped } });
}
