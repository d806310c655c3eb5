// SPDX-License-Identifier: BSD-3-Clause
// Facets of convex hulls of random points in two to six dimensions, compared with the planes
// through all subsets of the points. Coordinates of 0, 1 and 2 put many points on one plane.
// Coordinates up to 128 cause products of normals that do not fit the integer type.

#include "Support/Checks/ReferenceCheck.h"

#include "Hulls/ConvexHull.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <vector>

using namespace interlume;

namespace
{

using Point = ConvexHull::Point;
using Points = std::vector<Point>;

std::int64_t GetDeterminant(std::vector<std::vector<std::int64_t>> m)
{
  if (m.empty())
  {
    return 1;
  }
  std::int64_t sum = 0;
  for (std::size_t row = 0; row < m.size(); ++row)
  {
    if (m[row][0] == 0)
    {
      continue;
    }
    std::vector<std::vector<std::int64_t>> minor;
    for (std::size_t other = 0; other < m.size(); ++other)
    {
      if (other != row)
      {
        minor.emplace_back(m[other].begin() + 1, m[other].end());
      }
    }
    sum += (row % 2 == 0 ? 1 : -1) * m[row][0] * GetDeterminant(minor);
  }
  return sum;
}

// Returns a normal of the hyperplane through a subset of the points, or zero if the subset does not
// span a hyperplane.
std::vector<std::int64_t> GetNormal(
  int dimension, const Points& points, const std::vector<int>& subset)
{
  std::vector<std::int64_t> normal;
  for (int skip = 0; skip < dimension; ++skip)
  {
    std::vector<std::vector<std::int64_t>> rows;
    for (int k = 1; k < dimension; ++k)
    {
      rows.emplace_back();
      for (int axis = 0; axis < dimension; ++axis)
      {
        if (axis != skip)
        {
          rows.back().push_back(points[subset[k]][axis] - points[subset[0]][axis]);
        }
      }
    }
    normal.push_back((skip % 2 == 0 ? 1 : -1) * GetDeterminant(rows));
  }
  return normal;
}

template <typename Normal>
std::int64_t GetHeight(int dimension, const Normal& normal, const Point& p, const Point& origin)
{
  std::int64_t height = 0;
  for (int axis = 0; axis < dimension; ++axis)
  {
    height += normal[axis] * (p[axis] - origin[axis]);
  }
  return height;
}

// A set of facets, each given by the sorted indices of its points.
using FacetSet = std::set<std::vector<int>>;

FacetSet FindFacets(int dimension, const Points& points)
{
  FacetSet facets;
  const int n = static_cast<int>(points.size());
  std::vector<bool> chosen(n, false);
  std::fill(chosen.end() - dimension, chosen.end(), true);
  do
  {
    std::vector<int> subset;
    for (int i = 0; i < n; ++i)
    {
      if (chosen[i])
      {
        subset.push_back(i);
      }
    }
    const auto normal = GetNormal(dimension, points, subset);
    std::vector<int> on;
    int above = 0;
    int below = 0;
    for (int i = 0; i < n; ++i)
    {
      const std::int64_t height = GetHeight(dimension, normal, points[i], points[subset[0]]);
      above += height > 0;
      below += height < 0;
      if (height == 0)
      {
        on.push_back(i);
      }
    }
    if ((above == 0) != (below == 0))
    {
      facets.insert(on);
    }
  } while (std::next_permutation(chosen.begin(), chosen.end()));
  return facets;
}

void TestPoints(int dimension, const Points& points, reference::Check& check)
{
  const ConvexHull hull(dimension, points);
  FacetSet found;
  bool isOutward = true;
  for (const ConvexHull::Facet& facet : hull.GetFacets())
  {
    std::vector<int> on;
    facet.Points.ForEach([&on](int i) { on.push_back(i); });
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
    {
      const std::int64_t height = GetHeight(dimension, facet.Outward, points[i], points[on[0]]);
      isOutward = isOutward && (facet.Points.Contains(i) ? height == 0 : height < 0);
    }
    found.insert(on);
  }
  check.Equal(found.size(), hull.GetFacets().size(), "no facet is repeated");
  check.That(found == FindFacets(dimension, points), "facets and all of their points");
  check.That(isOutward, "normals point away from the points that are not on the facet");
}

}

int TestIsotableHull(int, char*[])
{
  reference::Check check;
  std::mt19937 random(5);
  for (int dimension = 2; dimension <= 6; ++dimension)
  {
    for (const int largest : { 2, 128 })
    {
      check.SetContext(
        std::to_string(dimension) + " dimensions, coordinates to " + std::to_string(largest));
      for (int round = 0; round < 20; ++round)
      {
        // Some point sets have too few points for a full-dimensional hull.
        Points points(dimension + random() % 6);
        for (Point& p : points)
        {
          p = Point{};
          for (int axis = 0; axis < dimension; ++axis)
          {
            p[axis] = static_cast<int>(random() % (largest + 1)) * (random() % 2 == 0 ? 1 : -1);
            p[axis] = largest == 2 ? std::abs(p[axis]) : p[axis];
          }
        }
        TestPoints(dimension, points, check);
      }
    }
  }
  return check.Result();
}
