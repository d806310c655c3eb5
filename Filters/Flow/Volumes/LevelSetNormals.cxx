// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/LevelSetNormals.h"

#include "Common/Vectors.h"
#include "Volumes/SimplexPoints.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace interlume
{

namespace
{
// Tetrahedra around the points of triangles.
class Neighborhoods
{
public:
  Neighborhoods(vtkUnstructuredGrid* mesh, const std::vector<SurfaceTriangles::Triangle>& triangles)
    : Simplices(mesh, 4)
    , Places(mesh->GetNumberOfPoints(), -1)
  {
    for (const auto& triangle : triangles)
    {
      for (const vtkIdType p : triangle)
      {
        this->Places[p] = 0;
      }
    }
    for (std::size_t p = 0; p < this->Places.size(); ++p)
    {
      if (this->Places[p] == 0)
      {
        this->Places[p] = static_cast<vtkIdType>(this->Points.size());
        this->Points.push_back(static_cast<vtkIdType>(p));
      }
    }
    this->Firsts.assign(this->Points.size() + 1, 0);
    this->ForEachUse([this](vtkIdType place, vtkIdType) { ++this->Firsts[place]; });
    vtkIdType sum = 0;
    for (vtkIdType& first : this->Firsts)
    {
      sum += std::exchange(first, sum);
    }
    this->Tetrahedra.resize(sum);
    std::vector<vtkIdType> next(this->Firsts);
    this->ForEachUse([&](vtkIdType place, vtkIdType tetrahedron)
      { this->Tetrahedra[next[place]++] = tetrahedron; });
  }

  SimplexPoints Simplices;
  // The number of each point of the mesh among those of the triangles, or -1; and the other way
  // round.
  std::vector<vtkIdType> Places;
  std::vector<vtkIdType> Points;
  // The place where the tetrahedra of a point begin, by that number.
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
        const vtkIdType place = this->Places[this->Simplices.Get(t, corner)];
        if (place >= 0)
        {
          visit(place, t);
        }
      }
    }
  }
};

// Returns the gradient in a tetrahedron, which is positively oriented, times six times its volume.
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
  vtkSMPTools::For(0, static_cast<vtkIdType>(normals.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType place = first; place < last; ++place)
      {
        for (vtkIdType i = around.Firsts[place]; i < around.Firsts[place + 1]; ++i)
        {
          glm::dvec3 corners[4];
          double values[4];
          for (int corner = 0; corner < 4; ++corner)
          {
            const vtkIdType p = around.Simplices.Get(around.Tetrahedra[i], corner);
            corners[corner] = getPoint(p);
            values[corner] = function->GetComponent(p, 0);
          }
          normals[place] -= GetWeightedGradient(corners, values);
        }
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
        ofTriangles[around.Places[p]] += normal;
      }
    }
    for (std::size_t place = 0; place < normals.size(); ++place)
    {
      normals[place] = isZero(normals[place]) ? ofTriangles[place] : normals[place];
    }
  }
  vtkSmartPointer<vtkFloatArray> array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(mesh->GetNumberOfPoints());
  array->Fill(0.0);
  for (std::size_t place = 0; place < normals.size(); ++place)
  {
    vtkMath::Normalize(glm::value_ptr(normals[place]));
    array->SetTuple(around.Points[place], glm::value_ptr(normals[place]));
  }
  return array;
}

}
