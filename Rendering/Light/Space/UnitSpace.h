// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_UnitSpace_h
#define interlume_UnitSpace_h

#include "Common/Error.h"

#include <array>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

class vtkImageData;
class vtkMatrix4x4;

namespace interlume
{

/**
 * @class   UnitSpace
 * @brief   coordinates in which the volume fits in the unit sphere
 *
 * World coordinates are translated and scaled uniformly. The volume's corners then lie on or inside
 * the unit sphere around the origin: x_world = Center + Radius x_unit. Single precision is
 * therefore sufficient for any size and position of the volume. Volumes that are drawn together
 * share one sphere.
 *
 * Texture coordinates are 0 and 1 at the outer faces of the outermost texels, half a texel outside
 * their centers.
 */
class UnitSpace
{
public:
  /**
   * Sets the coordinates from the image's index-to-physical matrix and from \a worldFromVolume, the
   * matrix of the vtkVolume. If \a isOfCells is true, the samples are cell data. Returns an error
   * if a matrix is singular or not finite.
   */
  Error Set(vtkImageData* image, bool isOfCells, vtkMatrix4x4* worldFromVolume);

  /// Changes to another sphere, which several volumes share: x_world = \a center + \a radius
  /// x_unit.
  void MoveTo(const glm::dvec3& center, double radius);

  /// Returns, for each axis, the change in texture coordinate that moves a face of the box by \a
  /// margin along its normal in unit space.
  std::array<double, 3> GetMargins(double margin) const;

  /// Returns the number of texels along each axis that a vector in unit space crosses.
  glm::dvec3 GetTexels(const glm::dvec3& vector) const;

  glm::dvec3 ToUnit(const double world[3]) const;
  glm::dmat4 GetWorldFromUnit() const;
  glm::dmat4 GetUnitFromWorld() const;

  glm::dvec3 Center{ 0.0, 0.0, 0.0 };
  double Radius = 1.0;
  /// Number of texels along x, y, z.
  std::array<int, 3> Size{ { 0, 0, 0 } };
  /// Affine matrices between unit and texture coordinates.
  glm::dmat4 TextureFromUnit{ 0.0 };
  glm::dmat4 UnitFromTexture{ 0.0 };
  /// Matrix from texture coordinates to the volume's local coordinates, for cropping planes.
  glm::dmat4 VolumeFromTexture{ 0.0 };
  /// Lower and upper texture coordinate, along each axis, of the box that contains the medium.
  std::array<std::array<double, 2>, 3> Box{};

private:
  /// Sets Size and Box, and finds the image indices at texture coordinates of 0 and at the center.
  /// Returns false if there are no samples.
  bool SetTexelGrid(
    vtkImageData* image, bool isOfCells, glm::dvec3& firstIndex, glm::dvec3& centerIndex);
  void SetSphere(const glm::dmat4& worldFromTexture, const glm::dvec3& center);
};

}

#endif
