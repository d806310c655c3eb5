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
 * @brief   coordinates of size 1 around the volume
 *
 * World coordinates are moved and scaled alike in all directions so that the volume's corners lie
 * on or in the sphere of radius 1 around 0: x_world = Center + Radius x_unit. Whatever the volume's
 * size and place, single precision suffices from there. Volumes that are drawn together share one
 * sphere. Texture coordinates are 0 to 1 over the
 * texels, whose centres are half a texel inside.
 */
class UnitSpace
{
public:
  /**
   * Sets the coordinates from the image's index-to-physical matrix and \a worldFromVolume, the
   * matrix of the vtkVolume; \a isOfCells tells that the samples are those of cells. Returns an
   * error if a matrix is singular or not finite.
   */
  Error Set(vtkImageData* image, bool isOfCells, vtkMatrix4x4* worldFromVolume);

  /// Moves to another sphere, which several volumes share: from now on x_world = \a center +
  /// \a radius x_unit.
  void MoveTo(const glm::dvec3& center, double radius);

  /// Returns how far borders along each axis move in texture coordinates to move by \a margin
  /// across their faces.
  std::array<double, 3> GetMargins(double margin) const;

  /// Returns the texels along each axis that a vector in unit space passes.
  glm::dvec3 GetTexels(const glm::dvec3& vector) const;

  glm::dvec3 ToUnit(const double world[3]) const;
  glm::dmat4 GetWorldFromUnit() const;
  glm::dmat4 GetUnitFromWorld() const;

  glm::dvec3 Center{ 0.0, 0.0, 0.0 };
  double Radius = 1.0;
  /// The number of texels along x, y, z.
  std::array<int, 3> Size{ { 0, 0, 0 } };
  /// Affine matrices between unit and texture coordinates.
  glm::dmat4 TextureFromUnit{ 0.0 };
  glm::dmat4 UnitFromTexture{ 0.0 };
  /// The matrix from texture coordinates to the volume's own, for cropping planes.
  glm::dmat4 VolumeFromTexture{ 0.0 };
  /// The box that has matter, in texture coordinates: lower and upper of each axis.
  std::array<std::array<double, 2>, 3> Box{};

private:
  /// Sets Size and Box and finds the indices of texture coordinates 0 and of the middle. Returns
  /// whether there are samples.
  bool SetTexels(
    vtkImageData* image, bool isOfCells, glm::dvec3& firstIndex, glm::dvec3& middleIndex);
  void SetSphere(const glm::dmat4& worldFromTexture, const glm::dvec3& center);
};

}

#endif
