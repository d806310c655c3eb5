// SPDX-License-Identifier: BSD-3-Clause
// The visibility order where signs are 0: eyes on points, edges and planes of faces; and of meshes
// that are not manifold.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Tetrahedra/ReferenceSightlines.h"
#include "Support/Tetrahedra/ReferenceTetrahedra.h"

#include "Order/VisibilityOrder.h"

#include <algorithm>

namespace
{

using namespace reference;
using Point = std::array<double, 3>;

const std::array<Point, 4> Corner = { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
  { { 0, 0, 1 } } } };

// An order of a mesh without cycles, right along all lines of sight that are tried.
void CheckOrder(
  const interlume::TetrahedraMesh& mesh, const interlume::ViewRays& rays, Check& check)
{
  interlume::VisibilityOrder visibility;
  visibility.Build(mesh);
  std::vector<std::uint32_t> order;
  visibility.Compute(mesh, rays, order);
  check.That(IsPermutation(order, mesh.GetNumberOfTetrahedra()), "each tetrahedron once");
  check.Equal(visibility.GetNumberOfTetrahedraInCycles(), 0, "tetrahedra in cycles");
  const OrderErrors errors = Sightlines(mesh).CheckPixels(rays, order, 200, 1);
  check.Equal(errors.Wrong, 0, "wrong along lines through pixels");
}

// An even and an odd picture: lines of sight beside the planes, and within them.
void CheckEyes(Check& check)
{
  CubeMesh form;
  form.Cubes = 6;
  const double step = 1.0 / 6.0;
  const Point eyes[] = { { { 0.0, 0.0, 0.0 } }, { { 0.0, 0.0, step / 2 } },
    { { step / 3, step / 3, 0.0 } }, { { 0.5, 0.5, 0.5 } }, { { 0.5, 0.0, 0.0 } },
    { { 1.0, 0.0, 0.0 } }, { { 2.0, 2.0, 2.0 } }, { { 1.0, step, -step } } };
  for (const int pieces : { 5, 6 })
  {
    form.Pieces = pieces;
    const interlume::TetrahedraMesh whole = MakeCubes(form);
    const interlume::TetrahedraMesh separate = Separate(whole);
    for (const Point& eye : eyes)
    {
      for (const int pixels : { 64, 65 })
      {
        const interlume::ViewRays rays =
          LookAt(glm::make_vec3(eye.data()), { -0.5, -0.5, -0.5 }, 1.0, pixels, false);
        check.SetContext("eye at " + std::to_string(eye[0]) + ", " + std::to_string(eye[1]) + ", " +
          std::to_string(eye[2]) + ", " + std::to_string(pieces) + " of a cube");
        CheckOrder(whole, rays, check);
        // Within the planes a line of sight has no order of its own between pieces.
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
      CheckOrder(whole, rays, check);
      CheckOrder(separate, rays, check);
    }
  }
}

// A turned lattice: coplanar faces whose planes, with rounding, no longer hold the eye exactly.
void CheckTurned(Check& check)
{
  CubeMesh form;
  form.Cubes = 8;
  interlume::TetrahedraMesh mesh = MakeCubes(form);
  // Rows of a rotation, far from any multiple of 2^-k.
  const double turn[3][3] = { { 0.36, 0.48, -0.8 }, { -0.8, 0.6, 0.0 }, { 0.48, 0.64, 0.6 } };
  const auto rotate = [&](const glm::dvec3& p)
  {
    glm::dvec3 q;
    for (int i = 0; i < 3; ++i)
    {
      q[i] = turn[i][0] * p[0] + turn[i][1] * p[1] + turn[i][2] * p[2] + 0.123;
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
    check.SetContext("turned lattice, eye at " + std::to_string(eye[2]));
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
  check.That(visibility.Build(mesh), "built");
  visibility.Compute(mesh, rays, order);
  check.That(order.empty(), "nothing");
  check.SetContext("one");
  Append(mesh, Corner);
  visibility.Build(mesh);
  visibility.Compute(mesh, rays, order);
  check.That(order == std::vector<std::uint32_t>{ 0 }, "one tetrahedron");

  // Three axes in a plane give no picture, and no pixels give none.
  interlume::ViewRays flat = rays;
  flat.Up = flat.Right;
  visibility.Compute(mesh, flat, order);
  check.That(order == std::vector<std::uint32_t>{ 0 }, "a picture without area");
  check.That(visibility.GetBytes() > 0, "bytes are counted");
}

// Overlapping, folded and flat tetrahedra have no order, and are all put out.
void CheckBroken(Check& check)
{
  CubeMesh form;
  form.Cubes = 4;
  const interlume::TetrahedraMesh cubes = MakeCubes(form);
  std::vector<std::pair<std::string, interlume::TetrahedraMesh>> meshes;

  interlume::TetrahedraMesh mesh = cubes;
  mesh.Corners.insert(mesh.Corners.end(), cubes.Corners.begin(), cubes.Corners.begin() + 120);
  meshes.emplace_back("tetrahedra that are there twice", mesh);

  mesh = cubes;
  for (std::uint32_t i = 0; i < 100; i += 4)
  {
    const std::uint32_t* corners = cubes.GetCorners(i);
    mesh.Corners.insert(mesh.Corners.end(), { corners[0], corners[1], corners[2], (i + 60) % 125 });
  }
  meshes.emplace_back("faces of three tetrahedra", mesh);

  mesh = cubes;
  // The middle point of the lattice far away: folded.
  mesh.Points[3 * 62] += 0.7;
  meshes.emplace_back("folded", mesh);

  mesh = cubes;
  // A point onto its neighbour: flat.
  std::copy_n(&mesh.Points[3 * 63], 3, &mesh.Points[3 * 62]);
  meshes.emplace_back("flat", mesh);

  for (const auto& broken : meshes)
  {
    interlume::VisibilityOrder visibility;
    visibility.Build(broken.second);
    for (const View& view : GetViews(60, { 0.3, 0.2, 0.1 }))
    {
      check.SetContext(broken.first + ", " + view.Name);
      std::vector<std::uint32_t> order;
      visibility.Compute(broken.second, view.Rays, order);
      check.That(
        IsPermutation(order, broken.second.GetNumberOfTetrahedra()), "each tetrahedron once");
    }
  }
}

// A copy of a tetrahedron behind a mesh's own leaves the order of the others right.
void CheckTwins(Check& check)
{
  check.SetContext("two alike among others");
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
  const std::uint32_t middle = append(0.0);
  for (int k = 0; k < 4; ++k)
  {
    mesh.Corners.push_back(mesh.GetCorners(middle)[k]);
  }
  const std::uint32_t back = append(-2.0);
  const std::uint32_t front = append(2.0);
  interlume::VisibilityOrder visibility;
  visibility.Build(mesh);
  std::vector<std::uint32_t> order;
  visibility.Compute(mesh, LookAt({ 0.2, 0.2, 9.0 }, { 0.2, 0.2, 0.0 }, 0.3, 50, false), order);
  check.That(order == std::vector<std::uint32_t>({ front, middle, middle + 1, back }), "order");
  check.Equal(visibility.GetNumberOfTetrahedraInCycles(), 0, "tetrahedra in cycles");
  check.Equal(visibility.GetNumberOfGapRelations(), 3, "relations across gaps");
}
}

int TestTetrahedraSortDegenerate(int, char*[])
{
  return RunChecks({ CheckSmall, CheckEyes, CheckTurned, CheckBroken, CheckTwins });
}
