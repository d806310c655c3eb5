// SPDX-License-Identifier: BSD-3-Clause
// Polygonal models: each part is closed, and its triangles and normals point outward.
#include "Support/Inputs/Models.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"

#include <array>
#include <map>
#include <string>
#include <utility>

namespace
{

using Position = std::array<double, 3>;

/// Maps an edge to its number of uses in one direction minus its number of uses in the other. Edges
/// are keyed by coordinates because points are duplicated where normals are discontinuous.
using Edges = std::map<std::pair<Position, Position>, int>;

void AddEdge(Edges& edges, const Position& a, const Position& b)
{
  edges[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
}

void TestPart(reference::Check& check, vtkPolyData* shape)
{
  vtkDataArray* normals = shape->GetPointData()->GetNormals();
  if (!check.That(normals && shape->GetNumberOfPolys() > 0, "the part has triangles and normals"))
  {
    return;
  }
  Edges edges;
  double volume = 0.0;
  int inward = 0;
  for (vtkIdType cell = 0; cell < shape->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    shape->GetCellPoints(cell, size, points);
    check.Equal(size, 3, "corners");
    std::array<Position, 3> x;
    Position mean{};
    for (int corner = 0; corner < 3; ++corner)
    {
      shape->GetPoint(points[corner], x[corner].data());
      double normal[3];
      normals->GetTuple(points[corner], normal);
      vtkMath::Add(mean.data(), normal, mean.data());
    }
    double normal[3];
    vtkTriangle::ComputeNormal(x[0].data(), x[1].data(), x[2].data(), normal);
    inward += vtkMath::Dot(normal, mean.data()) < 0.0 ? 1 : 0;
    volume += vtkMath::Determinant3x3(x[0].data(), x[1].data(), x[2].data()) / 6.0;
    for (int corner = 0; corner < 3; ++corner)
    {
      AddEdge(edges, x[corner], x[(corner + 1) % 3]);
    }
  }
  int open = 0;
  for (const auto& edge : edges)
  {
    open += edge.second != 0 ? 1 : 0;
  }
  check.Equal(open, 0, "open edges");
  check.Equal(inward, 0, "triangles whose normals point inward");
  check.That(volume > 0.0, "the enclosed volume is positive: " + std::to_string(volume));
}

}

int TestModels(int, char*[])
{
  using namespace interlume;
  reference::Check check;
  const std::map<std::string, Model> models = { { "mushroom", MakeMushroom(1.0, 0.5, 0.2) },
    { "teapot", MakeTeapot() }, { "dart", MakeDart() }, { "desk", MakeDesk() },
    { "airplane", MakeAirplane() }, { "chair", MakeChair() }, { "lamp", MakeLamp() },
    { "books", MakeBooks() }, { "mug", MakeMug() },
    { "moved", Move(MakeMug(), { { 1.0, 2.0, 3.0 } }, { { 0.0, 20.0, 30.0 } }) } };
  for (const auto& model : models)
  {
    for (std::size_t part = 0; part < model.second.size(); ++part)
    {
      check.SetContext(model.first + ", part " + std::to_string(part) + ": ");
      TestPart(check, model.second[part].Shape);
    }
  }
  check.SetContext("");
  // Expected volume of the rounded box: the inner box, three pairs of slabs, quarter cylinders
  // along the edges, and an eighth of a sphere at each corner.
  const double r = 0.1;
  const double pi = vtkMath::Pi();
  double found = 0.0;
  vtkSmartPointer<vtkPolyData> box = MakeRoundedBox({ { 1.0, 0.8, 0.6 } }, r);
  for (vtkIdType cell = 0; cell < box->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    box->GetCellPoints(cell, size, points);
    double x[3][3];
    for (int corner = 0; corner < 3; ++corner)
    {
      box->GetPoint(points[corner], x[corner]);
    }
    found += vtkMath::Determinant3x3(x[0], x[1], x[2]) / 6.0;
  }
  const double a = 1.0 - 2.0 * r;
  const double b = 0.8 - 2.0 * r;
  const double c = 0.6 - 2.0 * r;
  check.Near(found,
    a * b * c + 2.0 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) +
      4.0 / 3.0 * pi * r * r * r,
    2e-3, "volume of a rounded box");
  return check.Result();
}
