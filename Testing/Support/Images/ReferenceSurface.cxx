// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceSurface.h"

#include "Support/Arrays/ReferenceIndices.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTriangleFilter.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace reference
{

namespace
{

/// Hits of a ray are merged if they are closer together than this fraction of the surface's size.
constexpr double SameDistance = 1e-12;

Double3 Times(const double color[3], double factor)
{
  return { { factor * color[0], factor * color[1], factor * color[2] } };
}

glm::dvec3 GetPoint(vtkPolyData* mesh, vtkIdType point, vtkMatrix4x4* matrix)
{
  double x[4] = { 0.0, 0.0, 0.0, 1.0 };
  mesh->GetPoint(point, x);
  matrix->MultiplyPoint(x, x);
  return glm::make_vec3(x) / x[3];
}

/// Normals transform with the transposed inverse of the matrix that transforms points.
glm::dmat3 GetNormalMatrix(vtkMatrix4x4* matrix)
{
  glm::dmat3 linear;
  for (const auto& [row, column] : AllIndices(3, 3))
  {
    linear[column][row] = matrix->GetElement(row, column);
  }
  return glm::transpose(glm::inverse(linear));
}

}

ReferenceSurface::ReferenceSurface(const SceneSurface& surface)
  : Color(surface.Color)
{
  vtkActor* actor = surface.Actor;
  vtkMapper* mapper = actor->GetMapper();
  vtkProperty* property = actor->GetProperty();
  mapper->GetInputAlgorithm()->Update();
  if (actor->GetTexture() || property->GetInterpolation() == VTK_PBR ||
    (!this->Color && mapper->MapScalars(1.0)))
  {
    throw std::invalid_argument(
      "textures, color mapping of scalars and physically based shading are not supported");
  }
  this->Ambient = Times(property->GetAmbientColor(), property->GetAmbient());
  this->Diffuse = Times(property->GetDiffuseColor(), property->GetDiffuse());
  this->Specular = Times(property->GetSpecularColor(), property->GetSpecular());
  if (this->Color)
  {
    this->Ambient.fill(property->GetAmbient());
    this->Diffuse.fill(property->GetDiffuse());
  }
  this->SpecularPower = property->GetSpecularPower();
  this->Opacity = property->GetOpacity();
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    this->Planes.emplace_back(planes->GetItem(i));
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputDataObject(mapper->GetInputDataObject(0, 0));
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  this->Append(
    triangles->GetOutput(), actor->GetMatrix(), property->GetInterpolation() != VTK_FLAT);
  double bounds[6];
  actor->GetBounds(bounds);
  this->Size = std::sqrt(std::pow(bounds[1] - bounds[0], 2) + std::pow(bounds[3] - bounds[2], 2) +
    std::pow(bounds[5] - bounds[4], 2));
}

void ReferenceSurface::Append(vtkPolyData* mesh, vtkMatrix4x4* worldFromMesh, bool withNormals)
{
  vtkDataArray* normals = withNormals ? mesh->GetPointData()->GetNormals() : nullptr;
  const glm::dmat3 normalMatrix = GetNormalMatrix(worldFromMesh);
  std::vector<TriangleTree::Triangle> triangles;
  auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCurrentCell(size, points);
    TriangleTree::Triangle triangle;
    for (int corner = 0; corner < 3; ++corner)
    {
      triangle[corner] = GetPoint(mesh, points[corner], worldFromMesh);
      if (normals)
      {
        double normal[3];
        normals->GetTuple(points[corner], normal);
        this->Normals.push_back(glm::normalize(normalMatrix * glm::make_vec3(normal)));
      }
    }
    triangles.push_back(triangle);
  }
  // A mirroring matrix reverses the orientation of triangles, but point normals stay on the same
  // side.
  this->IsMirrored = worldFromMesh->Determinant() < 0.0;
  this->Tree.Build(std::move(triangles));
}

bool ReferenceSurface::IsClipped(const Double3& world) const
{
  for (const auto& plane : this->Planes)
  {
    Double3 x = world;
    if (plane->EvaluateFunction(x.data()) < 0.0)
    {
      return true;
    }
  }
  return false;
}

void ReferenceSurface::AppendHits(const Double3& origin, const Double3& direction, double begin,
  double end, std::vector<Hit>& hits) const
{
  const auto first = static_cast<std::ptrdiff_t>(hits.size());
  this->Tree.Visit(glm::make_vec3(origin.data()), glm::make_vec3(direction.data()), begin, end,
    [&](const Hit& hit)
    {
      if (!this->IsClipped({ { origin[0] + hit.Distance * direction[0],
            origin[1] + hit.Distance * direction[1], origin[2] + hit.Distance * direction[2] } }))
      {
        hits.push_back(hit);
      }
      return true;
    });
  std::sort(hits.begin() + first, hits.end(),
    [](const Hit& a, const Hit& b)
    { return std::tie(a.Distance, a.Triangle) < std::tie(b.Distance, b.Triangle); });
  // A ray through an edge hits both triangles that share it.
  const double same = SameDistance * this->Size;
  hits.erase(std::unique(hits.begin() + first, hits.end(),
               [same](const Hit& a, const Hit& b) { return b.Distance - a.Distance < same; }),
    hits.end());
}

double ReferenceSurface::GetTransmittance(
  const Double3& origin, const Double3& direction, double begin, double end) const
{
  std::vector<Hit> hits;
  this->AppendHits(origin, direction, begin, end, hits);
  return std::pow(1.0 - this->Opacity, static_cast<double>(hits.size()));
}

Double3 ReferenceSurface::GetNormal(const Hit& hit, const Double3& direction) const
{
  const TriangleTree::Triangle& corners = this->Tree.Get(hit.Triangle);
  glm::dvec3 face = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  face = this->IsMirrored ? -face : face;
  glm::dvec3 normal = face;
  if (!this->Normals.empty())
  {
    const glm::dvec3* normals = &this->Normals[3 * static_cast<std::size_t>(hit.Triangle)];
    normal = (1.0 - hit.Weights[0] - hit.Weights[1]) * normals[0] + hit.Weights[0] * normals[1] +
      hit.Weights[1] * normals[2];
  }
  const bool isBack = glm::dot(face, glm::make_vec3(direction.data())) > 0.0;
  normal = glm::normalize(isBack ? -normal : normal);
  return { { normal.x, normal.y, normal.z } };
}

Double3 ReferenceSurface::Shade(const Hit& hit, const Double3& world, const Double3& direction,
  const std::vector<ReferenceLightSource::Arrival>& arrivals) const
{
  const Double3 normal = this->GetNormal(hit, direction);
  const Double3 color = this->Color ? this->Color(world) : Double3{ { 1.0, 1.0, 1.0 } };
  Double3 reflected;
  for (int k = 0; k < 3; ++k)
  {
    reflected[k] = this->Ambient[k] * color[k];
  }
  for (const ReferenceLightSource::Arrival& light : arrivals)
  {
    const double cosine = vtkMath::Dot(normal.data(), light.ToLight.data());
    if (!(cosine > 0.0))
    {
      continue;
    }
    const double towardCamera = vtkMath::Dot(light.ToLight.data(), direction.data()) -
      2.0 * cosine * vtkMath::Dot(normal.data(), direction.data());
    const double glint = std::pow(std::max(towardCamera, 0.0), this->SpecularPower);
    for (int k = 0; k < 3; ++k)
    {
      reflected[k] += this->Diffuse[k] * color[k] * cosine * light.Diffuse[k] +
        this->Specular[k] * glint * light.Specular[k];
    }
  }
  return reflected;
}

}
