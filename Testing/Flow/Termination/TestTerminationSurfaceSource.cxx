// SPDX-License-Identifier: BSD-3-Clause
// vtkTerminationSurfaceSource: points on the surface with parameters and normals, areas and
// boundaries compared with formulas, outward triangles, ids, gaps, messages, progress and threads.
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Flow/ReferenceTermination.h"
#include "Support/Flow/ReferenceTerminationMesh.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTerminationBox.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"
#include "vtkTerminationSurfaceSource.h"
#include "vtkTerminationTube.h"

#include <cmath>
#include <map>

namespace
{

using namespace reference;

const double Pi = std::acos(-1.0);

Vector PointOf(vtkPolyData* data, vtkIdType id)
{
  Vector x;
  data->GetPoint(id, x.data());
  return x;
}

// Checks the area of each part, and the points, parameters and normals of all triangles.
void CheckSurface(vtkTerminationSurface* surface, int resolution,
  const std::map<int, double>& areas, double tolerance, const std::string& name, Check& check)
{
  check.SetContext(name);
  vtkNew<vtkTerminationSurfaceSource> source;
  source->SetSurface(surface);
  source->SetResolutionU(resolution);
  source->SetResolutionV(resolution);
  const std::string messages = UpdateAndGetErrors(source);
  check.That(messages.empty(), "no messages: " + messages);
  vtkPolyData* output = source->GetOutput();
  vtkDataArray* texture = output->GetPointData()->GetTCoords();
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  vtkDataArray* ids = output->GetCellData()->GetArray("TerminationId");
  check.That(texture && normals && ids, "the arrays exist");
  if (!texture || !normals || !ids)
  {
    return;
  }
  check.That(std::string(texture->GetName()) == "TerminationUV", "name of the parameters");
  check.That(std::string(normals->GetName()) == "Normals", "the name of the normals");
  std::map<int, double> found;
  vtkNew<vtkIdList> cell;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    output->GetCellPoints(i, cell);
    check.Equal(cell->GetNumberOfIds(), 3, "the cell is a triangle");
    const int id = static_cast<int>(ids->GetTuple1(i));
    Vector corners[3];
    Vector mean = { { 0.0, 0.0, 0.0 } };
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType point = cell->GetId(k);
      corners[k] = PointOf(output, point);
      check.Near(
        GetSurfaceDistance(surface, corners[k]), 0.0, 1e-12, "the point is on the surface", 1.0);
      const double* uv = texture->GetTuple(point);
      Vector again;
      check.That(surface->EvaluatePoint(id - surface->GetId(), uv, again.data()) &&
          GetNorm(again - corners[k]) < 1e-12,
        "the parameters of a point");
      Vector normal;
      normals->GetTuple(point, normal.data());
      check.Near(GetNorm(normal), 1.0, 1e-9, "length of a normal");
      mean += normal;
    }
    const Vector cross = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    // A tiny triangle with all corners on the boundary of a part may be oriented differently.
    check.That(GetNorm(cross) < 1e-6 || Dot(cross, mean) > 0.9 * GetNorm(cross) * GetNorm(mean),
      "triangles and normals have the same orientation");
    found[id] += 0.5 * GetNorm(cross);
  }
  check.Equal(static_cast<long long>(found.size()), static_cast<long long>(areas.size()), "parts");
  for (const auto& area : areas)
  {
    check.Near(
      found[area.first], area.second, tolerance, "area of id " + std::to_string(area.first));
  }
}

