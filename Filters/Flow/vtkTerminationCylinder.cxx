// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationCylinder.h"

#include "Common/FiniteNumbers.h"
#include "Common/NamedValue.h"
#include "Common/Vectors.h"
#include "Termination/AxialFrame.h"
#include "Termination/DiscParameters.h"

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
    return "the cylinder's radius is not finite and above 0";
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

vtkTerminationCylinder::Place vtkTerminationCylinder::GetPlace(const double x[3]) const
{
  const glm::dvec3 p = this->Frame->GetComponents(glm::make_vec3(x), glm::make_vec3(this->Point1));
  Place place;
  place.Offset[0] = p[0];
  place.Offset[1] = p[1];
  place.Along = p[2];
  place.Wall = std::hypot(p[0], p[1]) - this->Radius;
  place.End = std::max(-p[2], p[2] - this->Length);
  place.Part = WALL;
  if (this->Capped && place.End > place.Wall)
  {
    place.Part = p[2] < 0.5 * this->Length ? CAP_1 : CAP_2;
  }
  return place;
}

double vtkTerminationCylinder::EvaluateDistance(const double x[3]) const
{
  const Place place = this->GetPlace(x);
  if (!this->Capped)
  {
    return place.Wall;
  }
  return place.Wall > 0.0 && place.End > 0.0 ? std::hypot(place.Wall, place.End)
                                             : std::max(place.Wall, place.End);
}

bool vtkTerminationCylinder::IsOn(const double x[3]) const
{
  return this->Capped || this->GetPlace(x).End <= BorderTolerance * this->Length;
}

int vtkTerminationCylinder::EvaluatePart(const double x[3]) const
{
  return this->GetPlace(x).Part;
}

void vtkTerminationCylinder::EvaluateParameters(const double x[3], double uv[2]) const
{
  const Place place = this->GetPlace(x);
  if (place.Part == WALL)
  {
    uv[0] = interlume::AxialFrame::GetTurn(place.Offset[0], place.Offset[1]);
    uv[1] = std::max(0.0, std::min(place.Along / this->Length, 1.0));
    return;
  }
  interlume::DiscParameters::FromPoint(
    place.Offset[0] / this->Radius, place.Offset[1] / this->Radius, uv);
}

void vtkTerminationCylinder::EvaluateNormal(const double x[3], double normal[3]) const
{
  const Place place = this->GetPlace(x);
  glm::dvec3 outward = this->Frame->GetVector(0.0, 0.0, place.Part == CAP_1 ? -1.0 : 1.0);
  if (place.Part == WALL)
  {
    outward = this->Frame->GetVector(place.Offset[0], place.Offset[1], 0.0);
    const double length = interlume::Vectors::SafeLength(outward);
    outward = length > 0.0 ? outward / length : this->Frame->X;
  }
  std::copy_n(glm::value_ptr(outward), 3, normal);
}

bool vtkTerminationCylinder::EvaluatePoint(int part, const double uv[2], double x[3]) const
{
  double taken[2];
  if (!this->TakeParameters(part, uv, taken))
  {
    return false;
  }
  const double angle = 2.0 * vtkMath::Pi() * taken[0];
  double a = std::cos(angle);
  double b = std::sin(angle);
  if (part != WALL && !interlume::DiscParameters::ToPoint(taken, a, b))
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
