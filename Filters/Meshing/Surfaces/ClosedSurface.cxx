// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces/ClosedSurface.h"

#include "Common/Vectors.h"
#include "Shells/FaceTriangulation.h"
#include "Surfaces/SurfaceContacts.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <tuple>

namespace interlume
{

namespace
{
using Polygon = std::vector<vtkIdType>;

/// Returns the polygons of a two-dimensional cell, or an empty list for other cells.
std::vector<Polygon> PolygonsOf(int type, vtkIdList* ids)
{
  const Polygon points(ids->begin(), ids->end());
  switch (type)
  {
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_POLYGON:
      return { points };
    case VTK_PIXEL:
      return { { points[0], points[1], points[3], points[2] } };
    case VTK_TRIANGLE_STRIP:
    {
      std::vector<Polygon> triangles;
      for (std::size_t i = 0; i + 2 < points.size(); ++i)
      {
        triangles.push_back(i % 2 == 0 ? Polygon{ points[i], points[i + 1], points[i + 2] }
                                       : Polygon{ points[i + 1], points[i], points[i + 2] });
      }
      return triangles;
    }
    default:
      return {};
  }
}

/// Assumed error of positions, as a multiple of the rounding error of the largest coordinate.
constexpr double RoundingSteps = 8.0;

double FindLargest(const std::vector<double>& coordinates)
{
  double largest = 0.0;
  for (double x : coordinates)
  {
    largest = std::max(largest, std::abs(x));
  }
  return largest;
}

/// Returns the maximum distance by which rounding may have separated coincident input points.
double FindRounding(vtkDataSet* input, const DistinctPoints& points)
{
  vtkPointSet* set = vtkPointSet::SafeDownCast(input);
  const bool isSingle = set && set->GetPoints()->GetDataType() == VTK_FLOAT;
  return RoundingSteps * FindLargest(points.Coordinates) *
    (isSingle ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon());
}

std::array<int, 3> Sorted(std::array<int, 3> points)
{
  std::sort(points.begin(), points.end());
  return points;
}
}

ClosedSurface::ClosedSurface(const DistinctPoints& points, const std::vector<int>& triangles)
  : Points(points)
{
  for (std::size_t i = 0; i < triangles.size(); i += 3)
  {
    this->Triangles.push_back({ { { triangles[i], triangles[i + 1], triangles[i + 2] } } });
  }
  // The triangles form a closed surface, so there is no error.
  static_cast<void>(this->ConnectEdges());
}

TetGenProblem ClosedSurface::MakeProblem(bool preserveBoundary) const
{
  TetGenProblem problem;
  problem.Switches = preserveBoundary ? "pYMJnQ" : "pM0/1JnQ";
  problem.Points = this->Points.Coordinates;
  for (const Triangle& triangle : this->Triangles)
  {
    problem.Triangles.insert(
      problem.Triangles.end(), triangle.Points.begin(), triangle.Points.end());
    problem.Markers.push_back(triangle.Patch + 1);
  }
  return problem;
}

Error ClosedSurface::Take(vtkDataSet* input, bool splitContacts)
{
  vtkNew<vtkIdList> ids;
  std::vector<bool> isUsed(input->GetNumberOfPoints(), false);
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, ids);
    for (const Polygon& polygon : PolygonsOf(input->GetCellType(cell), ids))
    {
      for (vtkIdType point : polygon)
      {
        if (point < 0 || point >= input->GetNumberOfPoints())
        {
          return "Cell " + std::to_string(cell) + " refers to point " + std::to_string(point) +
            ", which does not exist.";
        }
        isUsed[point] = true;
      }
    }
  }
  if (Error error = this->Points.Take(input, isUsed).Then([&] { return this->AddPolygons(input); }))
  {
    return error;
  }
  this->RemoveDuplicates();
  if (Error error = this->RemoveFlatTriangles(splitContacts))
  {
    return error;
  }
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    this->Triangles[i].Origin = static_cast<int>(i);
  }
  this->InputTriangles = this->Triangles;
  return this->SplitContacts(FindRounding(input, this->Points), splitContacts)
    .Then([&] { return this->ConnectEdges(); });
}

