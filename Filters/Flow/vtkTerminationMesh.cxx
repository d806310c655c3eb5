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
// Distance from the mesh, as a fraction of its diagonal, above which a sign change of the distance
// is a jump, not a crossing.
constexpr double JumpDistance = 1e-6;
}

struct vtkTerminationMesh::Contents
{
  interlume::TerminationTriangles Triangles;
  interlume::TriangleEdges Edges;
  interlume::TriangleDistance Distance;
  interlume::TextureSearch Texture;
  /// Rounding error of the points' positions.
  double Rounding = 0.0;

  /// Triangle nearest to a position. Positions are scaled like the vertices.
  struct Nearest
  {
    glm::dvec3 Position;
    /// Index of the triangle; -1 if the mesh is empty.
    int Triangle;
    interlume::ClosestTrianglePoint Foot;
  };
  Nearest FindNearest(const double x[3]) const
  {
    Nearest nearest;
    nearest.Position = this->Triangles.Scale * glm::make_vec3(x);
    nearest.Triangle = this->Distance.FindNearest(nearest.Position, nearest.Foot);
    return nearest;
  }

  // Returns false if the position is past an open boundary by more than \a tolerance, a fraction of
  // the mesh's diagonal.
  bool IsWithinBorder(const Nearest& nearest, double tolerance) const
  {
    if (!this->Distance.IsOnBorder(nearest.Triangle, nearest.Foot))
    {
      return true;
    }
    const glm::dvec3& normal = this->Distance.GetNormal(nearest.Triangle, nearest.Foot);
    const glm::dvec3 offset = nearest.Position - nearest.Foot.Point;
    return glm::length(offset - glm::dot(offset, normal) * normal) <=
      tolerance * this->Triangles.Diagonal;
  }
};

vtkTerminationMesh::vtkTerminationMesh()
  : Prepared(new Contents)
{
}

vtkTerminationMesh::~vtkTerminationMesh() = default;

vtkCxxSetSmartPointerMacro(vtkTerminationMesh, Mesh, vtkPolyData);

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
  return static_cast<vtkIdType>(this->Prepared->Triangles.Triangles.size());
}

vtkIdType vtkTerminationMesh::GetNumberOfDegenerateTriangles() const
{
  return this->Prepared->Triangles.NumberOfDegenerateTriangles;
}

vtkIdType vtkTerminationMesh::GetNumberOfBorderEdges() const
{
  return this->Prepared->Edges.NumberOfBorderEdges;
}

vtkIdType vtkTerminationMesh::GetNumberOfBranchingEdges() const
{
  return this->Prepared->Edges.NumberOfBranchingEdges;
}

std::string vtkTerminationMesh::Update()
{
  if (this->UpdateTime > this->GetMTime())
  {
    return {};
  }
  this->Prepared.reset(new Contents);
  if (!this->Mesh)
  {
    return "no mesh is set";
  }
  const bool isPeriodic[2] = { this->PeriodicU, this->PeriodicV };
  std::unique_ptr<Contents> prepared(new Contents);
  if (const interlume::Error error =
        prepared->Triangles.Take(this->Mesh, this->Tolerance, isPeriodic))
  {
    return error.GetMessage();
  }
  prepared->Edges.Connect(prepared->Triangles);
  if (const interlume::Error error = prepared->Edges.Orient(prepared->Triangles))
  {
    return error.GetMessage();
  }
  prepared->Distance.Build(&prepared->Triangles, prepared->Edges);
  prepared->Texture.Build(&prepared->Triangles, isPeriodic);
  if (this->Mesh->GetPoints()->GetDataType() == VTK_FLOAT)
  {
    for (const double bound : prepared->Triangles.Bounds)
    {
      prepared->Rounding = std::max(prepared->Rounding, FLT_EPSILON * std::abs(bound));
    }
  }
  this->Prepared = std::move(prepared);
  this->UpdateTime.Modified();
  return {};
}

double vtkTerminationMesh::EvaluateDistance(const double x[3]) const
{
  const Contents::Nearest nearest = this->Prepared->FindNearest(x);
  return nearest.Triangle < 0
    ? VTK_DOUBLE_MAX
    : this->Prepared->Distance.GetSignedDistance(nearest.Triangle, nearest.Foot, nearest.Position) /
      this->Prepared->Triangles.Scale;
}

bool vtkTerminationMesh::IsOn(const double x[3]) const
{
  const Contents::Nearest nearest = this->Prepared->FindNearest(x);
  return nearest.Triangle >= 0 &&
    std::sqrt(nearest.Foot.SquaredDistance) <= JumpDistance * this->Prepared->Triangles.Diagonal &&
    this->Prepared->IsWithinBorder(nearest, this->Tolerance);
}

bool vtkTerminationMesh::ProjectsOntoSurface(const double x[3]) const
{
  const Contents::Nearest nearest = this->Prepared->FindNearest(x);
  return nearest.Triangle >= 0 && this->Prepared->IsWithinBorder(nearest, this->Tolerance);
}

void vtkTerminationMesh::EvaluateParameters(const double x[3], double uv[2]) const
{
  std::fill_n(uv, 2, 0.0);
  const Contents::Nearest nearest = this->Prepared->FindNearest(x);
  for (int i = 0; i < 2 && nearest.Triangle >= 0; ++i)
  {
    const auto& texture = this->Prepared->Triangles.Triangles[nearest.Triangle].Texture;
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
  const Contents::Nearest nearest = this->Prepared->FindNearest(x);
  const glm::dvec3 outward = nearest.Triangle < 0
    ? glm::dvec3(0.0, 0.0, 1.0)
    : this->Prepared->Distance.GetNormal(nearest.Triangle, nearest.Foot);
  std::copy_n(glm::value_ptr(outward), 3, normal);
}

bool vtkTerminationMesh::EvaluatePoint(int part, const double uv[2], double x[3]) const
{
  double taken[2];
  return this->NormalizeParameters(part, uv, taken) && this->Prepared->Texture.FindPoint(taken, x);
}

double vtkTerminationMesh::EvaluateGap(const double x[3]) const
{
  const Contents::Nearest nearest = this->Prepared->FindNearest(x);
  return nearest.Triangle < 0
    ? VTK_DOUBLE_MAX
    : std::max(0.0,
        std::sqrt(nearest.Foot.SquaredDistance) / this->Prepared->Triangles.Scale -
          this->Prepared->Rounding);
}

bool vtkTerminationMesh::IsPeriodic(int direction, int) const
{
  return direction == 0 ? this->PeriodicU : this->PeriodicV;
}

void vtkTerminationMesh::GetBounds(double bounds[6]) const
{
  vtkMath::UninitializeBounds(bounds);
  if (!this->Prepared->Triangles.Triangles.empty())
  {
    std::copy_n(this->Prepared->Triangles.Bounds, 6, bounds);
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
