// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationPlane.h"

#include "Common/FiniteNumbers.h"
#include "Common/NamedValue.h"
#include "Common/Vectors.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTerminationPlane);

std::string vtkTerminationPlane::Update()
{
  for (const double* point : { this->Origin, this->Point1, this->Point2 })
  {
    if (!interlume::FiniteNumbers::AreFinite(point, 3))
    {
      return "a corner of the plane is not finite";
    }
  }
  double edges[2][3];
  double lengths[2];
  vtkMath::Subtract(this->Point1, this->Origin, edges[0]);
  vtkMath::Subtract(this->Point2, this->Origin, edges[1]);
  for (int i = 0; i < 2; ++i)
  {
    lengths[i] = interlume::Vectors::SafeLength(glm::make_vec3(edges[i]));
    if (!interlume::FiniteNumbers::IsSize(lengths[i]))
    {
      return i == 0 ? "the plane's edge from Origin to Point1 has no length"
                    : "the plane's edge from Origin to Point2 has no length";
    }
    for (double& component : edges[i])
    {
      component /= lengths[i];
    }
  }
  vtkMath::Cross(edges[0], edges[1], this->Normal);
  const double sine = vtkMath::Normalize(this->Normal);
  if (!(sine > 1e-12))
  {
    return "the plane's edges are parallel";
  }
  vtkMath::Cross(edges[1], this->Normal, this->Gradients[0]);
  vtkMath::Cross(this->Normal, edges[0], this->Gradients[1]);
  for (int i = 0; i < 2; ++i)
  {
    vtkMath::MultiplyScalar(this->Gradients[i], 1.0 / (sine * lengths[i]));
  }
  return {};
}

double vtkTerminationPlane::EvaluateDistance(const double x[3]) const
{
  double p[3];
  vtkMath::Subtract(x, this->Origin, p);
  return vtkMath::Dot(p, this->Normal);
}

void vtkTerminationPlane::GetFoot(const double x[3], double uv[2]) const
{
  double p[3];
  vtkMath::Subtract(x, this->Origin, p);
  uv[0] = vtkMath::Dot(p, this->Gradients[0]);
  uv[1] = vtkMath::Dot(p, this->Gradients[1]);
}

bool vtkTerminationPlane::IsOn(const double x[3]) const
{
  double uv[2];
  this->GetFoot(x, uv);
  return this->Unbounded ||
    std::all_of(uv, uv + 2, [](double w) { return std::abs(w - 0.5) <= 0.5 + BorderTolerance; });
}

void vtkTerminationPlane::EvaluateParameters(const double x[3], double uv[2]) const
{
  this->GetFoot(x, uv);
  for (int i = 0; i < 2 && !this->Unbounded; ++i)
  {
    uv[i] = std::max(0.0, std::min(uv[i], 1.0));
  }
}

void vtkTerminationPlane::EvaluateNormal(const double*, double normal[3]) const
{
  std::copy_n(this->Normal, 3, normal);
}

bool vtkTerminationPlane::EvaluatePoint(int part, const double uv[2], double x[3]) const
{
  double taken[2] = { uv[0], uv[1] };
  const bool isThere = this->Unbounded ? part == 0 && std::isfinite(uv[0]) && std::isfinite(uv[1])
                                       : this->NormalizeParameters(part, uv, taken);
  for (int i = 0; isThere && i < 3; ++i)
  {
    x[i] = this->Origin[i] + taken[0] * (this->Point1[i] - this->Origin[i]) +
      taken[1] * (this->Point2[i] - this->Origin[i]);
  }
  return isThere;
}

void vtkTerminationPlane::GetBounds(double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  for (int i = 0; !this->Unbounded && i < 3; ++i)
  {
    const double opposite = this->Point1[i] + this->Point2[i] - this->Origin[i];
    const auto range = std::minmax({ this->Origin[i], this->Point1[i], this->Point2[i], opposite });
    bounds[2 * i] = range.first;
    bounds[2 * i + 1] = range.second;
  }
}

void vtkTerminationPlane::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Origin", this->Origin }, { "Point1", this->Point1 }, { "Point2", this->Point2 },
      { "Unbounded", this->Unbounded } });
}
