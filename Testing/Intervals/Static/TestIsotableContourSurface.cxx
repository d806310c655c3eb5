// SPDX-License-Identifier: BSD-3-Clause
// Isosurfaces are closed inside the domain, two-manifold, oriented toward lower values and at the
// correct position: for random values on every cell type, and for a sphere, whose area and volume
// are known and whose triangles are compared with another filter.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceBoundary.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iostream>

namespace
{

using namespace reference;

void CheckClosed(vtkDataSet* mesh, vtkUnstructuredGrid* surface, Check& check)
{
  const DomainBoundary boundary(mesh);
  const std::vector<Triangle> triangles = TrianglesOf(surface);
  check.That(!triangles.empty() && IsValid(surface, VTK_TRIANGLE), "there are triangles");
  long long open = 0;
  long long strange = 0;
  for (const EdgeUse& edge : CountUses(EdgesOf(triangles)))
  {
    strange += edge.Plus > 1 || edge.Minus > 1 ? 1 : 0;
    if (edge.Net() != 0)
    {
      std::vector<DomainBoundary::Point> points(2);
      surface->GetPoint(edge.Key[0], points[0].data());
      surface->GetPoint(edge.Key[1], points[1].data());
      open += boundary.Find(points) < 0 ? 1 : 0;
    }
  }
  check.Equal(open, 0, "open edges inside the domain");
  check.Equal(strange, 0, "edges used more than once with the same orientation");
  check.That(VerticesAreManifold(triangles), "points are manifold");
}

void CheckRandom(MeshKind kind, Check& check)
{
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    check.SetContext(GetName(kind) + ", seed " + std::to_string(seed));
    auto mesh = RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 3 }, seed), seed), seed);
    AddRandomField(mesh, seed);
    const double value = 0.25 * seed;
    const ContourExtraction contour = ExtractContours(mesh, { value });
    CheckClosed(mesh, contour.Surface, check);
    double range[2] = { 0, 0 };
    if (vtkDataArray* field = contour.Surface->GetPointData()->GetArray("f"))
    {
      field->GetRange(range);
    }
    check.Near(range[0], value, 1e-15, "smallest value on the surface");
    check.Near(range[1], value, 1e-15, "largest value on the surface");
  }
}

/// Finds the points of a triangle and a normal whose length is twice the triangle's area.
void FindNormal(
  vtkUnstructuredGrid* surface, const Triangle& triangle, double x[3][3], double normal[3])
{
  for (int i = 0; i < 3; ++i)
  {
    surface->GetPoint(triangle[i], x[i]);
  }
  double u[3];
  double v[3];
  vtkMath::Subtract(x[1], x[0], u);
  vtkMath::Subtract(x[2], x[0], v);
  vtkMath::Cross(u, v, normal);
}

/// The isosurface of a linear function is a plane, whose normals point opposite to the gradient.
void CheckPlane(MeshKind kind, Check& check)
{
  check.SetContext(GetName(kind) + ", plane");
  auto mesh = RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 2 }), 3), 3);
  const LinearFunction function = { 0.1, { 0.6, 0.35, -0.5 } };
  AddLinearField(mesh, function);
  const double value = 1.003;
  vtkSmartPointer<vtkUnstructuredGrid> surface = ExtractContours(mesh, { value }).Surface;
  CheckClosed(mesh, surface, check);
  for (const Triangle& triangle : TrianglesOf(surface))
  {
    double x[3][3];
    double normal[3];
    FindNormal(surface, triangle, x, normal);
    for (const auto& point : x)
    {
      check.Near(function(point), value, 1e-14, "value of the function at a point");
    }
    check.That(
      vtkMath::Dot(normal, function.Gradient.data()) < 1e-15, "normals point to lower values");
  }
}

void CheckSphere(Check& check)
{
  check.SetContext("sphere");
  constexpr double radius = 0.7531;
  vtkNew<vtkImageData> image;
  image->SetDimensions(41, 41, 41);
  image->SetOrigin(-1, -1, -1);
  image->SetSpacing(0.05, 0.05, 0.05);
  vtkDoubleArray* field = AddRandomField(image, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    field->SetValue(i, vtkMath::Norm(image->GetPoint(i)));
  }
  vtkSmartPointer<vtkUnstructuredGrid> surface = ExtractContours(image, { radius }).Surface;
  CheckClosed(image, surface, check);
  long long edges = 0;
  for (const EdgeUse& edge : CountUses(EdgesOf(TrianglesOf(surface))))
  {
    ++edges;
    check.That(edge.Plus == 1 && edge.Minus == 1, "every edge has two triangles");
  }
  const long long triangles = surface->GetNumberOfCells();
  check.Equal(surface->GetNumberOfPoints() - edges + triangles, 2, "Euler characteristic");

  // Normals point toward lower values, that is, toward the center. The enclosed volume is therefore
  // negative.
  double area = 0;
  double volume = 0;
  for (const Triangle& triangle : TrianglesOf(surface))
  {
    double x[3][3];
    double normal[3];
    FindNormal(surface, triangle, x, normal);
    area += 0.5 * vtkMath::Norm(normal);
    volume += vtkMath::Dot(x[0], normal) / 6;
  }
  check.Near(area, 4 * vtkMath::Pi() * radius * radius, 5e-3, "area");
  check.Near(volume, -4 * vtkMath::Pi() / 3 * radius * radius * radius, 5e-3, "volume");

  vtkNew<vtkFlyingEdges3D> baseline;
  baseline->SetInputData(image);
  baseline->SetValue(0, radius);
  baseline->Update();
  std::cout << triangles << " triangles, vtkFlyingEdges3D "
            << baseline->GetOutput()->GetNumberOfCells() << '\n';
  check.Near(static_cast<double>(triangles),
    static_cast<double>(baseline->GetOutput()->GetNumberOfCells()), 0.02, "triangles");
  check.Equal(surface->GetNumberOfPoints(), baseline->GetOutput()->GetNumberOfPoints(), "points");
}

}

int TestIsotableContourSurface(int, char*[])
{
  Check check;
  for (MeshKind kind : AllMeshKinds())
  {
    CheckRandom(kind, check);
    CheckPlane(kind, check);
  }
  CheckSphere(check);
  return check.Result();
}