Error ClosedSurface::AddPolygons(vtkDataSet* input)
{
  const std::vector<double>& x = this->Points.Coordinates;
  const FaceTriangulation triangulation([&x](vtkIdType p) { return glm::make_vec3(&x[3 * p]); },
    [](vtkIdType a, vtkIdType b) { return a < b; });
  vtkNew<vtkIdList> ids;
  std::vector<FaceTriangulation::Triangle> triangles;
  vtkIdType crossings = 0;
  vtkIdType firstCrossing = -1;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, ids);
    for (Polygon polygon : PolygonsOf(input->GetCellType(cell), ids))
    {
      for (vtkIdType& point : polygon)
      {
        point = this->Points.Indices[point];
      }
      triangles.clear();
      const FaceTriangulation::Result result = triangulation.Triangulate(polygon, triangles);
      if (result == FaceTriangulation::Result::Flat)
      {
        this->FoldedCells.push_back(cell);
      }
      if (result == FaceTriangulation::Result::Crossing && crossings++ == 0)
      {
        firstCrossing = cell;
      }
      for (const auto& triangle : triangles)
      {
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
        {
          this->Triangles.push_back(
            { { { static_cast<int>(triangle[0]), static_cast<int>(triangle[1]),
                static_cast<int>(triangle[2]) } },
              cell });
        }
      }
    }
  }
  if (crossings > 0)
  {
    return "Cell " + std::to_string(firstCrossing) + " has a polygon that intersects itself (" +
      std::to_string(crossings) +
      " in all). Move its points, split it where its edges cross, or remove it and close the hole.";
  }
  return this->Triangles.empty()
    ? "The surface has no triangles: each polygon has fewer than three distinct points."
    : Error();
}

void ClosedSurface::RemoveDuplicates()
{
  std::map<std::array<int, 3>, std::size_t> first;
  std::vector<Triangle> retained;
  for (const Triangle& triangle : this->Triangles)
  {
    const auto found = first.emplace(Sorted(triangle.Points), retained.size());
    if (found.second)
    {
      retained.push_back(triangle);
      continue;
    }
    Triangle& same = retained[found.first->second];
    same.Layers += triangle.Layers;
    same.Cell = triangle.Cell;
  }
  this->Triangles = std::move(retained);
}

void ClosedSurface::ReplacePoints(const std::vector<int>& targets)
{
  const auto number = static_cast<int>(targets.size());
  std::vector<int> newIds(number, -1);
  int retained = 0;
  for (int p = 0; p < number; ++p)
  {
    if (targets[p] == p)
    {
      newIds[p] = retained;
      this->Points.SourceIds[retained] = this->Points.SourceIds[p];
      std::copy_n(&this->Points.Coordinates[3 * p], 3, &this->Points.Coordinates[3 * retained]);
      ++retained;
    }
    else if (targets[p] >= 0)
    {
      newIds[p] = newIds[targets[p]];
    }
  }
  this->Points.SourceIds.resize(retained);
  this->Points.Coordinates.resize(3 * retained);
  for (std::vector<Triangle>* list : { &this->Triangles, &this->InputTriangles })
  {
    for (Triangle& triangle : *list)
    {
      for (int& point : triangle.Points)
      {
        point = newIds[point];
      }
    }
  }
}

void ClosedSurface::RemoveUnusedPoints()
{
  std::vector<int> targets(this->Points.SourceIds.size(), -1);
  for (const Triangle& triangle : this->Triangles)
  {
    for (const int point : triangle.Points)
    {
      targets[point] = point;
    }
  }
  this->ReplacePoints(targets);
}

void ClosedSurface::MergePoints(const std::map<int, int>& merged)
{
  std::vector<int> targets(this->Points.SourceIds.size());
  std::iota(targets.begin(), targets.end(), 0);
  for (const auto& pair : merged)
  {
    targets[pair.first] = pair.second;
  }
  this->ReplacePoints(targets);
  this->Points.NumberOfMerged += static_cast<vtkIdType>(merged.size());
  // Collapsed triangles have no area, so remove them.
  const auto hasCollapsed = [](const Triangle& triangle)
  {
    const std::array<int, 3>& p = triangle.Points;
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
  };
  this->Triangles.erase(
    std::remove_if(this->Triangles.begin(), this->Triangles.end(), hasCollapsed),
    this->Triangles.end());
  this->RemoveDuplicates();
}

Error ClosedSurface::SplitContacts(double tolerance, bool splitContacts)
{
  SurfaceContacts contacts(*this, tolerance);
  if (!contacts.Find())
  {
    return {};
  }
  if (!splitContacts)
  {
    return "Cells " + std::to_string(contacts.GetFirstCells()[0]) + " and " +
      std::to_string(contacts.GetFirstCells()[1]) +
      " touch without common points or edges. Turn SplitContacts on, or make the surfaces share "
      "their points there.";
  }
  Error error = contacts.Split();
  this->NumberOfSplitTriangles = contacts.GetNumberOfSplitTriangles();
  return error;
}

