// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTerminationMesh.h"

#include "Common/Error.h"
#include "Common/NamedValue.h"
#include "Common/Vectors.h"
#include "Termination/TerminationTriangles.h"
#include "Termination/TextureSearch.h"
#include "Termination/TriangleDistance.h"
#include "Termination/TriangleEdges.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

vtkStandardNewMacro(vtkTerminationMesh);

namespace
{
// The share of the diagonal beyond which, away from the mesh, a change of sign is a jump and no
// crossing.
constexpr double Nearness = 1e-6;
}

struct vtkTerminationMesh::Contents
{
  interlume::TerminationTriangles Triangles;
  interlume::TriangleEdges Edges;
  interlume::TriangleDistance Distance;
  interlume::TextureSearch Texture;
  /// The error that rounding may have made in the positions of points.
  double Rounding = 0.0;

  /// What is nearest to a place, in the units of the triangles' vertices.
  struct Nearest
  {
    glm::dvec3 Place;
    /// -1 without any.
    int Triangle;
    interlume::ClosestTrianglePoint Foot;
  };
  Nearest FindNearest(const double x[3]) const
  {
    Nearest nearest;
    nearest.Place = this->Triangles.Scale * glm::make_vec3(x);
    nearest.Triangle = this->Distance.FindNearest(nearest.Place, nearest.Foot);
    return nearest;
  }

  // Returns whether the place is not beyond an open border by more than the tolerance.
  bool IsWithinBorder(const Nearest& nearest, double tolerance) const
  {
    if (!this->Distance.IsOnBorder(nearest.Triangle, nearest.Foot))
    {
      return true;
    }
    const glm::dvec3& normal = this->Distance.GetNormal(nearest.Triangle, nearest.Foot);
    const glm::dvec3 beyond = nearest.Place - nearest.Foot.Point;
    return glm::length(beyond - glm::dot(beyond, normal) * normal) <=
      tolerance * this->Triangles.Diagonal;
  }
};

vtkTerminationMesh::vtkTerminationMesh()
  : Made(new Contents)
{
}

vtkTerminationMesh::~vtkTerminationMesh() = default;

void vtkTerminationMesh::SetMesh(vtkPolyData* mesh)
{
  if (this->Mesh != mesh)
  {
    this->Mesh = mesh;
    this->Modified();
  }
}

vtkPolyData* vtkTerminationMesh::GetMesh() const
{
  return this->Mesh;
}

void vtkTerminationMesh::SetTolerance(double tolerance)
{
  const double clamped = std::max(1e-15, std::min(tolerance, 0.1));
  if (!std::isnan(tolerance) && this->Tolerance != clamped)
  {
    this->Tolerance = clamped;
    this->Modified();
  }
}

vtkMTimeType vtkTerminationMesh::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Mesh ? std::max(own, this->Mesh->GetMTime()) : own;
}

vtkIdType vtkTerminationMesh::GetNumberOfTriangles() const
{
  return static_cast<vtkIdType>(this->Made->Triangles.Triangles.size());
}

vtkIdType vtkTerminationMesh::GetNumberOfDegenerateTriangles() const
{
  return this->Made->Triangles.NumberOfDegenerateTriangles;
}

vtkIdType vtkTerminationMesh::GetNumberOfBorderEdges() const
{
  return this->Made->Edges.NumberOfBorderEdges;
}

vtkIdType vtkTerminationMesh::GetNumberOfBranchingEdges() const
{
  return this->Made->Edges.NumberOfBranchingEdges;
}

std::string vtkTerminationMesh::Update()
{
  if (this->UpdateTime > this->GetMTime())
  {
    return {};
  }
  this->Made.reset(new Contents);
  if (!this->Mesh)
  {
    return "the mesh has no dataset";
  }
  const bool isPeriodic[2] = { this->PeriodicU, this->PeriodicV };
  std::unique_ptr<Contents> made(new Contents);
  if (const interlume::Error error = made->Triangles.Take(this->Mesh, this->Tolerance, isPeriodic))
  {
    return error.GetMessage();
  }
  made->Edges.Connect(made->Triangles);
  if (const interlume::Error error = made->Edges.Orient(made->Triangles))
  {
    return error.GetMessage();
  }
  made->Distance.Build(&made->Triangles, made->Edges);
  made->Texture.Build(&made->Triangles, isPeriodic);
  if (this->Mesh->GetPoints()->GetDataType() == VTK_FLOAT)
  {
    for (const double bound : made->Triangles.Bounds)
    {
      made->Rounding = std::max(made->Rounding, FLT_EPSILON * std::abs(bound));
    }
  }
  this->Made = std::move(made);
  this->UpdateTime.Modified();
  return {};
}

