// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Flow/ReferenceTerminationMesh.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceRandom.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference
{

vtkSmartPointer<vtkPolyData> TexturedMesh::MakeData() const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> texture;
  texture->SetName("Texture");
  texture->SetNumberOfComponents(2);
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    points->InsertNextPoint(this->Points[i].data());
    texture->InsertNextTuple(this->Texture[i].data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& triangle : this->Triangles)
  {
    cells->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetTCoords(texture);
  return data;
}

TexturedMesh TexturedMesh::GetTransformed(const SurfaceScale& scale) const
{
  TexturedMesh placed = *this;
  for (Vector& point : placed.Points)
  {
    point = scale.Center + scale.Size * point;
  }
  return placed;
}

TexturedMesh MakeGridMesh(
  int columns, int rows, const std::function<Vector(double, double)>& position)
{
  TexturedMesh mesh;
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const double u = static_cast<double>(i) / columns;
      const double v = static_cast<double>(j) / rows;
      mesh.Points.push_back(position(u, v));
      mesh.Texture.push_back({ { u, v } });
    }
  }
  for (const auto& [j, i] : AllIndices(rows, columns))
  {
    const int first = i + j * (columns + 1);
    const int above = first + columns + 1;
    for (const auto& triangle : { std::array<int, 3>{ { first, first + 1, above + 1 } },
           std::array<int, 3>{ { first, above + 1, above } } })
    {
      const Vector& a = mesh.Points[triangle[0]];
      const Vector normal = Cross(mesh.Points[triangle[1]] - a, mesh.Points[triangle[2]] - a);
      if (GetNorm(normal) > 1e-12)
      {
        mesh.Triangles.push_back(triangle);
      }
    }
  }
  return mesh;
}

TexturedMesh MakeSolid(
  const std::vector<Vector>& points, const std::vector<std::array<int, 3>>& triangles)
{
  TexturedMesh mesh;
  mesh.Points = points;
  mesh.Triangles = triangles;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh.Texture.push_back({ { 0.1 * i - std::floor(0.1 * i), 0.07 * i - std::floor(0.07 * i) } });
  }
  return mesh;
}

TexturedMesh MakeTetrahedron()
{
  return MakeSolid({ { { -0.5, -0.4, -0.3 } }, { { 0.6, -0.3, -0.4 } }, { { 0.0, 0.7, -0.3 } },
                     { { 0.1, 0.0, 0.6 } } },
    { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 2, 0, 3 } } });
}

TexturedMesh MakeStar()
{
  std::vector<Vector> points(8);
  for (int i = 0; i < 8; ++i)
  {
    points[i] = { { i & 1 ? 0.25 : -0.25, i & 2 ? 0.25 : -0.25, i & 4 ? 0.25 : -0.25 } };
  }
  std::vector<std::array<int, 3>> triangles;
  for (const auto& [axis, side] : AllIndices(3, 2))
  {
    const int tip = static_cast<int>(points.size());
    Vector position = { { 0.05, -0.03, 0.02 } };
    position[axis] = side ? 0.9 : -0.9;
    points.push_back(position);
    const int u = 1 << (axis + 1) % 3;
    const int v = 1 << (axis + 2) % 3;
    const int base = side << axis;
    const int corners[4] = { base, base + u, base + u + v, base + v };
    for (int i = 0; i < 4; ++i)
    {
      const int a = corners[side ? i : (i + 1) % 4];
      const int b = corners[side ? (i + 1) % 4 : i];
      triangles.push_back({ { a, b, tip } });
    }
  }
  return MakeSolid(points, triangles);
}

std::vector<Vector> MakeSignTestPoints(const TexturedMesh& mesh)
{
  Random random(17);
  std::vector<Vector> positions;
  for (const auto& triangle : mesh.Triangles)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Vector& a = mesh.Points[triangle[i]];
      const Vector& b = mesh.Points[triangle[(i + 1) % 3]];
      const Vector& c = mesh.Points[triangle[(i + 2) % 3]];
      const Vector outward = a + b - 2.0 * c;
      for (double step : { 1e-7, 1e-3, 0.1, 1.0 })
      {
        const double size = GetNorm(b - a);
        positions.push_back(a + step * size * random.GetDirection());
        const Vector center = a + random.Get(0.0, 1.0) * (b - a);
        positions.push_back(center + step * size * random.GetDirection());
        positions.push_back(center + step * outward);
        positions.push_back(a + step * (a + 0.5 * b - 1.5 * c));
      }
    }
  }
  return positions;
}

double NearestDistance(const TexturedMesh& mesh, const Vector& x)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.Triangles)
  {
    const Vector corners[3] = { mesh.Points[triangle[0]], mesh.Points[triangle[1]],
      mesh.Points[triangle[2]] };
    const Vector normal = Cross(corners[1] - corners[0], corners[2] - corners[0]);
    bool isInside = true;
    for (int i = 0; i < 3; ++i)
    {
      const Vector side = corners[(i + 1) % 3] - corners[i];
      const Vector p = x - corners[i];
      isInside = isInside && Dot(Cross(side, p), normal) >= 0.0;
      const double t = std::max(0.0, std::min(Dot(p, side) / Dot(side, side), 1.0));
      nearest = std::min(nearest, GetNorm(p - t * side));
    }
    if (isInside)
    {
      nearest = std::min(nearest, std::abs(Dot(x - corners[0], normal)) / GetNorm(normal));
    }
  }
  return nearest;
}

double WindingNumber(const TexturedMesh& mesh, const Vector& x)
{
  double sum = 0.0;
  for (const auto& triangle : mesh.Triangles)
  {
    const Vector a = mesh.Points[triangle[0]] - x;
    const Vector b = mesh.Points[triangle[1]] - x;
    const Vector c = mesh.Points[triangle[2]] - x;
    const double la = GetNorm(a);
    const double lb = GetNorm(b);
    const double lc = GetNorm(c);
    sum += 2.0 *
      std::atan2(
        Dot(a, Cross(b, c)), la * lb * lc + Dot(a, b) * lc + Dot(b, c) * la + Dot(c, a) * lb);
  }
  return sum / (4.0 * std::acos(-1.0));
}

}
