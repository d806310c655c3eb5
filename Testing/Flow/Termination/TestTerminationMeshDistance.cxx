// SPDX-License-Identifier: BSD-3-Clause
// The signed distance of meshes compared with the distance to all triangles and the winding number:
// sharp edges, tips, concave solids, closed grids, seams, open boundaries and discontinuities, at
// all scales.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceTermination.h"
#include "Support/Flow/ReferenceTerminationMesh.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTerminationMesh.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;

const double Pi = std::acos(-1.0);

Vector OnSphere(double u, double v)
{
  const double across = 0.7 * std::sin(Pi * v);
  return { { across * std::cos(2.0 * Pi * u), across * std::sin(2.0 * Pi * u),
    -0.7 * std::cos(Pi * v) } };
}

Vector OnTorus(double u, double v)
{
  const double across = 0.6 + 0.25 * std::cos(2.0 * Pi * v);
  return { { across * std::cos(2.0 * Pi * u), across * std::sin(2.0 * Pi * u),
    0.25 * std::sin(2.0 * Pi * v) } };
}

void CheckClosed(const TexturedMesh& unit, const SurfaceScale& scale, bool isPeriodic,
  const std::string& name, Check& check)
{
  check.SetContext(name + ", size " + std::to_string(scale.Size));
  const TexturedMesh mesh = unit.GetTransformed(scale);
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(mesh.MakeData());
  surface->SetPeriodicU(isPeriodic);
  const std::string error = surface->Update();
  check.That(error.empty(), "no error: " + error);
  check.Equal(surface->GetNumberOfBorderEdges(), 0, "number of boundary edges");
  check.Equal(surface->GetNumberOfBranchingEdges(), 0, "branching edges");
  check.Equal(
    surface->GetNumberOfTriangles(), static_cast<long long>(mesh.Triangles.size()), "triangles");
  std::vector<Vector> positions = MakeSignTestPoints(mesh);
  const std::vector<Vector> more = MakeRandomPointsNear(scale, 1000, 2);
  positions.insert(positions.end(), more.begin(), more.end());
  // Limits the number of points, because the winding number visits all triangles.
  const std::size_t stride = 1 + positions.size() * mesh.Triangles.size() / 1500000;
  int inside = 0;
  for (std::size_t i = 0; i < positions.size(); i += stride)
  {
    const Vector& x = positions[i];
    const double distance = GetSurfaceDistance(surface, x);
    const double expected = NearestDistance(mesh, x);
    check.Near(std::abs(distance), expected, 30.0 * scale.Rounding, "distance", scale.Size);
    const double winding = WindingNumber(mesh, x);
    // On the surface, both signs are valid.
    if (expected > 100.0 * scale.Rounding * scale.Size)
    {
      check.That((distance < 0.0) == (winding > 0.5),
        "the sign at distance " + std::to_string(distance / scale.Size) + ", winding number " +
          std::to_string(winding));
      inside += distance < 0.0 ? 1 : 0;
    }
  }
  check.That(inside >= 10, "some points are inside: " + std::to_string(inside));
  CheckLipschitz(surface, scale, name, check);
  double bounds[6];
  surface->GetBounds(bounds);
  for (const Vector& point : mesh.Points)
  {
    check.That(surface->IsOn(point.data()), "a corner is on the surface");
    for (int axis = 0; axis < 3; ++axis)
    {
      check.That(point[axis] >= bounds[2 * axis] && point[axis] <= bounds[2 * axis + 1], "bounds");
    }
  }
}

