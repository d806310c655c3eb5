// SPDX-License-Identifier: BSD-3-Clause
// Meshes with inconsistent orientation, duplicate points, degenerate triangles or one-sided
// surfaces, and invalid meshes.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceTermination.h"
#include "Support/Flow/ReferenceTerminationMesh.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTerminationMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace reference;

const double Pi = std::acos(-1.0);
const double NotANumber = std::numeric_limits<double>::quiet_NaN();

Vector OnSphere(double u, double v)
{
  const double across = 0.7 * std::sin(Pi * v);
  return { { across * std::cos(2.0 * Pi * u), across * std::sin(2.0 * Pi * u),
    -0.7 * std::cos(Pi * v) } };
}

// Checks that distances from a changed mesh equal the distances from the original mesh.
void CheckSame(const TexturedMesh& changed, const TexturedMesh& mesh, const std::string& name,
  Check& check, int degenerate = 0)
{
  check.SetContext(name);
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(changed.MakeData());
  const std::string error = surface->Update();
  check.That(error.empty(), "no error: " + error);
  check.Equal(surface->GetNumberOfDegenerateTriangles(), degenerate, "degenerate triangles");
  check.Equal(surface->GetNumberOfBorderEdges(), 0, "number of boundary edges");
  std::vector<Vector> positions = MakeSignTestPoints(mesh);
  const std::vector<Vector> more = MakeRandomPointsNear(SurfaceScale(), 300, 8);
  positions.insert(positions.end(), more.begin(), more.end());
  for (const Vector& x : positions)
  {
    const double sign = WindingNumber(mesh, x) > 0.5 ? -1.0 : 1.0;
    check.Near(
      GetSurfaceDistance(surface, x), sign * NearestDistance(mesh, x), 1e-8, "distance", 1.0);
  }
}

void CheckOrientation(Check& check)
{
  const TexturedMesh star = MakeStar();
  TexturedMesh turned = star;
  for (std::size_t i = 0; i < turned.Triangles.size(); ++i)
  {
    std::swap(turned.Triangles[i][1], turned.Triangles[i][2]);
  }
  CheckSame(turned, star, "all triangles inverted", check);
  for (std::size_t i = 0; i < turned.Triangles.size(); i += 3)
  {
    std::swap(turned.Triangles[i][0], turned.Triangles[i][2]);
  }
  CheckSame(turned, star, "some triangles inverted", check);
  // Two solids, one of them inverted.
  TexturedMesh pair = star.GetTransformed({ 0.3, { { -0.5, 0.0, 0.0 } } });
  const TexturedMesh other = star.GetTransformed({ 0.3, { { 0.5, 0.1, 0.0 } } });
  const int first = static_cast<int>(pair.Points.size());
  pair.Points.insert(pair.Points.end(), other.Points.begin(), other.Points.end());
  pair.Texture.insert(pair.Texture.end(), other.Texture.begin(), other.Texture.end());
  for (const auto& triangle : other.Triangles)
  {
    pair.Triangles.push_back({ { triangle[0] + first, triangle[1] + first, triangle[2] + first } });
  }
  TexturedMesh turnedPair = pair;
  for (std::size_t i = star.Triangles.size(); i < pair.Triangles.size(); ++i)
  {
    std::swap(turnedPair.Triangles[i][0], turnedPair.Triangles[i][1]);
  }
  CheckSame(turnedPair, pair, "two solids", check);
}

// All triangles of an open mesh get the orientation of the majority, and keep their texture
// coordinates.
void CheckOpenOrientation(Check& check)
{
  check.SetContext("open mesh");
  for (bool isDown : { false, true })
  {
    TexturedMesh mesh = MakeGridMesh(4, 4,
      [](double u, double v) {
        return Vector{ { u, v, 0.0 } };
      });
    for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
    {
      if ((i < 10) != isDown)
      {
        std::swap(mesh.Triangles[i][1], mesh.Triangles[i][2]);
      }
    }
    vtkNew<vtkTerminationMesh> surface;
    surface->SetMesh(mesh.MakeData());
    check.That(surface->Update().empty(), "no error");
    for (const auto& position : mesh.Texture)
    {
      const Vector x = { { position[0], position[1], 0.1 } };
      check.Near(GetSurfaceDistance(surface, x), isDown ? -0.1 : 0.1, 1e-12, "side");
      double uv[2];
      surface->EvaluateParameters(x.data(), uv);
      check.Near(uv[0], position[0], 1e-12, "u", 1.0);
      check.Near(uv[1], position[1], 1e-12, "v", 1.0);
    }
    // The boundary edges are unchanged.
    for (double along : { 0.1, 0.3, 0.6, 0.9 })
    {
      for (double across : { -1e-7, 1e-7 })
      {
        const Vector borders[4] = { { { along, across, 0.0 } }, { { along, 1.0 - across, 0.0 } },
          { { across, along, 0.0 } }, { { 1.0 - across, along, 0.0 } } };
        for (const Vector& x : borders)
        {
          check.That(surface->IsOn(x.data()) == (across > 0.0), "boundary edge");
        }
      }
    }
  }
}

