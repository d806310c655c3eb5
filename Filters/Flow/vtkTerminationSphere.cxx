// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationSphere.h"

#include "Common/FiniteNumbers.h"
#include "Common/NamedValue.h"
#include "Common/Vectors.h"
#include "Termination/AxialFrame.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTerminationSphere);

vtkTerminationSphere::vtkTerminationSphere()
  : Frame(std::make_unique<interlume::AxialFrame>())
{
}

vtkTerminationSphere::~vtkTerminationSphere() = default;

std::string vtkTerminationSphere::Update()
{
  if (!interlume::FiniteNumbers::AreFinite(this->Center, 3))
  {
    return "the sphere's center is not finite";
  }
  if (!interlume::FiniteNumbers::IsSize(this->Radius))
  {
    return "the sphere's radius must be finite and greater than 0";
  }
  if (!interlume::FiniteNumbers::IsSize(interlume::Vectors::SafeLength(glm::make_vec3(this->Axis))))
  {
    return "the sphere's axis is not finite or has no length";
  }
  this->Frame->SetAxis(glm::make_vec3(this->Axis));
  return {};
}

double vtkTerminationSphere::EvaluateDistance(const double x[3]) const
{
  return interlume::Vectors::SafeLength(interlume::Vectors::Difference(x, this->Center)) -
    this->Radius;
}

void vtkTerminationSphere::EvaluateParameters(const double x[3], double uv[2]) const
{
  const glm::dvec3 p = this->Frame->GetComponents(glm::make_vec3(x), glm::make_vec3(this->Center));
  uv[0] = interlume::AxialFrame::GetAngleInTurns(p[0], p[1]);
  uv[1] = 0.5 + std::atan2(p[2], std::hypot(p[0], p[1])) / vtkMath::Pi();
}

void vtkTerminationSphere::EvaluateNormal(const double x[3], double normal[3]) const
{
  const glm::dvec3 away = interlume::Vectors::Difference(x, this->Center);
  const double length = interlume::Vectors::SafeLength(away);
  const glm::dvec3 outward = length > 0.0 ? away / length : this->Frame->Axis;
  std::copy_n(glm::value_ptr(outward), 3, normal);
}

bool vtkTerminationSphere::EvaluatePoint(int part, const double uv[2], double x[3]) const
{
  double taken[2];
  if (!this->NormalizeParameters(part, uv, taken))
  {
    return false;
  }
  const double longitude = 2.0 * vtkMath::Pi() * taken[0];
  const double latitude = vtkMath::Pi() * (taken[1] - 0.5);
  const double across = this->Radius * std::cos(latitude);
  const glm::dvec3 point = glm::make_vec3(this->Center) +
    this->Frame->GetVector(across * std::cos(longitude), across * std::sin(longitude),
      this->Radius * std::sin(latitude));
  std::copy_n(glm::value_ptr(point), 3, x);
  return true;
}

bool vtkTerminationSphere::IsPeriodic(int direction, int) const
{
  return direction == 0;
}

void vtkTerminationSphere::GetBounds(double bounds[6]) const
{
  for (int i = 0; i < 3; ++i)
  {
    bounds[2 * i] = this->Center[i] - this->Radius;
    bounds[2 * i + 1] = this->Center[i] + this->Radius;
  }
}

void vtkTerminationSphere::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(
    os, indent, { { "Center", this->Center }, { "Radius", this->Radius }, { "Axis", this->Axis } });
}
