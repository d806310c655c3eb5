// SPDX-License-Identifier: BSD-3-Clause
// Tests the visibility order for zero determinants: eye positions on points, edges and planes of
// faces. Also tests meshes that are not manifold.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceViewRays.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/VisibilityOrder.h"

#include <algorithm>

namespace
{

using namespace reference;
using Point = std::array<double, 3>;

const std::array<Point, 4> Corner = { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
  { { 0, 0, 1 } } } };

// Checks that the order has no cycles and is correct along rays through pixels.
void CheckOrder(
  const interlume::TetrahedraMesh& mesh, const interlume::ViewRays& rays, Check& check)
{
  interlume::VisibilityOrder visibility;
  visibility.Build(mesh);
  std::vector<std::uint32_t> order;
  visibility.Compute(mesh, rays, order);
  check.That(IsPermutation(order, mesh.GetNumberOfTetrahedra()), "each tetrahedron occurs once");
  check.Equal(visibility.GetNumberOfTetrahedraInCycles(), 0, "tetrahedra in cycles");
  const OrderErrors errors = ViewRayCheck(mesh).CheckPixels(rays, order, 200, 1);
  check.Equal(errors.Misordered, 0, "errors along rays through pixels");
}

// Tests eye positions in the planes of faces. In images of even size, rays are close to these
// planes. In images of odd size, some rays lie in them.
void CheckAlignedEyePositions(Check& check)
{
  CubeMeshSettings form;
  form.Cubes = 6;
  const double step = 1.0 / 6.0;
  const Point eyes[] = { { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, step / 2 } },
    { { step / 3, step / 3, 0.0 } }, { { 0.5, 0.5, 0.5 } }, { { 0.5, 0.0, 0.0 } },
    { { 1.0, 0.0, 0.0 } }, { { 2.0, 2.0, 2.0 } }, { { 1.0, step, -step } } };
  for (const int pieces : { 5, 6 })
  {
    form.Pieces = pieces;
    const interlume::TetrahedraMesh connected = MakeCubeMesh(form);
    const interlume::TetrahedraMesh separate = SeparateTetrahedra(connected);
    for (const Point& eye : eyes)
    {
      for (const int pixels : { 64, 65 })
      {
        const interlume::ViewRays rays =
          LookAt(glm::make_vec3(eye.data()), { -0.5, -0.5, -0.5 }, 1.0, pixels, false);
        check.SetContext("eye at " + std::to_string(eye[0]) + ", " + std::to_string(eye[1]) + ", " +
          std::to_string(eye[2]) + ", " + std::to_string(pieces) + " per cube");
        CheckOrder(connected, rays, check);
        // Along rays in the planes of faces, disconnected tetrahedra have no unique order.
        if (pixels == 64)
        {
          check.SetContext("no shared points");
          CheckOrder(separate, rays, check);
        }
      }
    }
    for (const Point& direction :
      { Point{ { 1, 0, 0 } }, Point{ { 1, 1, 0 } }, Point{ { 1, 1, 1 } }, Point{ { -1, 2, 0 } } })
    {
      const interlume::ViewRays rays =
        LookAt({ 0, 0, 0 }, glm::make_vec3(direction.data()), 0.9, 64, true);
      check.SetContext("parallel along " + std::to_string(direction[0]) + ", " +
        std::to_string(direction[1]) + ", " + std::to_string(direction[2]));
      CheckOrder(connected, rays, check);
      CheckOrder(separate, rays, check);
    }
  }
}

// Tests a rotated grid: because of rounding, planes of coplanar faces no longer contain the eye
// position exactly.
void CheckRotated(Check& check)
{
  CubeMeshSettings form;
  form.Cubes = 8;
  interlume::TetrahedraMesh mesh = MakeCubeMesh(form);
  // Rows of a rotation matrix whose elements are not binary fractions.
  const double rotation[3][3] = { { 0.36, 0.48, -0.8 }, { -0.8, 0.6, 0.0 }, { 0.48, 0.64, 0.6 } };
  const auto rotate = [&](const glm::dvec3& p)
  {
    glm::dvec3 q;
    for (int i = 0; i < 3; ++i)
    {
      q[i] = rotation[i][0] * p[0] + rotation[i][1] * p[1] + rotation[i][2] * p[2] + 0.123;
    }
    return q;
  };
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    const glm::dvec3 q = rotate(glm::make_vec3(&mesh.Points[i]));
    std::copy_n(glm::value_ptr(q), 3, &mesh.Points[i]);
  }
  for (const glm::dvec3& eye :
    { glm::dvec3(0.0), glm::dvec3(0.25, 0.125, 3.0), glm::dvec3(0.0, 0.0, 40.0), glm::dvec3(0.5) })
  {
    check.SetContext("rotated grid, eye at " + std::to_string(eye[2]));
    const double halfSize = std::min(1.0, 0.7 / std::max(0.1, eye[2]));
    CheckOrder(mesh, LookAt(rotate(eye), rotate({ 0.1, 0.2, -0.3 }), halfSize, 64, false), check);
  }
}