// Face normals equal the gradient of the distance. Vertex normals of a sphere are nearly radial.
void CheckNormalsOfMesh(Check& check)
{
  check.SetContext("normals");
  const TexturedMesh mesh = MakeGridMesh(40, 24, OnSphere);
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(mesh.MakeData());
  surface->Update();
  for (std::size_t i = 0; i < mesh.Triangles.size(); i += 5)
  {
    const auto& t = mesh.Triangles[i];
    Vector center = mesh.Points[t[0]] + mesh.Points[t[1]] + mesh.Points[t[2]];
    center *= 1.0 / 3.0;
    Vector normal;
    surface->EvaluateNormal(center.data(), normal.data());
    for (int axis = 0; axis < 3; ++axis)
    {
      Vector step = { { 0.0, 0.0, 0.0 } };
      step[axis] = 1e-6;
      const double slope =
        (GetSurfaceDistance(surface, center + step) - GetSurfaceDistance(surface, center - step)) /
        2e-6;
      check.Near(slope, normal[axis], 1e-6, "gradient", 1.0);
    }
    const Vector& corner = mesh.Points[t[0]];
    surface->EvaluateNormal(corner.data(), normal.data());
    check.Near(Dot(normal, corner) / 0.7, 1.0, 0.01, "vertex normal of a sphere");
  }
}

// As the mesh is refined, its distance converges to the sphere's distance with second order.
void CheckConvergence(Check& check)
{
  check.SetContext("convergence");
  double before = 0.0;
  for (int n : { 12, 24, 48 })
  {
    vtkNew<vtkTerminationMesh> surface;
    surface->SetMesh(MakeGridMesh(2 * n, n, OnSphere).MakeData());
    surface->Update();
    double error = 0.0;
    for (const Vector& x : MakeRandomPointsNear(SurfaceScale(), 1000, 4))
    {
      reference::KeepLargest(error, std::abs(GetSurfaceDistance(surface, x) - (GetNorm(x) - 0.7)));
    }
    check.That(before == 0.0 || (error < before / 3.5 && error > before / 4.5),
      "the error decreases from " + std::to_string(before) + " to " + std::to_string(error));
    before = error;
  }
}

void CheckOpen(const SurfaceScale& scale, Check& check)
{
  check.SetContext("open, size " + std::to_string(scale.Size));
  const TexturedMesh mesh = MakeGridMesh(6, 5,
    [](double u, double v) {
      return Vector{ { u - 0.5, v - 0.5, 0.0 } };
    }).GetTransformed(scale);
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(mesh.MakeData());
  check.That(surface->Update().empty(), "no error");
  check.Equal(surface->GetNumberOfBorderEdges(), 22, "number of boundary edges");
  for (const Vector& x : MakeRandomPointsNear(scale, 1000, 6))
  {
    const Vector p = x - scale.Center;
    const double beyond =
      std::max({ std::abs(p[0]) - 0.5 * scale.Size, std::abs(p[1]) - 0.5 * scale.Size, 0.0 });
    check.Near(std::abs(GetSurfaceDistance(surface, x)), NearestDistance(mesh, x),
      30.0 * scale.Rounding, "distance", scale.Size);
    check.That((GetSurfaceDistance(surface, x) > 0.0) == (p[2] > 0.0) || beyond > 0.0, "side");
    Vector foot = x;
    foot[2] = scale.Center[2];
    check.That(surface->IsOn(foot.data()) == (beyond == 0.0), "IsOn");
  }
  // Points close to the boundary edges.
  for (double step : { -1e-6, 0.0, 1e-6 })
  {
    for (int side = 0; side < 4; ++side)
    {
      Vector x = scale.Center;
      x[side / 2] += (side % 2 ? 1.0 : -1.0) * (0.5 + step) * scale.Size;
      x[1 - side / 2] += 0.123 * scale.Size;
      check.That(surface->IsOn(x.data()) == (step <= 0.0), "IsOn close to a boundary edge");
    }
  }
}

