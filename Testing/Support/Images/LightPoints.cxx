// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/LightPoints.h"

#include "Support/Arrays/ReferenceIndices.h"

#include "vtkMath.h"

#include <cmath>

namespace reference
{

namespace
{

LightPoint At(const Double3& center, const Double3& side, const Double3& up, double s, double t)
{
  LightPoint point;
  for (int k = 0; k < 3; ++k)
  {
    point.Position[k] = center[k] + s * side[k] + t * up[k];
  }
  return point;
}

}

std::vector<LightPoint> MakeParallelogramLightPoints(
  const Double3& center, const Double3& side, const Double3& up, int count)
{
  const double n = count;
  std::vector<LightPoint> points;
  for (const auto& [j, i] : AllIndices(count, count))
  {
    points.push_back(
      At(center, side, up, (i + (j + 0.5) / n) / n - 0.5, (j + (i + 0.5) / n) / n - 0.5));
  }
  return points;
}

std::vector<LightPoint> MakeEllipseLightPoints(
  const Double3& center, const Double3& side, const Double3& up, int count)
{
  const double golden = vtkMath::Pi() * (3.0 - std::sqrt(5.0));
  std::vector<LightPoint> points;
  for (int i = 0; i < count; ++i)
  {
    const double radius = 0.5 * std::sqrt((i + 0.5) / count);
    points.push_back(
      At(center, side, up, radius * std::cos(i * golden), radius * std::sin(i * golden)));
  }
  return points;
}

}