void CheckSmall(Check& check)
{
  interlume::VisibilityOrder visibility;
  std::vector<std::uint32_t> order(3);
  const interlume::ViewRays rays = LookAt({ 0.2, 0.2, 5.0 }, { 0.2, 0.2, 0.0 }, 0.3, 50, false);
  interlume::TetrahedraMesh mesh;
  check.SetContext("empty");
  check.That(visibility.Build(mesh), "the order can be built");
  visibility.Compute(mesh, rays, order);
  check.That(order.empty(), "the order is empty");
  check.SetContext("one");
  Append(mesh, Corner);
  visibility.Build(mesh);
  visibility.Compute(mesh, rays, order);
  check.That(order == std::vector<std::uint32_t>{ 0 }, "one tetrahedron");

  // Parallel image axes define an image without area.
  interlume::ViewRays flat = rays;
  flat.Up = flat.Right;
  visibility.Compute(mesh, flat, order);
  check.That(order == std::vector<std::uint32_t>{ 0 }, "an image without area");
  check.That(visibility.GetBytes() > 0, "memory is reported");
}

// Checks that overlapping, folded and flat tetrahedra, which have no order, are all output.
void CheckInvalid(Check& check)
{
  CubeMeshSettings form;
  form.Cubes = 4;
  const interlume::TetrahedraMesh cubes = MakeCubeMesh(form);
  std::vector<std::pair<std::string, interlume::TetrahedraMesh>> meshes;

  interlume::TetrahedraMesh mesh = cubes;
  mesh.Corners.insert(mesh.Corners.end(), cubes.Corners.begin(), cubes.Corners.begin() + 120);
  meshes.emplace_back("duplicate tetrahedra", mesh);

  mesh = cubes;
  for (std::uint32_t i = 0; i < 100; i += 4)
  {
    const std::uint32_t* corners = cubes.GetCorners(i);
    mesh.Corners.insert(mesh.Corners.end(), { corners[0], corners[1], corners[2], (i + 60) % 125 });
  }
  meshes.emplace_back("faces with three tetrahedra", mesh);

  mesh = cubes;
  // Folded: the central point is moved far away.
  mesh.Points[3 * 62] += 0.7;
  meshes.emplace_back("folded", mesh);

  mesh = cubes;
  // Flat: a point is moved to the position of its neighbor.
  std::copy_n(&mesh.Points[3 * 63], 3, &mesh.Points[3 * 62]);
  meshes.emplace_back("flat", mesh);

  for (const auto& invalid : meshes)
  {
    interlume::VisibilityOrder visibility;
    visibility.Build(invalid.second);
    for (const View& view : GetViews(60, { 0.3, 0.2, 0.1 }))
    {
      check.SetContext(invalid.first + ", " + view.Name);
      std::vector<std::uint32_t> order;
      visibility.Compute(invalid.second, view.Rays, order);
      check.That(IsPermutation(order, invalid.second.GetNumberOfTetrahedra()),
        "each tetrahedron occurs once");
    }
  }
}

// Checks that a duplicate tetrahedron does not affect the order of the other tetrahedra.
void CheckTwins(Check& check)
{
  check.SetContext("two identical tetrahedra among others");
  interlume::TetrahedraMesh mesh;
  const auto append = [&](double z)
  {
    std::array<Point, 4> corners = Corner;
    for (Point& corner : corners)
    {
      corner[2] += z;
    }
    return Append(mesh, corners);
  };
  const std::uint32_t center = append(0.0);
  for (int k = 0; k < 4; ++k)
  {
    mesh.Corners.push_back(mesh.GetCorners(center)[k]);
  }
  const std::uint32_t back = append(-2.0);
  const std::uint32_t front = append(2.0);
  interlume::VisibilityOrder visibility;
  visibility.Build(mesh);
  std::vector<std::uint32_t> order;
  visibility.Compute(mesh, LookAt({ 0.2, 0.2, 9.0 }, { 0.2, 0.2, 0.0 }, 0.3, 50, false), order);
  check.That(order == std::vector<std::uint32_t>({ front, center, center + 1, back }), "order");
  check.Equal(visibility.GetNumberOfTetrahedraInCycles(), 0, "tetrahedra in cycles");
  check.Equal(visibility.GetNumberOfGapRelations(), 3, "relations across gaps");
}
}

int TestTetrahedraSortDegenerate(int, char*[])
{
  return RunChecks(
    { CheckSmall, CheckAlignedEyePositions, CheckRotated, CheckInvalid, CheckTwins });
}
