#include "Volumes/LevelSetNormals.h"

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
using Vector = std::array<double, 3>;

void Add(Vector& sum, const Vector& vector, double factor)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    sum[axis] += factor * vector[axis];
  }
}

Vector Cross(const Vector& a, const Vector& b)
{
  Vector product;
  vtkMath::Cross(a.data(), b.data(), product.data());
  return product;
}

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
  // By point of the mesh, its number among those of the triangles, or -1; and the other way round.
  std::vector<vtkIdType> Places;
  std::vector<vtkIdType> Points;
  // By that number, where the tetrahedra begin.
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

// The gradient in a tetrahedron times six times its volume.
Vector GetWeightedGradient(const Vector corners[4], const double values[4])
{
  Vector edges[3];
  for (int e = 0; e < 3; ++e)
  {
    edges[e] = corners[e + 1];
    Add(edges[e], corners[0], -1.0);
  }
  Vector sum{};
  for (int e = 0; e < 3; ++e)
  {
    Add(sum, Cross(edges[(e + 1) % 3], edges[(e + 2) % 3]), values[e + 1] - values[0]);
  }
  const double determinant = vtkMath::Dot(edges[0].data(), Cross(edges[1], edges[2]).data());
  Vector gradient{};
  Add(gradient, sum, determinant < 0.0 ? -1.0 : 1.0);
  return gradient;
}
}

vtkSmartPointer<vtkFloatArray> LevelSetNormals::Compute(vtkUnstructuredGrid* mesh,
  vtkDataArray* function, const std::vector<SurfaceTriangles::Triangle>& triangles)
{
  const Neighborhoods around(mesh, triangles);
  vtkPoints* points = mesh->GetPoints();
  const auto getPoint = [points](vtkIdType p)
  {
    Vector x;
    points->GetPoint(p, x.data());
    return x;
  };
  std::vector<Vector> normals(around.Points.size(), Vector{});
  vtkSMPTools::For(0, static_cast<vtkIdType>(normals.size()),
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType place = first; place < last; ++place)
      {
        for (vtkIdType i = around.Firsts[place]; i < around.Firsts[place + 1]; ++i)
        {
          Vector corners[4];
          double values[4];
          for (int corner = 0; corner < 4; ++corner)
          {
            const vtkIdType p = around.Simplices.Get(around.Tetrahedra[i], corner);
            corners[corner] = getPoint(p);
            values[corner] = function->GetComponent(p, 0);
          }
          Add(normals[place], GetWeightedGradient(corners, values), -1.0);
        }
      }
    });
  const auto isZero = [](const Vector& vector) { return vtkMath::Norm(vector.data()) == 0.0; };
  if (std::any_of(normals.begin(), normals.end(), isZero))
  {
    std::vector<Vector> ofTriangles(normals.size(), Vector{});
    for (const auto& triangle : triangles)
    {
      Vector edges[2] = { getPoint(triangle[1]), getPoint(triangle[2]) };
      Add(edges[0], getPoint(triangle[0]), -1.0);
      Add(edges[1], getPoint(triangle[0]), -1.0);
      for (const vtkIdType p : triangle)
      {
        Add(ofTriangles[around.Places[p]], Cross(edges[0], edges[1]), 1.0);
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
    vtkMath::Normalize(normals[place].data());
    array->SetTuple(around.Points[place], normals[place].data());
  }
  return array;
}

}
