// SPDX-License-Identifier: BSD-3-Clause
// Tests that visibility cycles are detected and reported, and their tetrahedra output together.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceViewRays.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/VisibilityOrder.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>

namespace
{

using namespace reference;
using Point = std::array<double, 3>;

// Returns a long tetrahedron that connects two points on a circle, 120 degrees apart, and descends
// from z = 0.1 to z = -0.1. Each of the three tetrahedra rests on the previous one.
std::array<Point, 4> MakeStick(int third)
{
  const double pi = std::acos(-1.0);
  const double begin = 2.0 * pi * third / 3.0;
  const double end = begin + 2.0 * pi / 3.0;
  Point from = { { 0.4 * std::cos(begin), 0.4 * std::sin(begin), 0.1 } };
  Point to = { { 0.4 * std::cos(end), 0.4 * std::sin(end), -0.1 } };
  const Point along = { { to[0] - from[0], to[1] - from[1], 0.0 } };
  for (int axis = 0; axis < 2; ++axis)
  {
    // Extend the ends so that the sticks cross near their ends instead of touching.
    from[axis] -= 0.2 * along[axis];
    to[axis] += 0.2 * along[axis];
  }
  const double width = 0.05 / std::hypot(along[0], along[1]);
  const double side[2] = { -along[1] * width, along[0] * width };
  return { { { { from[0] - side[0], from[1] - side[1], from[2] } },
    { { from[0] + side[0], from[1] + side[1], from[2] } }, { { to[0], to[1], to[2] - 0.03 } },
    { { to[0], to[1], to[2] + 0.03 } } } };
}

std::array<Point, 4> MakeLid(double z)
{
  return { { { { -1.0, -1.0, z } }, { 1.0, -1.0, z }, { { 0.0, 1.0, z } },
    { { 0.0, 0.0, z + 0.1 } } } };
}

void CheckSticks(Check& check)
{
  interlume::TetrahedraMesh mesh;
  Append(mesh, MakeStick(0));
  const std::uint32_t behind = Append(mesh, MakeLid(-0.4));
  Append(mesh, MakeStick(1));
  const std::uint32_t before = Append(mesh, MakeLid(0.4));
  Append(mesh, MakeStick(2));
  interlume::VisibilityOrder visibility;
  visibility.Build(mesh);
  std::vector<std::uint32_t> order;
  for (const bool isParallel : { false, true })
  {
    check.SetContext(isParallel ? "sticks in parallel" : "sticks in perspective");
    interlume::ViewRays rays =
      LookAt({ 0.0, 0.0, 4.0 }, { 0.0, 0.0, 0.0 }, isParallel ? 1.0 : 0.3, 400, isParallel);
    visibility.Compute(mesh, rays, order);
    check.Equal(visibility.GetNumberOfTetrahedraInCycles(), 3, "tetrahedra in cycles");
    check.That(IsPermutation(order, 5), "each tetrahedron occurs once");
    check.That(order.size() == 5 && order.front() == before && order.back() == behind,
      "tetrahedra in front of and behind the cycle are in order");

    // From below, the sticks form a cycle in the other direction. From the side, there is no cycle.
    rays = LookAt({ 0.0, 0.0, -4.0 }, { 0.0, 0.0, 0.0 }, isParallel ? 1.0 : 0.3, 400, isParallel);
    visibility.Compute(mesh, rays, order);
    check.Equal(visibility.GetNumberOfTetrahedraInCycles(), 3, "tetrahedra in cycles from below");
    check.That(order.size() == 5 && order.front() == behind && order.back() == before,
      "tetrahedra in front of and behind the cycle are in order from below");
    rays = LookAt({ 4.0, 1.0, 0.0 }, { 0.0, 0.0, 0.0 }, isParallel ? 1.0 : 0.3, 400, isParallel);
    visibility.Compute(mesh, rays, order);
    check.Equal(
      visibility.GetNumberOfTetrahedraInCycles(), 0, "tetrahedra in cycles from the side");
    const OrderErrors errors = ViewRayCheck(mesh).CheckPixels(rays, order, 5000, 1);
    check.That(errors.Pairs > 0 && errors.Misordered == 0, "order from the side");
  }
}

// Returns, for each tetrahedron, those face neighbors that are in front of it.
std::vector<std::vector<std::uint32_t>> Relate(
  const interlume::TetrahedraMesh& mesh, const Point& eye)
{
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> faces;
  std::vector<std::vector<std::uint32_t>> inFront(mesh.GetNumberOfTetrahedra());
  const auto side = [&](const std::array<std::uint32_t, 3>& ids, const double* p)
  {
    long double e[3][3];
    const double* a = mesh.GetPoint(ids[0]);
    for (int axis = 0; axis < 3; ++axis)
    {
      e[0][axis] = static_cast<long double>(mesh.GetPoint(ids[1])[axis]) - a[axis];
      e[1][axis] = static_cast<long double>(mesh.GetPoint(ids[2])[axis]) - a[axis];
      e[2][axis] = static_cast<long double>(p[axis]) - a[axis];
    }
    return e[2][0] * (e[0][1] * e[1][2] - e[0][2] * e[1][1]) +
      e[2][1] * (e[0][2] * e[1][0] - e[0][0] * e[1][2]) +
      e[2][2] * (e[0][0] * e[1][1] - e[0][1] * e[1][0]);
  };
  for (std::uint32_t face = 0; face < 4 * mesh.GetNumberOfTetrahedra(); ++face)
  {
    const std::uint32_t* corners = mesh.GetCorners(face / 4);
    std::array<std::uint32_t, 3> ids;
    for (std::uint32_t k = 0; k < 3; ++k)
    {
      ids[k] = corners[(face + 1 + k) % 4];
    }
    std::sort(ids.begin(), ids.end());
    const auto other = faces.emplace(ids, face);
    if (!other.second)
    {
      const std::uint32_t own = face / 4;
      const std::uint32_t neighbor = other.first->second / 4;
      const bool isOwnInFront =
        side(ids, eye.data()) * side(ids, mesh.GetPoint(corners[face % 4])) > 0.0L;
      inFront[isOwnInFront ? neighbor : own].push_back(isOwnInFront ? own : neighbor);
    }
  }
  return inFront;
}

// Returns the number of tetrahedra in cycles, which are indirectly in front of themselves.
long long CountInCycles(const std::vector<std::vector<std::uint32_t>>& inFront)
{
  long long count = 0;
  for (std::uint32_t start = 0; start < inFront.size(); ++start)
  {
    std::vector<bool> seen(inFront.size(), false);
    std::vector<std::uint32_t> open = inFront[start];
    while (!open.empty() && !seen[start])
    {
      const std::uint32_t t = open.back();
      open.pop_back();
      if (!seen[t])
      {
        seen[t] = true;
        open.insert(open.end(), inFront[t].begin(), inFront[t].end());
      }
    }
    count += seen[start] ? 1 : 0;
  }
  return count;
}

// Returns true if the order lists each tetrahedron after those in front of it, except in cycles.
bool IsOrderConsistent(
  const std::vector<std::vector<std::uint32_t>>& inFront, const std::vector<std::uint32_t>& order)
{
  const auto isReached = [&](std::uint32_t from, std::uint32_t to)
  {
    std::vector<bool> seen(inFront.size(), false);
    std::vector<std::uint32_t> open(1, from);
    while (!open.empty())
    {
      const std::uint32_t t = open.back();
      open.pop_back();
      if (t == to)
      {
        return true;
      }
      if (!seen[t])
      {
        seen[t] = true;
        open.insert(open.end(), inFront[t].begin(), inFront[t].end());
      }
    }
    return false;
  };
  std::vector<std::size_t> ranks(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    ranks[order[i]] = i;
  }
  for (std::uint32_t back = 0; back < inFront.size(); ++back)
  {
    for (const std::uint32_t front : inFront[back])
    {
      if (ranks[front] > ranks[back] && !isReached(front, back))
      {
        return false;
      }
    }
  }
  return true;
}

// Tests cycles through shared faces, which occur in convex meshes of long and thin tetrahedra.
void CheckDistorted(Check& check)
{
  CubeMeshSettings form;
  form.Cubes = 6;
  form.Pieces = 5;
  long long found = 0;
  for (unsigned int seed = 1; seed <= 12; ++seed)
  {
    interlume::TetrahedraMesh mesh = MakeCubeMesh(form);
    Distort(mesh, 0.15, 20, seed);
    interlume::VisibilityOrder visibility;
    visibility.Build(mesh);
    std::vector<std::uint32_t> order;
    for (const Point& eye :
      { Point{ { 1.3, 1.1, 1.7 } }, Point{ { -0.8, 0.3, 0.2 } }, Point{ { 0.01, 0.02, 0.03 } } })
    {
      check.SetContext("distorted, seed " + std::to_string(seed));
      interlume::ViewRays rays;
      rays.Viewpoint.Eye = glm::make_vec3(eye.data());
      visibility.Compute(mesh, rays, order);
      const auto inFront = Relate(mesh, eye);
      const long long expected = CountInCycles(inFront);
      check.Equal(visibility.GetNumberOfTetrahedraInCycles(), expected, "tetrahedra in cycles");
      check.That(
        IsPermutation(order, mesh.GetNumberOfTetrahedra()), "each tetrahedron occurs once");
      check.That(IsOrderConsistent(inFront, order), "relations outside cycles are satisfied");
      found += expected;
    }
  }
  std::cout << found << " tetrahedra in cycles over shared faces\n";
  check.SetContext("distorted");
  check.That(found > 0, "there are cycles over shared faces");
}
}

int TestTetrahedraSortCycles(int, char*[])
{
  return RunChecks({ CheckSticks, CheckDistorted });
}
