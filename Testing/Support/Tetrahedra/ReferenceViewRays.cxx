// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Tetrahedra/ReferenceViewRays.h"

#include "Order/VisibilityOrder.h"
#include "Support/Checks/ReferenceCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace reference
{
namespace
{
// Minimum length of a ray's segment in a tetrahedron. Shorter segments are skipped, since rounding
// errors would decide whether the ray hits the tetrahedron.
constexpr double MinimumLength = 1e-7;
constexpr double Tolerance = 1e-9;

std::vector<std::uint32_t> GetRanks(const std::vector<std::uint32_t>& order)
{
  std::vector<std::uint32_t> ranks(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    ranks[order[i]] = static_cast<std::uint32_t>(i);
  }
  return ranks;
}
}

interlume::ViewRays LookAt(
  const glm::dvec3& eye, const glm::dvec3& target, double halfSize, int pixels, bool isParallel)
{
  interlume::ViewRays rays;
  rays.Viewpoint.IsParallel = isParallel;
  rays.Viewpoint.Eye = eye;
  rays.Viewpoint.Direction = glm::normalize(target - eye);
  const glm::dvec3 up = std::abs(rays.Viewpoint.Direction[1]) > 0.9 ? glm::dvec3(0.0, 0.0, 1.0)
                                                                    : glm::dvec3(0.0, 1.0, 0.0);
  rays.Right = glm::normalize(glm::cross(rays.Viewpoint.Direction, up));
  rays.Up = glm::cross(rays.Right, rays.Viewpoint.Direction);
  rays.HalfSize = { { halfSize, halfSize } };
  rays.Width = pixels;
  rays.Height = pixels;
  return rays;
}

std::vector<View> GetViews(int pixels, const glm::dvec3& hole)
{
  const glm::dvec3 center = { 0.01, -0.02, 0.015 };
  std::vector<View> views = {
    { "perspective", LookAt({ 1.3, 1.1, 1.7 }, center, 0.4, pixels, false) },
    { "perspective, near", LookAt({ -0.71, 0.13, 0.21 }, center, 1.2, pixels, false) },
    { "perspective, far", LookAt({ 130.0, -250.0, 470.0 }, center, 0.0016, pixels, false) },
    { "from within", LookAt({ 0.011, 0.021, -0.017 }, { 0.3, 0.5, 0.4 }, 1.5, pixels, false) },
    { "from a hole", LookAt(hole, { -0.4, -0.2, -0.3 }, 1.5, pixels, false) },
    { "from a hole, back", LookAt(hole, { 0.4, 0.3, 0.6 }, 1.0, pixels, false) },
    { "along an axis", LookAt({ 0.0, 0.0, 2.0 }, { 0.0, 0.0, 0.0 }, 0.4, pixels, false) },
    { "parallel", LookAt({ 1.3, 0.9, 0.6 }, center, 0.8, pixels, true) },
    { "parallel along an axis", LookAt({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }, 0.6, pixels, true) },
  };
  View shifted = views[0];
  shifted.Name = "perspective, shifted, mirrored, not square";
  shifted.Rays.Center = { { 0.1, -0.05 } };
  shifted.Rays.HalfSize = { { 0.3, 0.2 } };
  shifted.Rays.Height = pixels / 2;
  shifted.Rays.Right = -1.5 * shifted.Rays.Right;
  views.push_back(shifted);
  shifted.Name = "parallel, shifted, mirrored, not square";
  shifted.Rays.Viewpoint.IsParallel = true;
  views.push_back(shifted);
  return views;
}

ViewRayCheck::ViewRayCheck(const interlume::TetrahedraMesh& mesh)
{
  for (std::uint32_t t = 0; t < mesh.GetNumberOfTetrahedra(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      const std::uint32_t* corners = mesh.GetCorners(t);
      const glm::dvec3 a = glm::make_vec3(mesh.GetPoint(corners[(k + 1) & 3]));
      const glm::dvec3 b = glm::make_vec3(mesh.GetPoint(corners[(k + 2) & 3]));
      const glm::dvec3 c = glm::make_vec3(mesh.GetPoint(corners[(k + 3) & 3]));
      glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
      if (glm::dot(normal, glm::make_vec3(mesh.GetPoint(corners[k])) - a) > 0.0)
      {
        normal = -normal;
      }
      this->Planes.push_back({ normal, glm::dot(normal, a) });
    }
  }
}

void ViewRayCheck::CheckLine(const interlume::ViewRays& rays, double x, double y,
  const std::vector<std::uint32_t>& ranks, OrderErrors& errors) const
{
  const bool isParallel = rays.Viewpoint.IsParallel;
  const glm::dvec3 shift = x * rays.Right + y * rays.Up;
  const glm::dvec3 origin = isParallel ? rays.Viewpoint.Eye + shift : rays.Viewpoint.Eye;
  const glm::dvec3 direction =
    glm::normalize(isParallel ? rays.Viewpoint.Direction : rays.Viewpoint.Direction + shift);
  struct Segment
  {
    double Entry;
    double Exit;
    std::uint32_t Tetrahedron;
  };
  std::vector<Segment> segments;
  for (std::size_t t = 0; t < this->Planes.size() / 4; ++t)
  {
    double entry = isParallel ? std::numeric_limits<double>::lowest() : 0.0;
    double exit = std::numeric_limits<double>::max();
    for (std::size_t f = 4 * t; f < 4 * t + 4 && entry < exit; ++f)
    {
      const double slope = glm::dot(this->Planes[f].Normal, direction);
      const double distance = this->Planes[f].Offset - glm::dot(this->Planes[f].Normal, origin);
      if (slope > 0.0)
      {
        exit = std::min(exit, distance / slope);
      }
      else if (slope < 0.0)
      {
        entry = std::max(entry, distance / slope);
      }
      else if (distance <= 0.0)
      {
        exit = entry;
      }
    }
    if (exit - entry > MinimumLength)
    {
      segments.push_back({ entry, exit, static_cast<std::uint32_t>(t) });
    }
  }
  std::sort(segments.begin(), segments.end(),
    [](const Segment& a, const Segment& b) { return a.Entry < b.Entry; });
  for (std::size_t i = 1; i < segments.size(); ++i)
  {
    ++errors.Pairs;
    errors.Overlaps += segments[i - 1].Exit > segments[i].Entry + Tolerance ? 1 : 0;
    errors.Misordered +=
      ranks[segments[i - 1].Tetrahedron] > ranks[segments[i].Tetrahedron] ? 1 : 0;
  }
}

OrderErrors ViewRayCheck::CheckPixels(const interlume::ViewRays& rays,
  const std::vector<std::uint32_t>& frontToBack, int number, unsigned int seed) const
{
  const std::vector<std::uint32_t> ranks = GetRanks(frontToBack);
  std::mt19937 random(seed);
  OrderErrors errors;
  for (int n = 0; n < number; ++n)
  {
    const int i = n == 0 ? rays.Width / 2 : static_cast<int>(random() % rays.Width);
    const int j = n == 0 ? rays.Height / 2 : static_cast<int>(random() % rays.Height);
    this->CheckLine(rays, rays.Center[0] + (2.0 * (i + 0.5) / rays.Width - 1.0) * rays.HalfSize[0],
      rays.Center[1] + (2.0 * (j + 0.5) / rays.Height - 1.0) * rays.HalfSize[1], ranks, errors);
  }
  return errors;
}

OrderErrors ViewRayCheck::CheckRandom(const interlume::ViewRays& rays,
  const std::vector<std::uint32_t>& frontToBack, int number, unsigned int seed) const
{
  const std::vector<std::uint32_t> ranks = GetRanks(frontToBack);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  OrderErrors errors;
  for (int n = 0; n < number; ++n)
  {
    const double x = rays.Center[0] + uniform(random) * rays.HalfSize[0];
    const double y = rays.Center[1] + uniform(random) * rays.HalfSize[1];
    this->CheckLine(rays, x, y, ranks, errors);
  }
  return errors;
}

bool CheckOrder(const ViewRayCheck& viewRays, const interlume::VisibilityOrder& visibility,
  const interlume::ViewRays& rays, const std::vector<std::uint32_t>& order, int lines,
  bool mayBeCyclic, OrderTally& tally, Check& check)
{
  check.That(IsPermutation(order, viewRays.GetNumberOfTetrahedra()),
    "the order contains each tetrahedron once");
  ++tally.Orders;
  if (visibility.GetNumberOfTetrahedraInCycles() > 0)
  {
    check.That(mayBeCyclic, "the order has no cycles");
    ++tally.Cyclic;
    return false;
  }
  const OrderErrors errors = viewRays.CheckPixels(rays, order, lines, 1);
  check.Equal(errors.Misordered, 0, "pairs in the wrong order along rays through pixels");
  check.Equal(errors.Overlaps, 0, "overlapping tetrahedra");
  tally.Pairs += errors.Pairs;
  return true;
}

bool IsPermutation(const std::vector<std::uint32_t>& order, std::uint32_t number)
{
  std::vector<bool> seen(number, false);
  for (const std::uint32_t t : order)
  {
    if (t >= number || seen[t])
    {
      return false;
    }
    seen[t] = true;
  }
  return order.size() == number;
}

}
