// SPDX-License-Identifier: BSD-3-Clause
// Tests at which pixels the view ray hits a triangle, and the order relations from the points where
// a ray enters and exits a mesh.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceViewRays.h"

#include "Order/FaceRaster.h"
#include "View/FrameProjection.h"
#include "Order/ViewRayEvents.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace reference;
using Event = interlume::ViewRayEvents::Event;
using Relation = interlume::ViewRayEvents::Relation;

// Checks that triangles whose corners, edges and diagonals are at pixel centers cover each pixel of
// a square exactly once.
void CheckCover(const interlume::ViewRays& rays, const std::string& name, Check& check)
{
  check.SetContext(name);
  constexpr int n = 8;
  constexpr double depth = 3.0;
  const interlume::FrameProjection projection(rays);
  check.That(projection.IsValid(), "the projection is valid");
  std::vector<int> visits(static_cast<std::size_t>(rays.Width) * rays.Height, 0);
  int fronts = 0;
  int backs = 0;
  double largestError = 0.0;
  const auto draw = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    const std::array<std::uint32_t, 3> ids = { { a, b, c } };
    std::array<glm::dvec3, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      // A regular grid over the image, through the centers of pixels 2, 6, 10 and so on.
      const std::uint32_t column = ids[i] % n;
      const std::uint32_t row = ids[i] / n;
      const double x = (5.0 + 8.0 * column) / rays.Width - 1.0;
      const double y = (5.0 + 8.0 * row) / rays.Height - 1.0;
      const double scale = projection.IsParallel() ? 1.0 : depth;
      corners[i] = { x * scale, y * scale, depth };
    }
    const interlume::FaceRaster raster(projection, corners, ids);
    for (int row = raster.GetRows().First; row <= raster.GetRows().Last; ++row)
    {
      raster.VisitRow(row,
        [&](int column, double found, bool isFront)
        {
          ++visits[static_cast<std::size_t>(row) * rays.Width + column];
          ++(isFront ? fronts : backs);
          reference::KeepLargest(largestError, std::abs(found - depth));
        });
    }
  };
  for (std::uint32_t j = 0; j + 1 < n; ++j)
  {
    for (std::uint32_t i = 0; i + 1 < n; ++i)
    {
      const std::uint32_t p = i + n * j;
      if ((i + j) & 1)
      {
        draw(p, p + 1, p + n + 1);
        draw(p + n, p, p + n + 1);
      }
      else
      {
        // One of these triangles is clockwise.
        draw(p + n, p + 1, p);
        draw(p + 1, p + n + 1, p + n);
      }
    }
  }
  const long long covered = 4 * (n - 1) * 4 * (n - 1);
  check.Equal(
    *std::max_element(visits.begin(), visits.end()), 1, "largest number of triangles per pixel");
  check.Equal(fronts + backs, covered, "pixels of a square");
  check.That(backs > covered / 5 && fronts > covered / 2, "both sides occur");
  check.That(largestError < 1e-12, "depths are accurate");
}

void CheckRaster(Check& check)
{
  for (const bool isParallel : { false, true })
  {
    interlume::ViewRays rays = LookAt({ 0, 0, 0 }, { 0, 0, -1 }, 1.0, 64, isParallel);
    const std::string name = isParallel ? "parallel" : "perspective";
    CheckCover(rays, name, check);
    rays.Width = 37;
    rays.Height = 45;
    rays.HalfSize = { { 0.3, 0.7 } };
    CheckCover(rays, name + ", odd", check);
  }

  check.SetContext("through the plane of the eye");
  const interlume::FrameProjection projection(LookAt({ 0, 0, 0 }, { 0, 0, -1 }, 1.0, 40, false));
  int visits = 0;
  double nearest = 1.0;
  // A floor that is half a unit below the eye and extends from far behind the eye to far in front
  // of it covers half of the image.
  const interlume::FaceRaster floor(projection,
    { { { 0.0, -0.5, -1e4 }, { 1e5, -0.5, 1e4 }, { -1e5, -0.5, 1e4 } } }, { { 5, 3, 4 } });
  for (int row = floor.GetRows().First; row <= floor.GetRows().Last; ++row)
  {
    floor.VisitRow(row,
      [&](int, double depth, bool)
      {
        ++visits;
        nearest = std::min(nearest, depth);
      });
  }
  check.Equal(visits, 40 * 20, "pixels of the floor");
  check.Near(nearest, 0.5 / (39.0 / 40.0), 1e-9, "smallest depth of the floor");
}

