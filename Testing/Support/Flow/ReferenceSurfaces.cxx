// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Flow/ReferenceSurfaces.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

namespace reference
{

vtkStandardNewMacro(FormulaSurface);

vtkSmartPointer<FormulaSurface> FormulaSurface::Plane(
  const Position& normal, double offset, int j, int k)
{
  auto plane = vtkSmartPointer<FormulaSurface>::New();
  plane->Distance = [normal, offset](const double* x)
  { return normal[0] * x[0] + normal[1] * x[1] + normal[2] * x[2] - offset; };
  plane->Parameters = [j, k](const double* x, double* uv)
  {
    uv[0] = x[j];
    uv[1] = x[k];
  };
  return plane;
}

vtkSmartPointer<FormulaSurface> FormulaSurface::Sphere(const Position& center, double radius)
{
  auto sphere = vtkSmartPointer<FormulaSurface>::New();
  sphere->Distance = [center, radius](const double* x)
  { return std::sqrt(vtkMath::Distance2BetweenPoints(x, center.data())) - radius; };
  sphere->Parameters = [center](const double* x, double* uv)
  {
    const double turn = std::atan2(x[1] - center[1], x[0] - center[0]) / (2.0 * vtkMath::Pi());
    uv[0] = turn - std::floor(turn);
    uv[1] =
      std::acos((x[2] - center[2]) / std::sqrt(vtkMath::Distance2BetweenPoints(x, center.data()))) /
      vtkMath::Pi();
  };
  return sphere;
}

void FormulaSurface::EvaluateNormal(const double x[3], double normal[3]) const
{
  // Central differences are accurate enough for all tests.
  constexpr double small = 1e-6;
  for (int i = 0; i < 3; ++i)
  {
    double before[3] = { x[0], x[1], x[2] };
    double after[3] = { x[0], x[1], x[2] };
    before[i] -= small;
    after[i] += small;
    normal[i] = (this->Distance(after) - this->Distance(before)) / (2.0 * small);
  }
  vtkMath::Normalize(normal);
}

bool FormulaSurface::EvaluatePoint(int, const double*, double*) const
{
  return false;
}

void FormulaSurface::GetBounds(double bounds[6]) const
{
  const double none[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  std::copy(none, none + 6, bounds);
}

}
