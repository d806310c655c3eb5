// SPDX-License-Identifier: BSD-3-Clause
#include "Shells/CellShell.h"

#include "Common/Vectors.h"
#include "Shells/FaceTriangulation.h"

#include "vtkCell.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace interlume
{

namespace
{
using Face = std::vector<vtkIdType>;

std::vector<Face> FacesOf(vtkDataSet* input, vtkIdType cell)
{
  std::vector<Face> faces;
  vtkUnstructuredGrid* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (grid && grid->GetCellType(cell) == VTK_POLYHEDRON)
  {
    vtkNew<vtkIdList> stream;
    grid->GetFaceStream(cell, stream);
    vtkIdType at = 1;
    for (vtkIdType f = 0; stream->GetNumberOfIds() > 0 && f < stream->GetId(0); ++f)
    {
      const vtkIdType* first = stream->GetPointer(at + 1);
      faces.emplace_back(first, first + stream->GetId(at));
      at += 1 + stream->GetId(at);
    }
    return faces;
  }
  vtkNew<vtkGenericCell> generic;
  input->GetCell(cell, generic);
  for (int f = 0; f < generic->GetNumberOfFaces(); ++f)
  {
    vtkCell* face = generic->GetFace(f);
    faces.emplace_back(face->GetPointIds()->begin(), face->GetPointIds()->end());
    if (face->GetCellType() == VTK_PIXEL)
    {
      std::swap(faces.back()[2], faces.back()[3]);
    }
  }
  return faces;
}

std::array<vtkIdType, 3> Sorted(std::array<vtkIdType, 3> triangle)
{
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}
}

bool CellShell::IsSupported(int type)
{
  switch (type)
  {
    case VTK_TETRA:
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
    case VTK_WEDGE:
    case VTK_PYRAMID:
    case VTK_PENTAGONAL_PRISM:
    case VTK_HEXAGONAL_PRISM:
    case VTK_POLYHEDRON:
      return true;
    default:
      return false;
  }
}

Error CellShell::Take(vtkDataSet* input, vtkIdType cell, const FaceTriangulation& triangulation,
  const std::vector<vtkIdType>& merged)
{
  std::vector<Face> faces = FacesOf(input, cell);
  std::vector<FaceTriangulation::Triangle> triangles;
  std::vector<int> faceOf;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    bool isMerged = false;
    for (vtkIdType& point : faces[f])
    {
      if (point < 0 || point >= input->GetNumberOfPoints())
      {
        return "it refers to point " + std::to_string(point) + ", which does not exist";
      }
      glm::dvec3 x;
      input->GetPoint(point, glm::value_ptr(x));
      if (!Vectors::IsFinite(x))
      {
        return "its point " + std::to_string(point) + " is not finite";
      }
      if (!merged.empty() && merged[point] != point)
      {
        isMerged = true;
        point = merged[point];
      }
    }
    const bool isCollapsed =
      isMerged && std::set<vtkIdType>(faces[f].begin(), faces[f].end()).size() < faces[f].size();
    const bool isSimple =
      triangulation.Triangulate(faces[f], triangles) == FaceTriangulation::Result::Simple;
    this->NumberOfFoldedFaces += isCollapsed || !isSimple ? 1 : 0;
    faceOf.resize(triangles.size(), static_cast<int>(f));
  }
  std::map<std::array<vtkIdType, 3>, int> counts;
  for (const auto& triangle : triangles)
  {
    ++counts[Sorted(triangle)];
  }
  for (std::size_t t = triangles.size(); t-- > 0;)
  {
    if (counts[Sorted(triangles[t])] > 1)
    {
      triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(t));
      faceOf.erase(faceOf.begin() + static_cast<std::ptrdiff_t>(t));
    }
  }
  for (const auto& triangle : triangles)
  {
    this->PointIds.insert(this->PointIds.end(), triangle.begin(), triangle.end());
  }
  std::sort(this->PointIds.begin(), this->PointIds.end(), triangulation.GetOrder());
  this->PointIds.erase(
    std::unique(this->PointIds.begin(), this->PointIds.end()), this->PointIds.end());
  std::map<vtkIdType, int> indices;
  for (vtkIdType point : this->PointIds)
  {
    indices.emplace(point, static_cast<int>(indices.size()));
    double x[3];
    input->GetPoint(point, x);
    this->Points.insert(this->Points.end(), x, x + 3);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const auto& points = triangles[t];
    this->Triangles.push_back(
      { { { indices[points[0]], indices[points[1]], indices[points[2]] } }, faceOf[t] });
  }
  return this->Orient();
}

Error CellShell::Orient()
{
  using Edge = std::array<int, 2>;
  std::map<Edge, std::vector<std::size_t>> triangles;
  const auto edgeOf = [this](std::size_t t, int i)
  {
    const auto& points = this->Triangles[t].Points;
    return Edge{ { points[i], points[(i + 1) % 3] } };
  };
  const auto key = [](const Edge& edge) {
    return Edge{ { std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) } };
  };
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      triangles[key(edgeOf(t, i))].push_back(t);
    }
  }
  for (const auto& edge : triangles)
  {
    if (edge.second.size() != 2)
    {
      return "its faces do not form a closed surface, because the number of triangles at the edge "
             "from point " +
        std::to_string(this->PointIds[edge.first[0]]) + " to point " +
        std::to_string(this->PointIds[edge.first[1]]) + " is " +
        std::to_string(edge.second.size()) + " instead of 2";
    }
  }
  // Traverse the surface, and flip triangles that are inconsistent with the previous triangle.
  std::vector<bool> isVisited(this->Triangles.size(), false);
  std::vector<std::size_t> stack;
  std::size_t numberOfVisited = 0;
  if (!this->Triangles.empty())
  {
    isVisited[0] = true;
    stack.push_back(0);
  }
  while (!stack.empty())
  {
    const std::size_t t = stack.back();
    stack.pop_back();
    ++numberOfVisited;
    for (int i = 0; i < 3; ++i)
    {
      const Edge edge = edgeOf(t, i);
      const auto& both = triangles[key(edge)];
      const std::size_t other = both[0] == t ? both[1] : both[0];
      const bool isInconsistent =
        edgeOf(other, 0) == edge || edgeOf(other, 1) == edge || edgeOf(other, 2) == edge;
      if (isInconsistent && isVisited[other])
      {
        return "its faces form a one-sided surface";
      }
      if (isInconsistent)
      {
        std::swap(this->Triangles[other].Points[1], this->Triangles[other].Points[2]);
      }
      if (!isVisited[other])
      {
        isVisited[other] = true;
        stack.push_back(other);
      }
    }
  }
  if (numberOfVisited != this->Triangles.size())
  {
    return "its faces form several parts that share no edge";
  }
  this->Volume = this->MeasureVolume();
  if (this->Volume < 0.0)
  {
    for (Triangle& triangle : this->Triangles)
    {
      std::swap(triangle.Points[1], triangle.Points[2]);
    }
    this->Volume = -this->Volume;
  }
  return {};
}

double CellShell::MeasureVolume() const
{
  double sum = 0.0;
  for (const Triangle& triangle : this->Triangles)
  {
    sum += Vectors::SixVolumes(this->GetPoint(0), this->GetPoint(triangle.Points[0]),
      this->GetPoint(triangle.Points[1]), this->GetPoint(triangle.Points[2]));
  }
  return sum / 6.0;
}

}
