// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/LevelSetNormals.h"

#include "Common/ParallelFor.h"
#include "Common/Vectors.h"
#include "Volumes/SimplexPoints.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace interlume
{

namespace
{
// Tetrahedra around each point of the triangles.
class Neighborhoods
{
public:
  Neighborhoods(vtkUnstructuredGrid* mesh, const std::vector<SurfaceTriangles::Triangle>& triangles)
    : Simplices(mesh, 4)
    , Indices(mesh->GetNumberOfPoints(), -1)
  {
    for (const auto& triangle : triangles)
    {
      for (const vtkIdType p : triangle)
      {
        this->Indices[p] = 0;
      }
    }
    for (std::size_t p = 0; p < this->Indices.size(); ++p)
    {
      if (this->Indices[p] == 0)
      {
        this->Indices[p] = static_cast<vtkIdType>(this->Points.size());
        this->Points.push_back(static_cast<vtkIdType>(p));
      }
    }
    this->Firsts.assign(this->Points.size() + 1, 0);
    this->ForEachUse([this](vtkIdType index, vtkIdType) { ++this->Firsts[index]; });
    vtkIdType sum = 0;
    for (vtkIdType& first : this->Firsts)
    {
      sum += std::exchange(first, sum);
    }
    this->Tetrahedra.resize(sum);
    std::vector<vtkIdType> next(this->Firsts);
    this->ForEachUse([&](vtkIdType index, vtkIdType tetrahedron)
      { this->Tetrahedra[next[index]++] = tetrahedron; });
  }

  SimplexPoints Simplices;
  // Index of each mesh point in Points, or -1 if no triangle uses it. Points is the inverse map.
  std::vector<vtkIdType> Indices;
  std::vector<vtkIdType> Points;
  // Index in Tetrahedra of the first tetrahedron around each point.
  std::vector<vtkIdType> Firsts;
  std::vector<vtkIdType> Tetrahedra;

private:
  template <typename Visitor>
  void ForEachUse(Visitor&& visit) const
  {
    for (vtkIdType t = 0; t < this->Simplices.GetNumber(); ++t)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        const vtkIdType index = this->Indices[this->Simplices.Get(t, corner)];
        if (index >= 0)
        {
          visit(index, t);
        }
      }
    }
  }
};

// Returns the gradient in a positively oriented tetrahedron, multiplied by six times its volume.
glm::dvec3 GetWeightedGradient(const glm::dvec3 corners[4], const double values[4])
{
  glm::dvec3 edges[3];
  for (int e = 0; e < 3; ++e)
  {
    edges[e] = corners[e + 1] - corners[0];
  }
  glm::dvec3 sum{};
  for (int e = 0; e < 3; ++e)
  {
    sum += (values[e + 1] - values[0]) * glm::cross(edges[(e + 1) % 3], edges[(e + 2) % 3]);
  }
  return sum;
}
}

vtkSmartPointer<vtkFloatArray> LevelSetNormals::Compute(vtkUnstructuredGrid* mesh,
  vtkDataArray* function, const std::vector<SurfaceTriangles::Triangle>& triangles)
{
  const Neighborhoods around(mesh, triangles);
  vtkPoints* points = mesh->GetPoints();
  const auto getPoint = [points](vtkIdType p)
  {
    glm::dvec3 x;
    points->GetPoint(p, glm::value_ptr(x));
    return x;
  };
  std::vector<glm::dvec3> normals(around.Points.size(), glm::dvec3{});
  ParallelFor(0, static_cast<vtkIdType>(normals.size()),
    [&](vtkIdType index)
    {
      for (vtkIdType i = around.Firsts[index]; i < around.Firsts[index + 1]; ++i)
      {
        glm::dvec3 corners[4];
        double values[4];
        for (int corner = 0; corner < 4; ++corner)
        {
          const vtkIdType p = around.Simplices.Get(around.Tetrahedra[i], corner);
          corners[corner] = getPoint(p);
          values[corner] = function->GetComponent(p, 0);
        }
        normals[index] -= GetWeightedGradient(corners, values);
      }
    });
  const auto isZero = [](const glm::dvec3& vector) { return glm::length(vector) == 0.0; };
  if (std::any_of(normals.begin(), normals.end(), isZero))
  {
    std::vector<glm::dvec3> ofTriangles(normals.size(), glm::dvec3{});
    for (const auto& triangle : triangles)
    {
      const glm::dvec3 origin = getPoint(triangle[0]);
      const glm::dvec3 normal =
        glm::cross(getPoint(triangle[1]) - origin, getPoint(triangle[2]) - origin);
      for (const vtkIdType p : triangle)
      {
        ofTriangles[around.Indices[p]] += normal;
      }
    }
    for (std::size_t index = 0; index < normals.size(); ++index)
    {
      normals[index] = isZero(normals[index]) ? ofTriangles[index] : normals[index];
    }
  }
  vtkSmartPointer<vtkFloatArray> array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  array->Fill(0.0);
  for (std::size_t index = 0; index < normals.size(); ++index)
  {
    vtkMath::Normalize(glm::value_ptr(normals[index]));
    array->SetTuple(around.Points[index], glm::value_ptr(normals[index]));
  }
  return array;
}

}