// Normal and sign at a tip do not depend on the triangulation of the faces.
void CheckFan(Check& check)
{
  check.SetContext("fan");
  const TexturedMesh whole =
    MakeSolid({ { { 0, 0, 1 } }, { { -0.3, -0.3, 0 } }, { { 0.3, -0.3, 0 } }, { { 0, 0.3, 0 } } },
      { { { 0, 1, 2 } }, { { 0, 2, 3 } }, { { 0, 3, 1 } }, { { 1, 3, 2 } } });
  // The first face is split into triangles that meet at the tip, and the bottom into triangles that
  // meet at point 3.
  const int pieces = 30;
  std::vector<Vector> points = whole.Points;
  std::vector<std::array<int, 3>> triangles = { { { 0, 2, 3 } }, { { 0, 3, 1 } } };
  for (int i = 0; i < pieces; ++i)
  {
    const double part = static_cast<double>(i + 1) / pieces;
    const int before = i == 0 ? 1 : 3 + i;
    const int after = i + 1 == pieces ? 2 : 4 + i;
    if (i + 1 < pieces)
    {
      points.push_back(whole.Points[1] + part * (whole.Points[2] - whole.Points[1]));
    }
    triangles.push_back({ { 0, before, after } });
    triangles.push_back({ { 3, after, before } });
  }
  const TexturedMesh cut = MakeSolid(points, triangles);
  vtkNew<vtkTerminationMesh> surfaces[2];
  surfaces[0]->SetMesh(whole.MakeData());
  surfaces[1]->SetMesh(cut.MakeData());
  for (auto& surface : surfaces)
  {
    check.That(surface->Update().empty(), "no error");
    check.Equal(surface->GetNumberOfBorderEdges(), 0, "number of boundary edges");
  }
  for (const Vector& point : whole.Points)
  {
    Vector normals[2];
    surfaces[0]->EvaluateNormal(point.data(), normals[0].data());
    surfaces[1]->EvaluateNormal(point.data(), normals[1].data());
    check.Near(GetNorm(normals[0] - normals[1]), 0.0, 1e-6, "normal at a vertex", 1.0);
  }
  for (const Vector& x : MakeSignTestPoints(whole))
  {
    check.Near(GetSurfaceDistance(surfaces[1], x), GetSurfaceDistance(surfaces[0], x), 1e-12,
      "the distance", 1.0);
  }
}

// Two parallel sheets with the same orientation. The sign changes midway between them, although no
// surface is there.
void CheckSheets(Check& check)
{
  check.SetContext("sheets");
  TexturedMesh mesh;
  mesh.Points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } },
    { { 1, 0, 1 } }, { { 0, 1, 1 } } };
  mesh.Texture.assign(6, { { 0.5, 0.5 } });
  mesh.Triangles = { { { 0, 1, 2 } }, { { 3, 4, 5 } } };
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(mesh.MakeData());
  check.That(surface->Update().empty(), "no error");
  const Vector below = { { 0.2, 0.2, 0.499 } };
  const Vector above = { { 0.2, 0.2, 0.501 } };
  const Vector between = { { 0.2, 0.2, 0.5 } };
  check.That(GetSurfaceDistance(surface, below) > 0.0 && GetSurfaceDistance(surface, above) < 0.0,
    "the sign changes");
  check.That(!surface->IsOn(between.data()), "the discontinuity is not on the surface");
  const Vector on = { { 0.2, 0.2, 1.0 + 1e-10 } };
  check.That(surface->IsOn(on.data()), "a sheet is on the surface");
}

}

int TestTerminationMeshDistance(int, char*[])
{
  Check check;
  for (const SurfaceScale& scale : MakeSurfaceScales())
  {
    CheckClosed(MakeTetrahedron(), scale, false, "tetrahedron", check);
    CheckClosed(MakeStar(), scale, false, "star", check);
    CheckClosed(MakeGridMesh(24, 12, OnSphere), scale, true, "sphere", check);
    CheckClosed(MakeGridMesh(24, 12, OnTorus), scale, true, "torus", check);
    CheckOpen(scale, check);
  }
  CheckNormalsOfMesh(check);
  CheckConvergence(check);
  CheckFan(check);
  CheckSheets(check);
  return check.Result();
}
