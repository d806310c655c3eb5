// SPDX-License-Identifier: BSD-3-Clause
// Texture coordinates of meshes as parameters: conversion from points and back, seams with and
// without duplicate points, gaps, strips and polygons, and IsOn of a half cylinder.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceTermination.h"
#include "Support/Flow/ReferenceTerminationMesh.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTerminationMesh.h"

#include <cmath>

namespace
{

using namespace reference;

const double Pi = std::acos(-1.0);

Vector OnCylinder(double u, double v)
{
  return { { 0.5 * std::cos(2.0 * Pi * u), 0.5 * std::sin(2.0 * Pi * u), v - 0.5 } };
}

// Offset of u, as a fraction of a turn, so that u = 0 lies inside triangles instead of at vertices.
const double Shift = 0.02;

// Returns the mesh without points at u = 1, so that triangles at the seam use the points at u = 0.
// Adds \a shift to u.
TexturedMesh WithoutSeam(const TexturedMesh& mesh, int columns, double shift = 0.0)
{
  TexturedMesh merged;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    if (i % (columns + 1) < static_cast<std::size_t>(columns))
    {
      merged.Points.push_back(mesh.Points[i]);
      merged.Texture.push_back({ { mesh.Texture[i][0] + shift, mesh.Texture[i][1] } });
    }
  }
  for (auto triangle : mesh.Triangles)
  {
    for (int& corner : triangle)
    {
      corner = corner / (columns + 1) * columns + corner % (columns + 1) % columns;
    }
    merged.Triangles.push_back(triangle);
  }
  return merged;
}

void CheckCylinder(const TexturedMesh& mesh, int columns, double shift, const SurfaceScale& scale,
  const std::string& name, Check& check)
{
  check.SetContext(name + ", size " + std::to_string(scale.Size));
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(mesh.GetTransformed(scale).MakeData());
  surface->PeriodicUOn();
  const std::string error = surface->Update();
  check.That(error.empty(), "no error: " + error);
  check.Equal(surface->GetNumberOfBorderEdges(), 2 * columns, "boundary edges only at the ends");
  check.That(surface->IsPeriodic(0) && !surface->IsPeriodic(1), "u is periodic");
  CheckRoundTrip(surface, scale, 300, name, check);
  // The parameters equal those of the exact cylinder up to the chord error.
  Random random(9);
  for (int i = 0; i < 500; ++i)
  {
    const double u = i < 100 ? random.Get(-0.02, 0.02) : random.Get(0.0, 1.0);
    const double v = random.Get(0.0, 1.0);
    const Vector x = scale.Center + scale.Size * OnCylinder(u - shift, v);
    double uv[2];
    surface->EvaluateParameters(x.data(), uv);
    check.Near(uv[0] - u - std::round(uv[0] - u), 0.0, 2e-4, "u", 1.0);
    check.Near(uv[1], v, 1e-6, "v", 1.0);
    check.That(uv[0] >= 0.0 && uv[0] < 1.0, "u is at least 0 and below 1");
    const double distance = GetSurfaceDistance(surface, x) / scale.Size;
    check.That(distance >= -1e-6 && distance < 0.01, "the mesh is inside the cylinder");
    const double lifted[2] = { u - std::floor(u), v };
    Vector y;
    check.That(surface->EvaluatePoint(0, lifted, y.data()), "the point exists");
    check.That(GetNorm(y - x) < 0.01 * scale.Size, "the point is close to the position");
  }
  for (double v : { -1e-5, 0.0, 1.0, 1.0 + 1e-5 })
  {
    // A position at vertices of the mesh, which lie on the exact cylinder, or slightly past them.
    const Vector x = scale.Center + scale.Size * OnCylinder(2.0 / columns, v);
    check.That(surface->IsOn(x.data()) == (v == 0.0 || v == 1.0), "the ends");
  }
}

// Two texture patches with a gap in between.
void CheckGap(Check& check)
{
  check.SetContext("gap");
  TexturedMesh mesh = MakeGridMesh(3, 1, [](double u, double v) { return Vector{ { u, v, 0 } }; });
  // Removes the center column.
  mesh.Triangles.erase(mesh.Triangles.begin() + 2, mesh.Triangles.begin() + 4);
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(mesh.MakeData());
  surface->Update();
  for (double u : { 0.1, 0.33, 0.34, 0.5, 0.66, 0.67, 0.9 })
  {
    const double uv[2] = { u, 0.4 };
    Vector x;
    const bool exists = u < 1.0 / 3.0 || u > 2.0 / 3.0;
    check.That(surface->EvaluatePoint(0, uv, x.data()) == exists, "points exist outside the gap");
    const Vector position = { { u, 0.4, 0.0 } };
    check.That(
      surface->IsOn(position.data()) == exists, "positions outside the gap are on the surface");
  }
  for (const auto& outside : { std::array<double, 2>{ { 1.1, 0.5 } },
         std::array<double, 2>{ { 0.1, -0.1 } }, std::array<double, 2>{ { NAN, 0.5 } } })
  {
    Vector x;
    check.That(
      !surface->EvaluatePoint(0, outside.data(), x.data()), "no point outside the texture");
    check.That(
      !surface->EvaluatePoint(1, mesh.Texture[0].data(), x.data()), "no point of another part");
  }
}

