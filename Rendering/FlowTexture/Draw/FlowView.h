// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowView_h
#define interlume_FlowView_h

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
 * @class   FlowView
 * @brief   lines of sight through an image, in voxels, and the parts of them to be drawn
 *
 * All is found in double precision, relative to the plane through the middle of the volume, and
 * drawn in single precision from there. A line of sight of the viewport's place (x,y), -1 to 1, is
 * Origin + x OriginX + y OriginY + s (Direction + x DirectionX + y DirectionY).
 */
class FlowView
{
public:
  /// Computes all of it, cut by the planes and the cropping of \a mapper. Returns an error if a
  /// matrix or a clipping plane is not valid.
  Error Set(vtkRenderer* renderer, vtkImageData* image, vtkMatrix4x4* worldFromVolume,
    vtkVolumeMapper* mapper);

  bool IsParallel = false;
  glm::dvec3 Origin{ 0.0 };
  glm::dvec3 OriginX{ 0.0 };
  glm::dvec3 OriginY{ 0.0 };
  glm::dvec3 Direction{ 0.0 };
  glm::dvec3 DirectionX{ 0.0 };
  glm::dvec3 DirectionY{ 0.0 };
  /// The near and the far plane in lengths of Direction from the eye, or from the near plane of a
  /// parallel projection, and where s is 0.
  glm::dvec2 NearFar{ 0.0 };
  double Middle = 0.0;
  /// From voxels to world coordinates.
  glm::dmat4 WorldFromVoxels{ 1.0 };
  /// From voxels to the volume's own coordinates, for cropping planes.
  glm::dmat4 VolumeFromVoxels{ 1.0 };
  glm::dvec3 BoxLower{ 0.0 };
  glm::dvec3 BoxUpper{ 0.0 };
  /// Planes in voxels: what has a positive value is kept.
  std::vector<glm::dvec4> ClippingPlanes;
  /// The regions that cropping leaves, with gaps or without.
  CroppingRegions Regions;
  /// The smallest distance of neighbouring voxels, and the length of the diagonal, in world units.
  double Spacing = 1.0;
  double Diagonal = 1.0;

private:
  void SetRays(const glm::dmat4& voxelsFromClip, bool isParallel, const glm::dvec3& middle);
  Error SetClipping(vtkPlaneCollection* planes);
  void SetCropping(vtkVolumeMapper* mapper);
};

}

#endif
