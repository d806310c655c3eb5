// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/FlowViewRays.h"

#include "Common/Vectors.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

namespace interlume
{

namespace
{
glm::dmat4 FromRows(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}
}

Error FlowViewRays::Set(vtkRenderer* renderer, vtkImageData* image, vtkMatrix4x4* worldFromVolume,
  vtkVolumeMapper* mapper)
{
  *this = FlowViewRays();
  int dimensions[3];
  int extent[6];
  image->GetDimensions(dimensions);
  image->GetExtent(extent);
  this->BoxUpper = glm::dvec3(dimensions[0], dimensions[1], dimensions[2]) - 1.0;
  const glm::dmat4 first(glm::dvec4(1.0, 0.0, 0.0, 0.0), glm::dvec4(0.0, 1.0, 0.0, 0.0),
    glm::dvec4(0.0, 0.0, 1.0, 0.0), glm::dvec4(extent[0], extent[2], extent[4], 1.0));
  this->VolumeFromVoxels = FromRows(image->GetIndexToPhysicalMatrix()) * first;
  this->WorldFromVoxels = FromRows(worldFromVolume) * this->VolumeFromVoxels;
  const glm::dmat3 axes(this->WorldFromVoxels);
  const double size = glm::determinant(axes);
  if (!(std::abs(size) > 0.0) || !std::isfinite(size))
  {
    return "The matrix from voxel to world coordinates is singular or not finite. Check the "
           "image's spacing and direction matrix and the volume's matrix.";
  }
  this->Spacing = std::min({ glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) });
  this->Diagonal = glm::length(axes * this->BoxUpper);
  // Compute relative to the volume's center, to keep precision if the volume is far from the world
  // origin.
  const glm::dvec3 centerVoxel = 0.5 * this->BoxUpper;
  const glm::dvec3 center = glm::dvec3(this->WorldFromVoxels * glm::dvec4(centerVoxel, 1.0));
  glm::dmat4 fromCenter(1.0);
  fromCenter[3] = glm::dvec4(center, 1.0);
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 clipFromCenter =
    FromRows(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)) *
    (FromRows(camera->GetModelViewTransformMatrix()) * fromCenter);
  const glm::dmat3 voxelsFromWorld = glm::inverse(axes);
  const glm::dmat4 voxelsFromClip = glm::dmat4(voxelsFromWorld) * glm::inverse(clipFromCenter);
  this->SetRays(voxelsFromClip, camera->GetParallelProjection() != 0, centerVoxel);
  if (!Vectors::IsFinite(this->Origin) || !Vectors::IsFinite(this->Direction))
  {
    return "The camera matrix is not finite. Check the camera's position, focal point and clipping "
           "range.";
  }
  if (mapper->GetCropping())
  {
    this->SetCropping(mapper);
  }
  return this->SetClipping(mapper->GetClippingPlanes());
}

void FlowViewRays::SetRays(
  const glm::dmat4& voxelsFromClip, bool isParallel, const glm::dvec3& centerVoxel)
{
  this->IsParallel = isParallel;
  const glm::dvec4& inward = voxelsFromClip[2];
  if (isParallel)
  {
    // Rays run from the near plane to the far plane.
    const double w = voxelsFromClip[3].w;
    const glm::dvec4 near = voxelsFromClip[3] - inward;
    this->Direction = 2.0 * glm::dvec3(inward) / w;
    this->Origin = glm::dvec3(near) / w;
    this->OriginX = glm::dvec3(voxelsFromClip[0]) / w;
    this->OriginY = glm::dvec3(voxelsFromClip[1]) / w;
    this->NearFar = { 0.0, 1.0 };
  }
  else
  {
    // `inward` is the camera position in homogeneous coordinates. Points on a view ray differ by
    // multiples of it.
    const glm::dvec3 eye = glm::dvec3(inward) / inward.w;
    const auto direct = [&eye](const glm::dvec4& point)
    { return glm::dvec3(point) - eye * point.w; };
    this->Direction = direct(voxelsFromClip[3]);
    this->DirectionX = direct(voxelsFromClip[0]);
    this->DirectionY = direct(voxelsFromClip[1]);
    this->Origin = eye;
    const double w = voxelsFromClip[3].w;
    this->NearFar = { 1.0 / (w - inward.w), 1.0 / (w + inward.w) };
  }
  const double distance =
    -glm::dot(this->Origin, this->Direction) / glm::dot(this->Direction, this->Direction);
  this->CenterDistance = std::max(distance, this->NearFar[0]);
  this->Origin += this->CenterDistance * this->Direction + centerVoxel;
  this->OriginX += this->CenterDistance * this->DirectionX;
  this->OriginY += this->CenterDistance * this->DirectionY;
}

Error FlowViewRays::SetClipping(vtkPlaneCollection* planes)
{
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    vtkPlane* plane = planes->GetItem(i);
    const glm::dvec3 given = glm::make_vec3(plane->GetNormal());
    const double length = glm::length(given);
    if (!(length > 0.0) || !std::isfinite(length))
    {
      return "The normal of clipping plane " + std::to_string(i) +
        " is zero or not finite. Set a valid normal.";
    }
    const glm::dvec3 normal = given / length;
    const glm::dvec3 start =
      glm::dvec3(this->WorldFromVoxels[3]) - glm::make_vec3(plane->GetOrigin());
    this->ClippingPlanes.emplace_back(
      normal * glm::dmat3(this->WorldFromVoxels), glm::dot(normal, start));
  }
  return {};
}

void FlowViewRays::SetCropping(vtkVolumeMapper* mapper)
{
  const glm::dmat4 rows = glm::transpose(this->VolumeFromVoxels);
  CroppingRegions::Matrix toVolume;
  std::copy_n(glm::value_ptr(rows), 16, toVolume.begin());
  std::array<double, 6> cropping;
  mapper->GetCroppingRegionPlanes(cropping.data());
  this->Regions = CroppingRegions(cropping, mapper->GetCroppingRegionFlags(), toVolume);
  CroppingRegions::Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    box[axis] = { { this->BoxLower[axis], this->BoxUpper[axis] } };
  }
  CroppingRegions::Planes planes;
  this->Regions.Cut(toVolume, box, planes);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->BoxLower[axis] = box[axis][0];
    this->BoxUpper[axis] = box[axis][1];
  }
  for (const std::array<double, 4>& plane : planes)
  {
    this->ClippingPlanes.push_back(glm::make_vec4(plane.data()));
  }
}

}