Event Enter(double depth, std::uint32_t tetrahedron)
{
  return { depth, 4 * tetrahedron, true };
}
Event Leave(double depth, std::uint32_t tetrahedron)
{
  return { depth, 4 * tetrahedron + 1, false };
}

void Expect(std::vector<Event> events, const std::vector<Relation>& expected,
  const std::string& what, Check& check)
{
  std::sort(events.begin(), events.end());
  do
  {
    std::vector<Event> line = events;
    std::vector<Relation> found;
    interlume::ViewRayEvents::Relate(line.data(), line.data() + line.size(), 1e-9, found);
    std::sort(found.begin(), found.end());
    check.That(found == expected, what);
  } while (std::next_permutation(events.begin(), events.end()));
}

void CheckRelations(Check& check)
{
  check.SetContext("relations");
  Expect({}, {}, "no event", check);
  Expect({ Enter(1, 0), Leave(2, 1) }, {}, "one piece", check);
  Expect({ Enter(1, 0), Leave(2, 1), Enter(3, 2), Leave(4, 3) }, { { 2, 1 } }, "a gap", check);
  Expect({ Leave(1, 1), Enter(2, 2), Leave(3, 2) }, { { 2, 1 } }, "eye inside a piece", check);
  Expect(
    { Enter(1, 1), Leave(2, 1), Enter(3, 1), Leave(4, 2) }, {}, "no relation with itself", check);
  // Touching pieces, with rounding errors of either sign.
  for (const double error : { -1e-12, 0.0, 1e-12 })
  {
    Expect({ Enter(1, 0), Leave(2, 1), Enter(2 + error, 2), Leave(3, 3) }, { { 2, 1 } },
      "touching pieces", check);
    Expect({ Leave(2 + error, 1), Enter(2, 2), Leave(3, 2) }, { { 2, 1 } },
      "touching pieces, eye inside", check);
    // A ray along the outline of a piece in front of another one, and a tetrahedron that the ray
    // only touches.
    Expect({ Enter(1, 0), Leave(1 + error, 1), Enter(2, 2), Leave(3, 3) }, {}, "an outline", check);
    Expect(
      { Enter(1, 0), Leave(2, 1), Enter(2.5, 4), Leave(2.5 + error, 4), Enter(3, 2), Leave(4, 3) },
      { { 2, 1 } }, "a touched tetrahedron", check);
    Expect({ Enter(1, 0), Leave(2, 1), Enter(2, 4), Leave(2 + error, 4), Enter(2, 2), Leave(4, 3) },
      { { 2, 1 } }, "a touched tetrahedron between touching pieces", check);
  }
  // So many events that ViewRayEvents uses std::sort instead of insertion sort.
  std::vector<Event> many;
  std::vector<Relation> expected;
  for (std::uint32_t t = 0; t < 100; ++t)
  {
    many.insert(many.begin(), Enter(t, t));
    many.insert(many.begin() + t, Leave(t + 0.5, t));
    if (t > 0)
    {
      expected.push_back({ t, t - 1 });
    }
  }
  std::vector<Relation> found;
  interlume::ViewRayEvents::Relate(many.data(), many.data() + many.size(), 1e-9, found);
  check.That(found == expected, "many gaps");
}
}

int TestTetrahedraSortViewRays(int, char*[])
{
  return RunChecks({ CheckRaster, CheckRelations });
}
