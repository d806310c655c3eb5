// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowViewRays_h
#define interlume_FlowViewRays_h

#include "Common/Error.h"
#include "Offscreen/CroppingRegions.h"

#include <array>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

class vtkImageData;
class vtkMatrix4x4;
class vtkPlaneCollection;
class vtkRenderer;
class vtkVolumeMapper;

namespace interlume
{

/**
 * @class   FlowViewRays
 * @brief   view rays through an image in voxel coordinates, and the visible part of the image
 *
 * All members are computed in double precision. Distances along rays are relative to the plane
 * through the center of the volume, so that shaders can use single precision. The view ray at
 * viewport coordinates (x,y), -1 to 1, is Origin + x OriginX + y OriginY + s (Direction + x
 * DirectionX + y DirectionY).
 */
class FlowViewRays
{
public:
  /// Computes all members, with the clipping planes and cropping of \a mapper. Returns an error if
  /// a matrix or a clipping plane is invalid.
  Error Set(vtkRenderer* renderer, vtkImageData* image, vtkMatrix4x4* worldFromVolume,
    vtkVolumeMapper* mapper);

  bool IsParallel = false;
  glm::dvec3 Origin{ 0.0 };
  glm::dvec3 OriginX{ 0.0 };
  glm::dvec3 OriginY{ 0.0 };
  glm::dvec3 Direction{ 0.0 };
  glm::dvec3 DirectionX{ 0.0 };
  glm::dvec3 DirectionY{ 0.0 };
  /// Distances of the near and far planes, in multiples of Direction, from the camera or, in a
  /// parallel projection, from the near plane. s is 0 at the distance CenterDistance.
  glm::dvec2 NearFar{ 0.0 };
  double CenterDistance = 0.0;
  /// Matrix from voxel coordinates to world coordinates.
  glm::dmat4 WorldFromVoxels{ 1.0 };
  /// Matrix from voxel coordinates to the volume's local coordinates, for cropping planes.
  glm::dmat4 VolumeFromVoxels{ 1.0 };
  glm::dvec3 BoxLower{ 0.0 };
  glm::dvec3 BoxUpper{ 0.0 };
  /// Planes in voxel coordinates. The positive side is visible.
  std::vector<glm::dvec4> ClippingPlanes;
  /// The visible cropping regions.
  CroppingRegions Regions;
  /// Smallest voxel spacing and length of the volume's diagonal, in world units.
  double Spacing = 1.0;
  double Diagonal = 1.0;

private:
  void SetRays(const glm::dmat4& voxelsFromClip, bool isParallel, const glm::dvec3& centerVoxel);
  Error SetClipping(vtkPlaneCollection* planes);
  void SetCropping(vtkVolumeMapper* mapper);
};

}

#endif
