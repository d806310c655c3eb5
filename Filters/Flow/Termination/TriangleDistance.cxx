// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/TriangleDistance.h"

#include "Common/Vectors.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace interlume
{

namespace
{
glm::dvec3 Normalize(const glm::dvec3& v)
{
  const double length = glm::length(v);
  return length > 0.0 ? v / length : v;
}
}

void TriangleDistance::Build(const TerminationTriangles* mesh, const TriangleEdges& edges)
{
  this->Mesh = mesh;
  const int number = static_cast<int>(mesh->Triangles.size());
  const glm::dvec3 zero(0.0);
  this->EdgeIds.resize(3 * static_cast<std::size_t>(number));
  this->FaceNormals.assign(number, zero);
  this->EdgeNormals.assign(edges.GetNumberOfEdges(), zero);
  this->VertexNormals.assign(mesh->Vertices.size(), zero);
  this->IsBorderEdge.assign(edges.GetNumberOfEdges(), false);
  this->IsBorderVertex.assign(mesh->Vertices.size(), false);
  std::vector<BoxTree::Box> boxes(number);
  for (int triangle = 0; triangle < number; ++triangle)
  {
    glm::dvec3 sides[3];
    for (int i = 0; i < 3; ++i)
    {
      sides[i] = Normalize(mesh->GetCorner(triangle, (i + 1) % 3) - mesh->GetCorner(triangle, i));
    }
    const glm::dvec3 normal = Normalize(glm::cross(sides[0], sides[1]));
    this->FaceNormals[triangle] = normal;
    for (int i = 0; i < 3; ++i)
    {
      const int edge = edges.GetEdge(triangle, i);
      const int vertex = mesh->Triangles[triangle].Corners[i];
      const glm::dvec3& before = sides[(i + 2) % 3];
      const double angle = vtkMath::Pi() -
        vtkMath::AngleBetweenVectors(glm::value_ptr(sides[i]), glm::value_ptr(before));
      this->EdgeIds[3 * triangle + i] = edge;
      this->EdgeNormals[edge] += normal;
      this->VertexNormals[vertex] += angle * normal;
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
    std::transform(normals->begin(), normals->end(), normals->begin(), Normalize);
  }
  this->Tree.Build(boxes);
}

int TriangleDistance::FindNearest(const glm::dvec3& x, ClosestTrianglePoint& foot) const
{
  int nearest = -1;
  this->Tree.VisitNear(glm::value_ptr(x), std::numeric_limits<double>::infinity(),
    [this, &x, &nearest, &foot](int item, double& squaredLimit)
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

const glm::dvec3& TriangleDistance::GetNormal(int triangle, const ClosestTrianglePoint& foot) const
{
  const glm::dvec3& normal = this->FaceNormals[triangle];
  const glm::dvec3* candidate = &normal;
  if (foot.IsEdge())
  {
    const int edge = this->EdgeIds[3 * triangle + foot.Feature - ClosestTrianglePoint::FIRST_EDGE];
    candidate = &this->EdgeNormals[edge];
  }
  else if (foot.IsCorner())
  {
    const int corner = foot.Feature - ClosestTrianglePoint::FIRST_CORNER;
    candidate = &this->VertexNormals[this->Mesh->Triangles[triangle].Corners[corner]];
  }
  // Faces folded onto each other have no common normal. Use the face normal.
  return glm::length(*candidate) > 0.5 ? *candidate : normal;
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
  int triangle, const ClosestTrianglePoint& foot, const glm::dvec3& x) const
{
  if (foot.Feature == ClosestTrianglePoint::FACE)
  {
    // Close to the face, the distance from its plane is more accurate than the square root of
    // SquaredDistance. It is also smooth enough for root finding.
    return glm::dot(x - this->Mesh->GetCorner(triangle, 0), this->FaceNormals[triangle]);
  }
  const double distance = std::sqrt(foot.SquaredDistance);
  return glm::dot(x - foot.Point, this->GetNormal(triangle, foot)) < 0.0 ? -distance : distance;
}

}
