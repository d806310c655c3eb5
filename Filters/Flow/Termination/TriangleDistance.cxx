// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/TriangleDistance.h"

#include "vtkMath.h"

#include <cmath>
#include <limits>

namespace interlume
{

void TriangleDistance::Build(const TerminationTriangles* mesh, const TriangleEdges& edges)
{
  this->Mesh = mesh;
  const int number = static_cast<int>(mesh->Triangles.size());
  const Vector zero = { { 0.0, 0.0, 0.0 } };
  this->EdgeIds.resize(3 * static_cast<std::size_t>(number));
  this->FaceNormals.assign(number, zero);
  this->EdgeNormals.assign(edges.GetNumberOfEdges(), zero);
  this->VertexNormals.assign(mesh->Vertices.size(), zero);
  this->IsBorderEdge.assign(edges.GetNumberOfEdges(), false);
  this->IsBorderVertex.assign(mesh->Vertices.size(), false);
  std::vector<BoxTree::Box> boxes(number);
  for (int triangle = 0; triangle < number; ++triangle)
  {
    double sides[3][3];
    for (int i = 0; i < 3; ++i)
    {
      vtkMath::Subtract(
        mesh->GetCorner(triangle, (i + 1) % 3), mesh->GetCorner(triangle, i), sides[i]);
      vtkMath::Normalize(sides[i]);
    }
    double* normal = this->FaceNormals[triangle].data();
    vtkMath::Cross(sides[0], sides[1], normal);
    vtkMath::Normalize(normal);
    for (int i = 0; i < 3; ++i)
    {
      const int edge = edges.GetEdge(triangle, i);
      const int vertex = mesh->Triangles[triangle].Corners[i];
      const double* before = sides[(i + 2) % 3];
      const double angle = vtkMath::Pi() - vtkMath::AngleBetweenVectors(sides[i], before);
      this->EdgeIds[3 * triangle + i] = edge;
      for (int axis = 0; axis < 3; ++axis)
      {
        this->EdgeNormals[edge][axis] += normal[axis];
        this->VertexNormals[vertex][axis] += angle * normal[axis];
      }
      if (edges.IsBorder(edge))
      {
        this->IsBorderEdge[edge] = true;
        this->IsBorderVertex[vertex] = true;
        this->IsBorderVertex[mesh->Triangles[triangle].Corners[(i + 1) % 3]] = true;
      }
      boxes[triangle].Lower[i] = std::min({ mesh->GetCorner(triangle, 0)[i],
        mesh->GetCorner(triangle, 1)[i], mesh->GetCorner(triangle, 2)[i] });
      boxes[triangle].Upper[i] = std::max({ mesh->GetCorner(triangle, 0)[i],
        mesh->GetCorner(triangle, 1)[i], mesh->GetCorner(triangle, 2)[i] });
    }
  }
  for (auto* normals : { &this->EdgeNormals, &this->VertexNormals })
  {
    for (Vector& normal : *normals)
    {
      vtkMath::Normalize(normal.data());
    }
  }
  this->Tree.Build(boxes);
}

int TriangleDistance::FindNearest(const double x[3], ClosestTrianglePoint& foot) const
{
  int nearest = -1;
  this->Tree.VisitNear(x, std::numeric_limits<double>::infinity(),
    [this, x, &nearest, &foot](int item, double& squaredLimit)
    {
      const ClosestTrianglePoint candidate(x, this->Mesh->GetCorner(item, 0),
        this->Mesh->GetCorner(item, 1), this->Mesh->GetCorner(item, 2));
      if (candidate.SquaredDistance < squaredLimit)
      {
        squaredLimit = candidate.SquaredDistance;
        foot = candidate;
        nearest = item;
      }
    });
  return nearest;
}

const double* TriangleDistance::GetNormal(int triangle, const ClosestTrianglePoint& foot) const
{
  const double* normal = this->FaceNormals[triangle].data();
  const double* candidate = normal;
  if (foot.IsEdge())
  {
    const int edge = this->EdgeIds[3 * triangle + foot.Feature - ClosestTrianglePoint::FIRST_EDGE];
    candidate = this->EdgeNormals[edge].data();
  }
  else if (foot.IsCorner())
  {
    const int corner = foot.Feature - ClosestTrianglePoint::FIRST_CORNER;
    candidate = this->VertexNormals[this->Mesh->Triangles[triangle].Corners[corner]].data();
  }
  // Faces that are folded onto each other have no normal between them.
  return vtkMath::Norm(candidate) > 0.5 ? candidate : normal;
}

bool TriangleDistance::IsOnBorder(int triangle, const ClosestTrianglePoint& foot) const
{
  if (foot.IsEdge())
  {
    return this
      ->IsBorderEdge[this->EdgeIds[3 * triangle + foot.Feature - ClosestTrianglePoint::FIRST_EDGE]];
  }
  return foot.IsCorner() &&
    this->IsBorderVertex[this->Mesh->Triangles[triangle]
                           .Corners[foot.Feature - ClosestTrianglePoint::FIRST_CORNER]];
}

double TriangleDistance::GetSignedDistance(
  int triangle, const ClosestTrianglePoint& foot, const double x[3]) const
{
  double away[3];
  if (foot.Feature == ClosestTrianglePoint::FACE)
  {
    // Near the face this distance is exact, and smooth enough for finding roots.
    vtkMath::Subtract(x, this->Mesh->GetCorner(triangle, 0), away);
    return vtkMath::Dot(away, this->FaceNormals[triangle]);
  }
  vtkMath::Subtract(x, foot.Point, away);
  const double distance = std::sqrt(foot.SquaredDistance);
  return vtkMath::Dot(away, this->GetNormal(triangle, foot)) < 0.0 ? -distance : distance;
}

}