void CheckShapes(Check& check)
{
  vtkNew<vtkTerminationPlane> plane;
  plane->SetId(3);
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(2.0, 0.0, 0.0);
  plane->SetPoint2(1.0, 3.0, 0.0);
  plane->UnboundedOn();
  CheckSurface(plane, 7, { { 3, 6.0 } }, 1e-12, "plane", check);
  vtkNew<vtkTerminationSphere> sphere;
  sphere->SetId(0);
  sphere->SetAxis(1.0, 1.0, 0.0);
  CheckSurface(sphere, 48, { { 0, Pi } }, 0.005, "sphere", check);
  vtkNew<vtkTerminationSurfaceSource> source;
  source->SetSurface(sphere);
  source->Update();
  check.Equal(source->GetOutput()->GetNumberOfCells(), 2 * 32 * 31,
    "triangles of a sphere, without the degenerate triangles at the poles");
  vtkNew<vtkTerminationBox> box;
  box->SetId(10);
  box->SetBounds(0.0, 1.0, 0.0, 2.0, 0.0, 3.0);
  CheckSurface(box, 4,
    { { 10, 6.0 }, { 11, 6.0 }, { 12, 3.0 }, { 13, 3.0 }, { 14, 2.0 }, { 15, 2.0 } }, 1e-12, "box",
    check);
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->SetId(5);
  cylinder->SetRadius(0.5);
  cylinder->SetPoint2(0.0, 0.0, 1.5);
  CheckSurface(cylinder, 40, { { 5, 2.0 * Pi } }, 0.005, "cylinder", check);
  cylinder->CappedOn();
  CheckSurface(cylinder, 40, { { 5, 2.0 * Pi }, { 6, 0.25 * Pi }, { 7, 0.25 * Pi } }, 0.005,
    "capped cylinder", check);
  vtkNew<vtkTerminationTube> tube;
  tube->SetId(0);
  tube->AddPoint(0.0, 0.0, 0.0);
  tube->AddPoint(0.0, 2.0, 0.0);
  tube->CappedOn();
  const double half = 2.0 * Pi * 0.25;
  CheckSurface(tube, 40, { { 0, 2.0 * Pi }, { 1, half }, { 2, half } }, 0.005, "tube", check);
  // A mesh whose texture coordinates form a diamond.
  TexturedMesh diamond;
  diamond.Points = { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { -1, 0, 0 } }, { { 0, -1, 0 } } };
  diamond.Texture = { { { 1.0, 0.5 } }, { { 0.5, 1.0 } }, { { 0.0, 0.5 } }, { { 0.5, 0.0 } } };
  diamond.Triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
  vtkNew<vtkTerminationMesh> mesh;
  mesh->SetId(0);
  mesh->SetMesh(diamond.MakeData());
  CheckSurface(mesh, 8, { { 0, 2.0 } }, 1e-6, "diamond", check);
}

void CheckErrors(Check& check)
{
  check.SetContext("messages");
  vtkNew<vtkTerminationSurfaceSource> source;
  check.Contains(UpdateAndGetErrors(source), "call SetSurface");
  vtkNew<vtkTerminationSphere> sphere;
  source->SetSurface(sphere);
  for (double radius : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    sphere->SetRadius(radius);
    check.Contains(UpdateAndGetErrors(source), "radius must be finite and greater than 0");
    check.Equal(source->GetOutput()->GetNumberOfPoints(), 0, "the output is empty");
  }
  sphere->SetRadius(1.0);
  check.That(UpdateAndGetErrors(source).empty(), "a valid radius");
  check.That(source->GetOutput()->GetNumberOfCells() > 1000, "a modified surface is detected");
  source->SetResolutionU(0);
  check.Equal(source->GetResolutionU(), 1, "clamped to the minimum");
  source->SetResolutionV(20000);
  check.Equal(source->GetResolutionV(), 10000, "clamped to the maximum");
  CheckPrinted(Print(source), { "Surface: ", "ResolutionU: 1", "ResolutionV: 10000" }, check);
}

