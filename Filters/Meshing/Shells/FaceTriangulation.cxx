// SPDX-License-Identifier: BSD-3-Clause
#include "Shells/FaceTriangulation.h"

#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
using PlanarPoint = std::array<double, 2>;

/// Returns twice the signed area of a triangle in the plane.
double Area(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
}

double SquaredLength(const PlanarPoint& a, const PlanarPoint& b)
{
  return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
}

/// An area below this fraction of the squared longest edge counts as rounding error.
constexpr double Flatness = 1e-12;
/// The fan is used if the shape quality of its worst triangle is at least this fraction of the best
/// possible value.
constexpr double FanTolerance = 0.1;
/// Polygons with more points are split by ear clipping, which is faster.
constexpr std::size_t MaximumPointsForOptimum = 128;

/// Returns the shape quality of a triangle: larger is better, 0 for no area, negative if inverted.
double Shape(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c)
{
  const double longest =
    std::max({ SquaredLength(a, b), SquaredLength(b, c), SquaredLength(c, a) });
  const double shape = longest > 0.0 ? Area(a, b, c) / longest : 0.0;
  return std::abs(shape) > Flatness ? shape : 0.0;
}

/// Projects the points along the coordinate axis closest to the polygon's normal. The result is
/// counterclockwise.
std::vector<PlanarPoint> Project(const std::vector<glm::dvec3>& points)
{
  glm::dvec3 normal(0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // Relative coordinates avoid cancellation far from the origin.
    normal += glm::cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]);
  }
  int main = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    main = std::abs(normal[axis]) > std::abs(normal[main]) ? axis : main;
  }
  int u = (main + 1) % 3;
  int v = (main + 2) % 3;
  if (normal[main] < 0.0)
  {
    std::swap(u, v);
  }
  std::vector<PlanarPoint> projected;
  projected.reserve(points.size());
  for (const auto& point : points)
  {
    projected.push_back({ { point[u], point[v] } });
  }
  return projected;
}

/// Returns whether the projected polygon has no area, although its points are not on a line. Two
/// halves of the polygon then have opposite orientation.
bool IsTwisted(const std::vector<glm::dvec3>& points, const std::vector<PlanarPoint>& projected)
{
  glm::dvec3 direction(0.0);
  double area = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const glm::dvec3 other = points[i] - points[0];
    direction = glm::dot(other, other) > glm::dot(direction, direction) ? other : direction;
    area += Area(projected[0], projected[i], projected[(i + 1) % points.size()]);
  }
  const double negligible = Flatness * glm::dot(direction, direction);
  return area <= negligible &&
    std::any_of(points.begin(), points.end(),
      [&](const glm::dvec3& x)
      { return glm::length(glm::cross(x - points[0], direction)) > negligible; });
}

using Corners = std::array<std::size_t, 3>;

/// Returns the minimum shape quality of the triangles of the fan from the first point.
double GetFanShape(const std::vector<PlanarPoint>& projected)
{
  double minimum = 1.0;
  for (std::size_t i = 1; i + 1 < projected.size(); ++i)
  {
    minimum = std::min(minimum, Shape(projected[0], projected[i], projected[i + 1]));
  }
  return minimum;
}

/**
 * Finds the triangulation with the largest minimum shape quality, by dynamic programming over
 * sections of the polygon between two points (G. T. Klincsek, "Minimal triangulations of polygonal
 * domains", Annals of Discrete Mathematics 9, 1980). If all triangles have positive area, they
 * cover a simple polygon exactly once, so diagonals need not be checked for intersections. Returns
 * the minimum quality.
 */
double FindBest(const std::vector<PlanarPoint>& projected, std::vector<Corners>& triangles)
{
  const std::size_t n = projected.size();
  struct Part
  {
    double Shape = 1.0;
    std::size_t Apex = 0;
  };
  std::vector<Part> parts(n * n);
  for (std::size_t length = 2; length < n; ++length)
  {
    for (std::size_t i = 0; i + length < n; ++i)
    {
      const std::size_t j = i + length;
      Part& part = parts[i * n + j];
      part.Shape = -1.0;
      for (std::size_t k = i + 1; k < j; ++k)
      {
        const double shape = std::min({ parts[i * n + k].Shape, parts[k * n + j].Shape,
          Shape(projected[i], projected[k], projected[j]) });
        if (shape > part.Shape)
        {
          part = { shape, k };
        }
      }
    }
  }
  std::vector<std::array<std::size_t, 2>> stack = { { { 0, n - 1 } } };
  while (!stack.empty())
  {
    const auto ends = stack.back();
    stack.pop_back();
    if (ends[1] - ends[0] > 1)
    {
      const std::size_t apex = parts[ends[0] * n + ends[1]].Apex;
      triangles.push_back({ { ends[0], apex, ends[1] } });
      stack.push_back({ { ends[0], apex } });
      stack.push_back({ { apex, ends[1] } });
    }
  }
  return parts[n - 1].Shape;
}