void CheckDoubledPoints(Check& check)
{
  const TexturedMesh star = MakeStar();
  TexturedMesh separate;
  for (const auto& triangle : star.Triangles)
  {
    const int first = static_cast<int>(separate.Points.size());
    for (int corner : triangle)
    {
      // The shifts are below the tolerance. They have both signs, so that points to be merged may
      // lie in different cells of the hash grid.
      const double shift = (static_cast<double>(separate.Points.size() % 7) - 3.0) * 1e-10;
      separate.Points.push_back(star.Points[corner] + Vector{ { shift, -shift, 0.5 * shift } });
      separate.Texture.push_back({ { 0.5, 0.01 * static_cast<double>(first) } });
    }
    separate.Triangles.push_back({ { first, first + 1, first + 2 } });
  }
  CheckSame(separate, star, "separate points for each triangle", check);
  // With a smaller tolerance, these points are not merged.
  check.SetContext("tolerance");
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(separate.MakeData());
  surface->SetTolerance(1e-14);
  surface->Update();
  check.That(surface->GetNumberOfBorderEdges() > 30, "a small tolerance leaves boundary edges");
  surface->SetTolerance(-1.0);
  check.Near(surface->GetTolerance(), 1e-15, 0.0, "the tolerance is clamped to its minimum");
  surface->SetTolerance(7.0);
  check.Near(surface->GetTolerance(), 0.1, 0.0, "the tolerance is clamped to its maximum");
  surface->SetTolerance(NotANumber);
  check.Near(surface->GetTolerance(), 0.1, 0.0, "NaN is ignored");
}

void CheckDegenerate(Check& check)
{
  const TexturedMesh star = MakeStar();
  TexturedMesh degenerate = star;
  const int first = static_cast<int>(star.Points.size());
  // Three degenerate triangles: collinear points, a single point, and a repeated point.
  for (double along : { -2.0, 0.0, 1.0 })
  {
    degenerate.Points.push_back({ { 0.01 * along, 0.02 * along, 0.03 * along } });
    degenerate.Texture.push_back({ { 0.0, 0.0 } });
  }
  degenerate.Triangles.push_back({ { first, first + 1, first + 2 } });
  degenerate.Triangles.push_back({ { 3, 3, 3 } });
  degenerate.Triangles.insert(degenerate.Triangles.begin(), { { 2, 8, 2 } });
  CheckSame(degenerate, star, "degenerate triangles", check, 3);
}

// Three triangles at an edge are reported, and the distance is still correct.
void CheckBranching(Check& check)
{
  check.SetContext("branching");
  const TexturedMesh mesh = MakeSolid({ { { 0, 0, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 0.5 } },
                                        { { -1, 1, 0.5 } }, { { -1, -1, 0.5 } } },
    { { { 0, 1, 2 } }, { { 0, 1, 3 } }, { { 1, 0, 4 } } });
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(mesh.MakeData());
  check.That(surface->Update().empty(), "no error");
  check.Equal(surface->GetNumberOfBranchingEdges(), 1, "branching edges");
  check.Equal(surface->GetNumberOfBorderEdges(), 6, "number of boundary edges");
  for (const Vector& x : MakeRandomPointsNear(SurfaceScale(), 300, 8))
  {
    check.Near(
      std::abs(GetSurfaceDistance(surface, x)), NearestDistance(mesh, x), 1e-12, "distance", 1.0);
  }
}

void CheckMessage(vtkPolyData* data, const std::string& expected, Check& check)
{
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(MakeTetrahedron().MakeData());
  surface->Update();
  surface->SetMesh(data);
  const std::string error = surface->Update();
  check.Contains(error, expected);
  check.That(!surface->Update().empty(), "the error is repeated");
  // The previous mesh is cleared, and evaluation does not crash.
  const Vector x = { { 0.0, 0.0, 0.0 } };
  Vector y;
  double uv[2] = { 0.5, 0.5 };
  double bounds[6];
  surface->GetBounds(bounds);
  check.That(bounds[0] > bounds[1], "no bounds");
  check.That(!surface->IsOn(x.data()) && !surface->EvaluatePoint(0, uv, y.data()), "no surface");
  check.That(GetSurfaceDistance(surface, x) == VTK_DOUBLE_MAX, "no distance");
  surface->EvaluateParameters(x.data(), uv);
  surface->EvaluateNormal(x.data(), y.data());
  surface->SetMesh(MakeTetrahedron().MakeData());
  check.That(surface->Update().empty(), "a valid mesh is accepted again");
  check.That(GetSurfaceDistance(surface, x) < 0.0, "distance to the valid mesh");
}