// Without PeriodicU, a triangle across a texture seam spans the entire range of u.
void CheckPeriodicU(Check& check)
{
  check.SetContext("periodic");
  const TexturedMesh mesh = WithoutSeam(MakeGridMesh(20, 4, OnCylinder), 20);
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(mesh.MakeData());
  surface->Update();
  const Vector x = OnCylinder(0.975, 0.3);
  double uv[2];
  surface->EvaluateParameters(x.data(), uv);
  check.That(uv[0] > 0.1 && uv[0] < 0.9, "not periodic: u decreases across the seam");
  surface->PeriodicUOn();
  surface->Update();
  surface->EvaluateParameters(x.data(), uv);
  check.Near(uv[0], 0.975, 1e-3, "periodic: u continues across the seam");
}

// v is periodic, u is not.
void CheckPeriodicV(Check& check)
{
  check.SetContext("periodic v");
  TexturedMesh mesh = WithoutSeam(MakeGridMesh(20, 4, OnCylinder), 20, Shift);
  for (auto& texture : mesh.Texture)
  {
    std::swap(texture[0], texture[1]);
  }
  vtkNew<vtkTerminationMesh> surface;
  surface->SetMesh(mesh.MakeData());
  surface->PeriodicVOn();
  check.That(surface->Update().empty(), "no error");
  check.That(!surface->IsPeriodic(0) && surface->IsPeriodic(1), "v is periodic");
  CheckRoundTrip(surface, SurfaceScale(), 300, "periodic v", check);
}

// A rectangle as a triangle strip, as polygons (one of them concave), and as quadrilaterals with
// opposite orientations.
void CheckCells(Check& check)
{
  check.SetContext("cells");
  TexturedMesh mesh;
  mesh.Points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 2, 0, 0 } }, { { 2, 1, 0 } },
    { { 1, 1, 0 } }, { { 0, 1, 0 } }, { { 0.5, 0.5, 0 } } };
  for (const Vector& point : mesh.Points)
  {
    mesh.Texture.push_back({ { point[0] / 2.0, point[1] } });
  }
  const auto checkData = [&](vtkPolyData* data, int triangles, const std::string& name)
  {
    vtkNew<vtkTerminationMesh> surface;
    surface->SetMesh(data);
    const std::string error = surface->Update();
    check.That(error.empty(), name + ": no error " + error);
    check.Equal(surface->GetNumberOfTriangles(), triangles, name + ": triangles");
    CheckRoundTrip(surface, SurfaceScale(), 300, name, check);
  };
  auto data = mesh.MakeData();
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 5, 0, 4, 1, 3, 2 });
  data->SetPolys(vtkNew<vtkCellArray>());
  data->SetStrips(strips);
  checkData(data, 4, "strip");
  data = mesh.MakeData();
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3, 4, 5, 6 });
  polygons->InsertNextCell({ 0, 6, 5 });
  data->SetPolys(polygons);
  checkData(data, 6, "concave polygon");
  data = mesh.MakeData();
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 4, 5 });
  quads->InsertNextCell({ 3, 2, 1, 4 });
  data->SetPolys(quads);
  checkData(data, 4, "quadrilaterals of two orientations");
}

}

int TestTerminationMeshParameters(int, char*[])
{
  Check check;
  const int columns = 20;
  const TexturedMesh mesh = MakeGridMesh(columns, 6, OnCylinder);
  for (const SurfaceScale& scale : MakeSurfaceScales())
  {
    CheckCylinder(mesh, columns, 0.0, scale, "duplicate points at the seam", check);
    CheckCylinder(
      WithoutSeam(mesh, columns), columns, 0.0, scale, "triangles that end at the seam", check);
    CheckCylinder(
      WithoutSeam(mesh, columns, Shift), columns, Shift, scale, "triangles over the seam", check);
  }
  CheckGap(check);
  CheckPeriodicU(check);
  CheckPeriodicV(check);
  CheckCells(check);
  return check.Result();
}