void CheckReport(Check& check)
{
  check.SetContext("report");
  vtkNew<vtkTerminationSphere> sphere;
  vtkNew<vtkTerminationSurfaceSource> source;
  source->SetSurface(sphere);
  source->Update();
  vtkInterlumeReport* report = source->GetReport();
  check.Equal(report->GetCount("Parts"), 1, "parts of a sphere");
  check.Equal(report->GetCount("Points"), 33 * 33, "points of a sphere");
  check.Equal(report->GetCount("BorderPoints"), 0, "a sphere has no boundary");
  check.Equal(report->GetCount("Triangles"), 2 * 32 * 31, "triangles of a sphere");
  check.Equal(report->GetCount("FlatTriangles"), 2 * 32, "degenerate triangles at two poles");
  CheckPrinted(Print(source), { "Report:", "  Parts: 1", "  FlatTriangles: 64" }, check);
  // A mesh whose texture coordinates form the diamond |2 u - 1| + |2 v - 1| <= 1. With an odd
  // resolution, no grid point lies on the boundary of the diamond.
  TexturedMesh diamond;
  diamond.Points = { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { -1, 0, 0 } }, { { 0, -1, 0 } } };
  diamond.Texture = { { { 1.0, 0.5 } }, { { 0.5, 1.0 } }, { { 0.0, 0.5 } }, { { 0.5, 0.0 } } };
  diamond.Triangles = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
  vtkNew<vtkTerminationMesh> mesh;
  mesh->SetMesh(diamond.MakeData());
  constexpr int n = 7;
  source->SetSurface(mesh);
  source->SetResolutionU(n);
  source->SetResolutionV(n);
  source->Update();
  const auto isInside = [](int i, int j) { return std::abs(2 * i - n) + std::abs(2 * j - n) < n; };
  int inside = 0;
  int crossings = 0;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      inside += isInside(i, j) ? 1 : 0;
      crossings += i < n && isInside(i, j) != isInside(i + 1, j) ? 1 : 0;
      crossings += j < n && isInside(i, j) != isInside(i, j + 1) ? 1 : 0;
    }
  }
  check.Equal(report->GetCount("BorderPoints"), crossings, "points on the boundary of a diamond");
  check.Equal(report->GetCount("Points"), inside + crossings, "points of a diamond");
  check.Equal(report->GetCount("Triangles"), source->GetOutput()->GetNumberOfCells(),
    "triangles of a diamond");
  source->SetSurface(nullptr);
  check.That(!UpdateAndGetErrors(source).empty(), "no surface");
  check.Equal(
    report->GetCount("Parts") + report->GetCount("Points") + report->GetCount("Triangles"), 0,
    "no output after an error");
}

void CheckProgressOfSource(Check& check)
{
  check.SetContext("progress");
  vtkNew<vtkTerminationBox> box;
  vtkNew<vtkTerminationSurfaceSource> source;
  source->SetSurface(box);
  const auto update = [&]()
  {
    source->Update();
    return GetBytes(source->GetOutput());
  };
  CheckAborts(source, 50, { 0.5 }, update, check);
}

void CheckThreadsOfSource(Check& check)
{
  check.SetContext("threads");
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->CappedOn();
  const auto sample = [&]()
  {
    vtkNew<vtkTerminationSurfaceSource> source;
    source->SetSurface(cylinder);
    source->Update();
    vtkPolyData* output = source->GetOutput();
    std::vector<double> found;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Vector x = PointOf(output, i);
      const double* uv = output->GetPointData()->GetTCoords()->GetTuple(i);
      found.insert(found.end(), x.begin(), x.end());
      found.insert(found.end(), uv, uv + 2);
    }
    vtkNew<vtkIdList> cell;
    for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
    {
      output->GetCellPoints(i, cell);
      found.insert(found.end(), cell->begin(), cell->end());
    }
    check.That(found.size() > 10000, "the output is not empty");
    return found;
  };
  CheckSame("threads", sample, check);
}

}

int TestTerminationSurfaceSource(int, char*[])
{
  return RunChecks(
    { CheckShapes, CheckErrors, CheckReport, CheckProgressOfSource, CheckThreadsOfSource });
}
