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
#include <tuple>

namespace interlume
{

namespace
{
using Polygon = std::vector<vtkIdType>;

/// Returns the polygons of a cell of two dimensions; none for a cell of another kind.
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

/// The distance that rounding may account for, in units of rounding of the largest coordinate.
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

/// Returns the distance that rounding of the input's coordinates may account for.
double FindRounding(vtkDataSet* input, const DistinctPoints& points)
{
  vtkPointSet* set = vtkPointSet::SafeDownCast(input);
  const bool isSingle = set && set->GetPoints()->GetDataType() == VTK_FLOAT;
  return RoundingSteps * FindLargest(points.Coordinates) *
    (isSingle ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon());
}

std::array<int, 3> Sorted(const int* triangle)
{
  std::array<int, 3> sorted{ { triangle[0], triangle[1], triangle[2] } };
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}
}

ClosedSurface::ClosedSurface(const DistinctPoints& points, const std::vector<int>& triangles)
  : Points(points)
  , Triangles(triangles)
  , CellIds(triangles.size() / 3, 0)
{
  this->ConnectEdges();
}

TetGenProblem ClosedSurface::MakeProblem(bool preserveBoundary) const
{
  TetGenProblem problem;
  problem.Switches = preserveBoundary ? "pYMJnQ" : "pM0/1JnQ";
  problem.Points = this->Points.Coordinates;
  problem.Triangles = this->Triangles;
  for (int patch : this->Patches)
  {
    problem.Markers.push_back(patch + 1);
  }
  return problem;
}

std::string ClosedSurface::Take(vtkDataSet* input, bool splitContacts)
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
          return "Cell " + std::to_string(cell) + " has point " + std::to_string(point) +
            ", which is not there.";
        }
        isUsed[point] = true;
      }
    }
  }
  std::string wrong = this->Points.Take(input, isUsed);
  wrong = wrong.empty() ? this->AddPolygons(input) : wrong;
  if (wrong.empty())
  {
    this->DropRepeated();
    wrong = this->CheckAreas();
  }
  if (wrong.empty())
  {
    this->InputTriangles = this->Triangles;
    this->Origins.resize(this->CellIds.size());
    std::iota(this->Origins.begin(), this->Origins.end(), 0);
    wrong = this->SplitContacts(FindRounding(input, this->Points), splitContacts);
  }
  return wrong.empty() ? this->ConnectEdges() : wrong;
}

std::string ClosedSurface::AddPolygons(vtkDataSet* input)
{
  const std::vector<double>& x = this->Points.Coordinates;
  const FaceTriangulation triangulation([&x](vtkIdType p) { return glm::make_vec3(&x[3 * p]); },
    [](vtkIdType a, vtkIdType b) { return a < b; });
  vtkNew<vtkIdList> ids;
  std::vector<FaceTriangulation::Triangle> triangles;
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
      if (!triangulation.Triangulate(polygon, triangles))
      {
        return "The polygon of cell " + std::to_string(cell) + " meets itself or has no area.";
      }
      for (const auto& triangle : triangles)
      {
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
        {
          this->Triangles.insert(this->Triangles.end(), triangle.begin(), triangle.end());
          this->CellIds.push_back(cell);
          this->Layers.push_back(1);
        }
      }
    }
  }
  return this->CellIds.empty() ? "The surface has no triangle." : std::string();
}

void ClosedSurface::DropRepeated()
{
  std::map<std::array<int, 3>, std::size_t> first;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < this->CellIds.size(); ++i)
  {
    const auto found = first.emplace(Sorted(&this->Triangles[3 * i]), kept);
    if (!found.second)
    {
      this->Layers[found.first->second] += this->Layers[i];
      this->CellIds[found.first->second] = this->CellIds[i];
      continue;
    }
    std::copy_n(&this->Triangles[3 * i], 3, &this->Triangles[3 * kept]);
    this->CellIds[kept] = this->CellIds[i];
    this->Layers[kept] = this->Layers[i];
    if (!this->Origins.empty())
    {
      this->Origins[kept] = this->Origins[i];
    }
    ++kept;
  }
  this->Triangles.resize(3 * kept);
  this->CellIds.resize(kept);
  this->Layers.resize(kept);
  this->Origins.resize(this->Origins.empty() ? 0 : kept);
}