glm::dvec3 ClosedSurface::GetNormal(const std::array<int, 3>& points) const
{
  const double* a = this->GetPoint(points[0]);
  return glm::cross(Vectors::Difference(this->GetPoint(points[1]), a),
    Vectors::Difference(this->GetPoint(points[2]), a));
}

Error ClosedSurface::RemoveFlatTriangles(bool splitContacts)
{
  const auto isFlat = [this](const Triangle& triangle)
  { return this->GetNormal(triangle.Points) == glm::dvec3(0.0); };
  const auto first = std::find_if(this->Triangles.begin(), this->Triangles.end(), isFlat);
  if (first == this->Triangles.end())
  {
    return {};
  }
  const std::string cell = std::to_string(first->Cell);
  if (!splitContacts)
  {
    return "Cell " + cell +
      " has a triangle without area: its points lie on a line. Turn SplitContacts on, or remove "
      "it.";
  }
  std::set<vtkIdType> counted(this->FoldedCells.begin(), this->FoldedCells.end());
  for (auto triangle = first; triangle != this->Triangles.end(); ++triangle)
  {
    if (isFlat(*triangle) && counted.insert(triangle->Cell).second)
    {
      this->FoldedCells.push_back(triangle->Cell);
    }
  }
  this->Triangles.erase(
    std::remove_if(this->Triangles.begin(), this->Triangles.end(), isFlat), this->Triangles.end());
  // TetGen crashes if a point without triangles is on an edge.
  this->RemoveUnusedPoints();
  return this->Triangles.empty()
    ? "All triangles of the surface, such as that of cell " + cell + ", have no area."
    : Error();
}

bool ClosedSurface::AreCoplanar(std::size_t triangle, std::size_t other) const
{
  const std::array<int, 3>& points = this->Triangles[triangle].Points;
  const glm::dvec3 normal = this->GetNormal(points);
  const double length = std::sqrt(glm::dot(normal, normal));
  const std::array<int, 3>& others = this->Triangles[other].Points;
  return std::all_of(others.begin(), others.end(),
    [&](int p)
    {
      return std::abs(glm::dot(
               normal, Vectors::Difference(this->GetPoint(p), this->GetPoint(points[0])))) <=
        this->Flatness * length;
    });
}

Error ClosedSurface::ConnectEdges()
{
  struct Edge
  {
    int From, To;
    std::size_t Triangle;
  };
  std::vector<Edge> edges;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = this->Triangles[t].Points[i];
      const int b = this->Triangles[t].Points[(i + 1) % 3];
      edges.push_back({ std::min(a, b), std::max(a, b), t });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b)
    { return std::tie(a.From, a.To, a.Triangle) < std::tie(b.From, b.To, b.Triangle); });
  // The parts of a split triangle are coplanar only up to rounding error.
  this->Flatness = 2.0 * RoundingSteps * FindLargest(this->Points.Coordinates) *
    std::numeric_limits<double>::epsilon();
  std::vector<std::vector<std::size_t>> neighbors(this->Triangles.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < edges.size(); i = next)
  {
    next = i + 1;
    while (
      next < edges.size() && edges[next].From == edges[i].From && edges[next].To == edges[i].To)
    {
      ++next;
    }
    if (next == i + 1)
    {
      return "The surface is open: the edge from point " +
        std::to_string(this->Points.SourceIds[edges[i].From]) + " to point " +
        std::to_string(this->Points.SourceIds[edges[i].To]) + " belongs to cell " +
        std::to_string(this->Triangles[edges[i].Triangle].Cell) + " only. Close the surface.";
    }
    if (next == i + 2)
    {
      neighbors[edges[i].Triangle].push_back(edges[i + 1].Triangle);
      neighbors[edges[i + 1].Triangle].push_back(edges[i].Triangle);
    }
  }
  std::vector<std::size_t> stack;
  for (std::size_t first = 0; first < this->Triangles.size(); ++first)
  {
    if (this->Triangles[first].Patch >= 0)
    {
      continue;
    }
    const int patch = this->NumberOfPatches++;
    this->Triangles[first].Patch = patch;
    stack.push_back(first);
    while (!stack.empty())
    {
      const std::size_t triangle = stack.back();
      stack.pop_back();
      for (std::size_t other : neighbors[triangle])
      {
        // Compare with the first triangle of the patch so that a gently curved surface does not
        // become a single patch.
        if (this->Triangles[other].Patch < 0 && this->AreCoplanar(first, other))
        {
          this->Triangles[other].Patch = patch;
          stack.push_back(other);
        }
      }
    }
  }
  return {};
}

}