double vtkTerminationMesh::EvaluateDistance(const double x[3]) const
{
  const Contents::Nearest nearest = this->Made->FindNearest(x);
  return nearest.Triangle < 0
    ? VTK_DOUBLE_MAX
    : this->Made->Distance.GetSignedDistance(nearest.Triangle, nearest.Foot, nearest.Place) /
      this->Made->Triangles.Scale;
}

bool vtkTerminationMesh::IsOn(const double x[3]) const
{
  const Contents::Nearest nearest = this->Made->FindNearest(x);
  return nearest.Triangle >= 0 &&
    std::sqrt(nearest.Foot.SquaredDistance) <= Nearness * this->Made->Triangles.Diagonal &&
    this->Made->IsWithinBorder(nearest, this->Tolerance);
}

bool vtkTerminationMesh::IsBeside(const double x[3]) const
{
  const Contents::Nearest nearest = this->Made->FindNearest(x);
  return nearest.Triangle >= 0 && this->Made->IsWithinBorder(nearest, this->Tolerance);
}

void vtkTerminationMesh::EvaluateParameters(const double x[3], double uv[2]) const
{
  std::fill_n(uv, 2, 0.0);
  const Contents::Nearest nearest = this->Made->FindNearest(x);
  for (int i = 0; i < 2 && nearest.Triangle >= 0; ++i)
  {
    const auto& texture = this->Made->Triangles.Triangles[nearest.Triangle].Texture;
    const glm::dvec3& weights = nearest.Foot.Weights;
    uv[i] = weights[0] * texture[0][i] + weights[1] * texture[1][i] + weights[2] * texture[2][i];
    if (this->IsPeriodic(i))
    {
      uv[i] -= std::floor(uv[i]);
      uv[i] = uv[i] < 1.0 ? uv[i] : 0.0;
    }
  }
}

void vtkTerminationMesh::EvaluateNormal(const double x[3], double normal[3]) const
{
  const Contents::Nearest nearest = this->Made->FindNearest(x);
  const glm::dvec3 outward = nearest.Triangle < 0
    ? glm::dvec3(0.0, 0.0, 1.0)
    : this->Made->Distance.GetNormal(nearest.Triangle, nearest.Foot);
  std::copy_n(glm::value_ptr(outward), 3, normal);
}

bool vtkTerminationMesh::EvaluatePoint(int part, const double uv[2], double x[3]) const
{
  double taken[2];
  return this->TakeParameters(part, uv, taken) && this->Made->Texture.FindPoint(taken, x);
}

double vtkTerminationMesh::EvaluateGap(const double x[3]) const
{
  const Contents::Nearest nearest = this->Made->FindNearest(x);
  return nearest.Triangle < 0
    ? VTK_DOUBLE_MAX
    : std::max(0.0,
        std::sqrt(nearest.Foot.SquaredDistance) / this->Made->Triangles.Scale -
          this->Made->Rounding);
}

bool vtkTerminationMesh::IsPeriodic(int direction, int) const
{
  return direction == 0 ? this->PeriodicU : this->PeriodicV;
}

void vtkTerminationMesh::GetBounds(double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  if (!this->Made->Triangles.Triangles.empty())
  {
    std::copy_n(this->Made->Triangles.Bounds, 6, bounds);
  }
}

void vtkTerminationMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  interlume::NamedValue::Print(os, indent,
    { { "Mesh", this->Mesh.GetPointer() }, { "PeriodicU", this->PeriodicU },
      { "PeriodicV", this->PeriodicV }, { "Tolerance", this->Tolerance },
      { "Triangles", this->GetNumberOfTriangles() },
      { "DegenerateTriangles", this->GetNumberOfDegenerateTriangles() },
      { "BorderEdges", this->GetNumberOfBorderEdges() },
      { "BranchingEdges", this->GetNumberOfBranchingEdges() } });
}
