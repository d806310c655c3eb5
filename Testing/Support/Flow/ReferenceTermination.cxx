// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Flow/ReferenceTermination.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceRandom.h"

#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference
{

namespace
{

// Returns the difference a - b of two values of a parameter, or the shortest difference if the
// parameter is periodic.
double Difference(const vtkTerminationSurface* surface, int direction, int part, double a, double b)
{
  const double difference = a - b;
  return surface->IsPeriodic(direction, part) ? difference - std::round(difference) : difference;
}

}

std::vector<SurfaceScale> MakeSurfaceScales()
{
  std::vector<SurfaceScale> scales(4);
  scales[1].Size = 1e-9;
  scales[2].Size = 1e9;
  scales[3].Center = { { 1e6, -1e6, 2e6 } };
  scales[3].Rounding = 2e-9;
  return scales;
}

double GetSurfaceDistance(const vtkTerminationSurface* surface, const Vector& x)
{
  return surface->EvaluateDistance(x.data());
}

std::vector<Vector> MakeRandomPointsNear(const SurfaceScale& scale, int number, unsigned seed)
{
  Random random(seed);
  std::vector<Vector> points;
  for (int i = 0; i < number; ++i)
  {
    // Of every four points, three are close to the surface and one is far away.
    const double reach = i % 4 == 3 ? 20.0 : 1.2;
    points.push_back(scale.Center + reach * scale.Size * random.GetPoint(1.0));
  }
  return points;
}

void CheckLipschitz(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::string& name, Check& check)
{
  Random random(7);
  for (const Vector& a : MakeRandomPointsNear(scale, 2000, 1))
  {
    const double step = scale.Size * std::pow(10.0, random.Get(-6.0, 0.5));
    const Vector b = a + step * random.GetDirection();
    const double length = GetNorm(b - a);
    const double change = std::abs(GetSurfaceDistance(surface, b) - GetSurfaceDistance(surface, a));
    check.That(change <= length + 30.0 * scale.Rounding * scale.Size,
      name + ": the distance changes by " + std::to_string(change / length) +
        " of the distance between the points");
  }
}

void CheckRoundTrip(const vtkTerminationSurface* surface, const SurfaceScale& scale, int number,
  const std::string& name, Check& check)
{
  double bounds[6];
  surface->GetBounds(bounds);
  const bool isBounded = bounds[0] <= bounds[1];
  Random random(3);
  int found = 0;
  for (const auto& [part, i] : AllIndices(surface->GetNumberOfParts(), 300))
  {
    const double uv[2] = { random.Get(0.001, 0.999), random.Get(0.001, 0.999) };
    Vector x;
    if (!surface->EvaluatePoint(part, uv, x.data()))
    {
      continue;
    }
    ++found;
    const double reach = scale.Rounding * scale.Size;
    check.Near(GetSurfaceDistance(surface, x), 0.0, reach,
      name + ": distance at a point of the surface", 1.0);
    check.That(surface->IsOn(x.data()), name + ": IsOn is true at a point of the surface");
    check.Equal(surface->EvaluatePart(x.data()), part, name + ": part");
    double again[2];
    surface->EvaluateParameters(x.data(), again);
    for (int j = 0; j < 2; ++j)
    {
      check.Near(Difference(surface, j, part, again[j], uv[j]), 0.0, 1000.0 * scale.Rounding,
        name + ": parameter " + std::to_string(j) + " of part " + std::to_string(part), 1.0);
      check.That(!surface->IsPeriodic(j, part) || (again[j] >= 0.0 && again[j] < 1.0),
        name + ": a periodic parameter is from 0 to below 1");
    }
    for (int axis = 0; axis < 3 && isBounded; ++axis)
    {
      check.That(x[axis] >= bounds[2 * axis] - reach && x[axis] <= bounds[2 * axis + 1] + reach,
        name + ": a point of the surface is in the bounds");
    }
  }
  check.That(found >= number, name + ": " + std::to_string(found) + " points are on the surface");
}

void CheckNormals(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::string& name, Check& check)
{
  Random random(5);
  const double step = scale.Size * std::max(1e-5, std::sqrt(scale.Rounding));
  const double tolerance = 1e-3 + 4.0 * scale.Rounding * scale.Size / step;
  for (int i = 0; i < 300; ++i)
  {
    const int part = i % surface->GetNumberOfParts();
    const double uv[2] = { random.Get(0.01, 0.99), random.Get(0.01, 0.99) };
    Vector x;
    if (!surface->EvaluatePoint(part, uv, x.data()))
    {
      continue;
    }
    Vector normal;
    surface->EvaluateNormal(x.data(), normal.data());
    check.Near(GetNorm(normal), 1.0, 1e-12, name + ": length of a normal");
    for (double side : { -1.0, 1.0 })
    {
      check.Near(GetSurfaceDistance(surface, x + side * step * normal) / step, side, tolerance,
        name + ": distance along the normal");
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      Vector direction = { { 0.0, 0.0, 0.0 } };
      direction[axis] = 1.0;
      const double slope = (GetSurfaceDistance(surface, x + step * direction) -
                             GetSurfaceDistance(surface, x - step * direction)) /
        (2.0 * step);
      check.Near(slope, normal[axis], tolerance, name + ": gradient of the distance", 1.0);
    }
  }
}

void CheckDistance(const vtkTerminationSurface* surface, const SurfaceScale& scale,
  const std::function<double(const Vector&)>& expected, const std::string& name, Check& check)
{
  for (const Vector& x : MakeRandomPointsNear(scale, 2000, 11))
  {
    check.Near(GetSurfaceDistance(surface, x), expected(x), 10.0 * scale.Rounding,
      name + ": distance", scale.Size);
  }
}

void CheckSamples(const vtkTerminationSurface* surface, const SurfaceScale& scale, int samples,
  double spacing, const std::string& name, Check& check)
{
  std::vector<Vector> points;
  for (const auto& [part, i] :
    AllIndices(surface->GetNumberOfParts(), (samples + 1) * (samples + 1)))
  {
    const int row = i / (samples + 1);
    const int column = i % (samples + 1);
    const double uv[2] = { static_cast<double>(column) / samples,
      static_cast<double>(row) / samples };
    Vector x;
    if (surface->EvaluatePoint(part, uv, x.data()))
    {
      points.push_back(x);
    }
  }
  check.That(
    points.size() > static_cast<std::size_t>(samples), name + ": there are enough samples");
  for (const Vector& x : MakeRandomPointsNear(scale, 200, 13))
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vector& point : points)
    {
      nearest = std::min(nearest, GetNorm(point - x));
    }
    const double distance = std::abs(GetSurfaceDistance(surface, x));
    check.That(
      distance <= nearest + 30.0 * scale.Rounding * scale.Size && nearest <= distance + spacing,
      name + ": the distance to the nearest sample is " + std::to_string(nearest / scale.Size) +
        ", the distance to the surface is " + std::to_string(distance / scale.Size));
  }
}

}