void ClosedSurface::MergePoints(const std::map<int, int>& merged)
{
  const auto number = static_cast<int>(this->Points.SourceIds.size());
  std::vector<int> now(number);
  int kept = 0;
  for (int p = 0; p < number; ++p)
  {
    const auto found = merged.find(p);
    now[p] = found == merged.end() ? kept : now[found->second];
    if (found == merged.end())
    {
      this->Points.SourceIds[kept] = this->Points.SourceIds[p];
      std::copy_n(&this->Points.Coordinates[3 * p], 3, &this->Points.Coordinates[3 * kept]);
      ++kept;
    }
  }
  this->Points.NumberOfMerged += number - kept;
  this->Points.SourceIds.resize(kept);
  this->Points.Coordinates.resize(3 * kept);
  for (std::vector<int>* list : { &this->Triangles, &this->InputTriangles })
  {
    for (int& point : *list)
    {
      point = now[point];
    }
  }
  // Triangles that collapse have no area left.
  std::size_t left = 0;
  for (std::size_t i = 0; i < this->CellIds.size(); ++i)
  {
    const std::array<int, 3> sorted = Sorted(&this->Triangles[3 * i]);
    if (sorted[0] != sorted[1] && sorted[1] != sorted[2])
    {
      std::copy_n(&this->Triangles[3 * i], 3, &this->Triangles[3 * left]);
      this->CellIds[left] = this->CellIds[i];
      this->Layers[left] = this->Layers[i];
      this->Origins[left] = this->Origins[i];
      ++left;
    }
  }
  this->Triangles.resize(3 * left);
  this->CellIds.resize(left);
  this->Layers.resize(left);
  this->Origins.resize(left);
  this->DropRepeated();
}

std::string ClosedSurface::SplitContacts(double tolerance, bool splitContacts)
{
  SurfaceContacts contacts(*this, tolerance);
  if (!contacts.Find())
  {
    return std::string();
  }
  if (!splitContacts)
  {
    return "Cells " + std::to_string(contacts.GetFirstCells()[0]) + " and " +
      std::to_string(contacts.GetFirstCells()[1]) +
      " touch without common points or edges. Turn SplitContacts on, or make the surfaces share "
      "their points there.";
  }
  const std::string wrong = contacts.Split();
  this->NumberOfSplitTriangles = contacts.GetNumberOfSplitTriangles();
  return wrong;
}

std::string ClosedSurface::CheckAreas() const
{
  using namespace Vectors;
  for (std::size_t i = 0; i < this->CellIds.size(); ++i)
  {
    const double* a = &this->Points.Coordinates[3 * this->Triangles[3 * i]];
    const glm::dvec3 normal =
      glm::cross(Difference(&this->Points.Coordinates[3 * this->Triangles[3 * i + 1]], a),
        Difference(&this->Points.Coordinates[3 * this->Triangles[3 * i + 2]], a));
    if (normal[0] == 0.0 && normal[1] == 0.0 && normal[2] == 0.0)
    {
      return "Cell " + std::to_string(this->CellIds[i]) +
        " has a triangle without area: its points lie on a line.";
    }
  }
  return std::string();
}

bool ClosedSurface::AreCoplanar(std::size_t triangle, std::size_t other) const
{
  using namespace Vectors;
  const auto point = [this](std::size_t t, int i)
  { return &this->Points.Coordinates[3 * this->Triangles[3 * t + i]]; };
  const double* a = point(triangle, 0);
  const glm::dvec3 normal =
    glm::cross(Difference(point(triangle, 1), a), Difference(point(triangle, 2), a));
  const double length = std::sqrt(glm::dot(normal, normal));
  for (int i = 0; i < 3; ++i)
  {
    const double* x = point(other, i);
    if (std::abs(glm::dot(normal, Difference(x, a))) > this->Flatness * length)
    {
      return false;
    }
  }
  return true;
}

std::string ClosedSurface::ConnectEdges()
{
  struct Edge
  {
    int From, To;
    std::size_t Triangle;
  };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const int a = this->Triangles[i];
    const int b = this->Triangles[i % 3 == 2 ? i - 2 : i + 1];
    edges.push_back({ std::min(a, b), std::max(a, b), i / 3 });
  }
  std::sort(edges.begin(), edges.end(),
    [](const Edge& a, const Edge& b)
    { return std::tie(a.From, a.To, a.Triangle) < std::tie(b.From, b.To, b.Triangle); });
  // Triangles that were split within rounding are one plane still.
  this->Flatness = 2.0 * RoundingSteps * FindLargest(this->Points.Coordinates) *
    std::numeric_limits<double>::epsilon();
  std::vector<std::vector<std::size_t>> neighbors(this->CellIds.size());
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
        std::to_string(this->CellIds[edges[i].Triangle]) + " alone.";
    }
    if (next == i + 2)
    {
      neighbors[edges[i].Triangle].push_back(edges[i + 1].Triangle);
      neighbors[edges[i + 1].Triangle].push_back(edges[i].Triangle);
    }
  }
  this->Patches.assign(this->CellIds.size(), -1);
  std::vector<std::size_t> stack;
  for (std::size_t first = 0; first < this->Patches.size(); ++first)
  {
    if (this->Patches[first] >= 0)
    {
      continue;
    }
    this->Patches[first] = this->NumberOfPatches++;
    stack.push_back(first);
    while (!stack.empty())
    {
      const std::size_t triangle = stack.back();
      stack.pop_back();
      for (std::size_t other : neighbors[triangle])
      {
        // All triangles are compared with the first, so that a gently curved surface is not one
        // plane.
        if (this->Patches[other] < 0 && this->AreCoplanar(first, other))
        {
          this->Patches[other] = this->Patches[first];
          stack.push_back(other);
        }
      }
    }
  }
  return std::string();
}

}