void CheckMessages(Check& check)
{
  check.SetContext("messages");
  CheckMessage(nullptr, "no mesh is set", check);
  CheckMessage(vtkNew<vtkPolyData>(), "no texture coordinates", check);
  const TexturedMesh mesh = MakeTetrahedron();
  auto data = mesh.MakeData();
  data->GetPointData()->SetActiveTCoords(nullptr);
  CheckMessage(data, "no texture coordinates", check);
  data = mesh.MakeData();
  vtkNew<vtkDoubleArray> three;
  three->SetName("Three");
  three->SetNumberOfComponents(3);
  three->SetNumberOfTuples(4);
  three->Fill(0.0);
  data->GetPointData()->SetTCoords(three);
  CheckMessage(data, "texture coordinates, array \"Three\" has 3 components; 2 are needed", check);
  vtkNew<vtkDoubleArray> few;
  few->SetName("Few");
  few->SetNumberOfComponents(2);
  few->SetNumberOfTuples(3);
  few->Fill(0.0);
  data->GetPointData()->SetTCoords(few);
  CheckMessage(data, "array \"Few\" has 3 tuples; 4 are needed, one for each point", check);
  for (double bad : { NotANumber, std::numeric_limits<double>::infinity() })
  {
    data = mesh.MakeData();
    data->GetPoints()->SetPoint(2, 0.0, bad, 0.0);
    CheckMessage(data, "point 2 of the mesh is not finite", check);
    data = mesh.MakeData();
    data->GetPointData()->GetTCoords()->SetComponent(1, 1, bad);
    CheckMessage(data, "texture coordinates of point 1 of the mesh are not finite", check);
  }
  data = mesh.MakeData();
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2 });
  cells->InsertNextCell({ 0, 1, 4 });
  data->SetPolys(cells);
  CheckMessage(data, "cell 1 of the mesh refers to point 4, which does not exist", check);
  data = mesh.MakeData();
  data->SetPolys(vtkNew<vtkCellArray>());
  CheckMessage(data, "no triangle with an area", check);
  TexturedMesh flat = mesh;
  flat.Points.assign(4, { { 1.0, 2.0, 3.0 } });
  CheckMessage(flat.MakeData(), "all its points coincide", check);
  flat.Points = { { { 0, 0, 0 } }, { { 1, 1, 1 } }, { { 2, 2, 2 } }, { { 3, 3, 3 } } };
  CheckMessage(flat.MakeData(), "no triangle with an area", check);
  // A Moebius strip.
  TexturedMesh strip = MakeGridMesh(20, 1,
    [](double u, double v)
    {
      const double radius = 1.0 + (v - 0.5) * 0.4 * std::cos(Pi * u);
      return Vector{ { radius * std::cos(2.0 * Pi * u), radius * std::sin(2.0 * Pi * u),
        (v - 0.5) * 0.4 * std::sin(Pi * u) } };
    });
  CheckMessage(strip.MakeData(), "the mesh is one-sided", check);
  // Unused points may have any coordinates.
  data = mesh.MakeData();
  data->GetPoints()->InsertNextPoint(NotANumber, 0.0, 0.0);
  data->GetPointData()->GetTCoords()->InsertNextTuple2(NotANumber, 0.0);
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(data);
  check.That(surface->Update().empty(), "unused points are ignored");
}

// Update detects changes to the mesh and does not modify the mesh.
void CheckChanges(Check& check)
{
  check.SetContext("changes");
  const TexturedMesh mesh = MakeGridMesh(24, 12, OnSphere);
  auto data = mesh.MakeData();
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(data);
  surface->Update();
  const vtkMTimeType time = data->GetMTime();
  const Vector x = { { 0.0, 0.0, 2.0 } };
  const double before = GetSurfaceDistance(surface, x);
  check.That(surface->Update().empty(), "again");
  check.That(data->GetMTime() == time, "the mesh is not modified");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    data->GetPoints()->SetPoint(i, p[0], p[1], p[2] + 1.0);
  }
  data->GetPoints()->Modified();
  data->Modified();
  surface->Update();
  check.Near(GetSurfaceDistance(surface, x), before - 1.0, 1e-12, "distance to the moved mesh");
}

}

int TestTerminationMeshInput(int, char*[])
{
  return RunChecks({ CheckOrientation, CheckOpenOrientation, CheckDoubledPoints, CheckDegenerate,
    CheckBranching, CheckMessages, CheckChanges });
}