/// Triangulates by ear clipping. Each step clips the ear with the best shape quality. Returns the
/// minimum quality.
double CutEars(const std::vector<PlanarPoint>& projected, std::vector<Corners>& ears)
{
  double minimum = 1.0;
  std::vector<std::size_t> ring(projected.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    ring[i] = i;
  }
  while (ring.size() > 2)
  {
    std::size_t best = ring.size();
    double bestShape = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const std::size_t a = ring[(i + ring.size() - 1) % ring.size()];
      const std::size_t b = ring[i];
      const std::size_t c = ring[(i + 1) % ring.size()];
      const double shape = Shape(projected[a], projected[b], projected[c]);
      const bool isEar = shape > bestShape &&
        std::none_of(ring.begin(), ring.end(),
          [&](std::size_t p)
          {
            return p != a && p != b && p != c &&
              Shape(projected[a], projected[b], projected[p]) >= 0.0 &&
              Shape(projected[b], projected[c], projected[p]) >= 0.0 &&
              Shape(projected[c], projected[a], projected[p]) >= 0.0;
          });
      if (isEar)
      {
        best = i;
        bestShape = shape;
      }
    }
    if (best == ring.size())
    {
      return 0.0;
    }
    minimum = std::min(minimum, bestShape);
    ears.push_back({ { ring[(best + ring.size() - 1) % ring.size()], ring[best],
      ring[(best + 1) % ring.size()] } });
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return minimum;
}
}

namespace
{
/// Removes repeated points, and spikes, where the polygon returns along the same edge. Returns
/// whether there are spikes.
bool Clean(std::vector<vtkIdType>& polygon)
{
  bool hasSpikes = false;
  for (std::size_t i = 0; polygon.size() > 1 && i < polygon.size();)
  {
    const std::size_t next = (i + 1) % polygon.size();
    const bool isSpike = polygon.size() > 2 && polygon[i] == polygon[(i + 2) % polygon.size()];
    if (polygon[i] != polygon[next] && !isSpike)
    {
      ++i;
      continue;
    }
    hasSpikes = hasSpikes || polygon[i] != polygon[next];
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(next));
    i = 0;
  }
  return hasSpikes;
}
}

FaceTriangulation::FaceTriangulation(std::function<glm::dvec3(vtkIdType)> getPoint, Order isBefore)
  : GetPoint(std::move(getPoint))
  , IsBefore(std::move(isBefore))
{
}

FaceTriangulation::Result FaceTriangulation::Triangulate(
  std::vector<vtkIdType> polygon, std::vector<Triangle>& triangles) const
{
  Result result = Clean(polygon) ? Result::Flat : Result::Simple;
  if (polygon.size() < 3)
  {
    return result;
  }
  // Choose a start and a direction that are the same for both cells that share the face.
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end(), this->IsBefore),
    polygon.end());
  const bool isReversed = this->IsBefore(polygon.back(), polygon[1]);
  if (isReversed)
  {
    std::reverse(polygon.begin() + 1, polygon.end());
  }
  const auto append = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
    triangles.push_back(isReversed ? Triangle{ { a, c, b } } : Triangle{ { a, b, c } });
  };
  if (polygon.size() == 3)
  {
    append(polygon[0], polygon[1], polygon[2]);
    return result;
  }
  std::vector<glm::dvec3> points;
  points.reserve(polygon.size());
  for (vtkIdType id : polygon)
  {
    points.push_back(this->GetPoint(id));
  }
  const std::vector<PlanarPoint> projected = Project(points);
  std::vector<Corners> best;
  const double shape = projected.size() <= MaximumPointsForOptimum ? FindBest(projected, best)
                                                                   : CutEars(projected, best);
  const double fanShape = GetFanShape(projected);
  const bool isComplete = best.size() + 2 == polygon.size();
  if (!(shape > 0.0) && !(fanShape > 0.0))
  {
    const bool isFlat = isComplete && shape == 0.0 && !IsTwisted(points, projected);
    result = isFlat ? Result::Flat : Result::Crossing;
  }
  if (!isComplete || (fanShape > 0.0 && fanShape >= FanTolerance * shape))
  {
    best.clear();
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    {
      best.push_back({ { 0, i, i + 1 } });
    }
  }
  for (const Corners& corners : best)
  {
    append(polygon[corners[0]], polygon[corners[1]], polygon[corners[2]]);
  }
  return result;
}

}
