// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedraView_h
#define interlume_TetrahedraView_h

#include "Common/Error.h"
#include "Common/Vectors.h"
#include "Mesh/TetrahedraMesh.h"
#include "View/ViewRays.h"

#include <array>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

class vtkRenderer;
class vtkVolume;

namespace interlume
{

/**
 * @class   TetrahedraView
 * @brief   projects mesh coordinates to pixels and depths
 *
 * Depth d is 1/z in perspective and -z in parallel projection, where z is the distance along the
 * view axis. Larger depths are closer. On every face of a tetrahedron, d is then affine in pixel
 * coordinates. For an attribute v, the product v d is affine in perspective, and v itself is affine
 * in parallel projection. Lengths are in units of GetUnit(), the world length of one unit of mesh
 * coordinates.
 *
 * The eye is the point where all view rays meet. The eye and the axes of eye coordinates are
 * derived only from the matrix from world to clip coordinates, because stereo, view shear, off-axis
 * projection and the camera's user transforms move the eye or scale view coordinates. Eye
 * coordinates preserve the shape of objects in the world.
 */
class TetrahedraView
{
public:
  struct Projected
  {
    /// Position in pixels; the first pixel's center is at (0.5, 0.5).
    double X;
    double Y;
    double Depth;
  };

  /**
   * Reads the camera and the volume's matrix. One image pixel covers \a stride viewport pixels in x
   * and in y. Returns an error if a matrix is singular or not finite.
   */
  Error Set(vtkRenderer* renderer, vtkVolume* volume, const TetrahedraMesh& mesh, int stride);

  /**
   * Returns the eye in homogeneous volume coordinates with w >= 0. In parallel projection it is the
   * point at infinity where the view rays originate.
   */
  static std::array<double, 4> FindEye(vtkRenderer* renderer, vtkVolume* volume);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  bool IsParallel() const { return this->Parallel; }
  /// Returns the world length of one unit of mesh coordinates.
  double GetUnit() const { return this->Unit; }

  /// Returns the eye coordinates of a point in mesh coordinates, in units of GetUnit(). The view
  /// direction is -z.
  glm::dvec3 GetEyeCoordinates(const double* point) const
  {
    glm::dvec3 eye;
    for (int i = 0; i < 3; ++i)
    {
      const double* row = &this->EyeFromMesh[4 * i];
      eye[i] = row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3];
    }
    return eye;
  }
  /// Returns eye coordinates of a world point (w = 1) or direction (w = 0).
  glm::dvec3 GetEyeFromWorld(const glm::dvec4& point) const
  {
    return { glm::dot(this->EyeFromWorld[0], point), glm::dot(this->EyeFromWorld[1], point),
      glm::dot(this->EyeFromWorld[2], point) };
  }
  /// Projects a point in eye coordinates. The near plane must not cut it off.
  Projected Project(const glm::dvec3& eye) const
  {
    const double depth = this->Parallel ? eye[2] : -1.0 / eye[2];
    const double weight = this->Parallel ? 1.0 : depth;
    return { (this->ScaleX * eye[0] + this->SkewX * eye[1] + this->ShiftX * eye[2]) * weight +
        this->OffsetX,
      (this->ScaleY * eye[1] + this->ShiftY * eye[2]) * weight + this->OffsetY, depth };
  }
  /// Returns the eye coordinates of the point at a pixel position and depth.
  glm::dvec3 GetEyeCoordinates(double x, double y, double depth) const
  {
    const double z = this->Parallel ? depth : -1.0 / depth;
    const double weight = this->Parallel ? 1.0 : depth;
    const double up = ((y - this->OffsetY) / weight - this->ShiftY * z) / this->ScaleY;
    return { ((x - this->OffsetX) / weight - this->SkewX * up - this->ShiftX * z) / this->ScaleX,
      up, z };
  }

  ///@{
  /// Return planes in mesh coordinates with unit normals. Points p with dot(plane, (p, 1)) < 0 are
  /// cut off: in front of the near plane, behind the far plane, or on the negative side of a plane
  /// given in world coordinates.
  const glm::dvec4& GetNearPlane() const { return this->NearPlane; }
  const glm::dvec4& GetFarPlane() const { return this->FarPlane; }
  glm::dvec4 GetPlane(const double* normal, const double* origin) const;
  ///@}

  /// Returns the ratio of the length of a view ray segment at a pixel to its length along the view
  /// axis.
  double GetViewRayLengthRatio(double x, double y) const;

  /// Returns the coefficients c that convert a depth buffer value b in [0, 1] at pixel position (x,
  /// y) to the depth c[0] + c[1] b + c[2] x + c[3] y. c[2] and c[3] are 0 unless the camera's user
  /// transform tilts depths.
  const glm::dvec4& GetDepthFromBuffer() const { return this->DepthOfBuffer; }
  double GetDepthFromBuffer(double x, double y, double value) const
  {
    return glm::dot(this->DepthOfBuffer, glm::dvec4(1.0, value, x, y));
  }
  /// Converts a depth at a pixel position to a depth buffer value, the inverse of
  /// GetDepthFromBuffer().
  double GetBufferFromDepth(double x, double y, double depth) const
  {
    return (depth - this->GetDepthFromBuffer(x, y, 0.0)) / this->DepthOfBuffer[1];
  }

  /// Returns the view rays of the pixels in mesh coordinates.
  ViewRays GetRays() const;

  /// Returns the matrix from mesh to eye coordinates, with three rows of four elements.
  const std::array<double, 12>& GetEyeFromMesh() const { return this->EyeFromMesh; }
  /// Returns the matrix from mesh coordinates to pixel x, pixel y and eye z, with three rows of
  /// four elements. Pixel x and y are not yet multiplied by depth or shifted by GetPixelOffset().
  std::array<double, 12> GetPixelsFromMesh() const;
  glm::dvec2 GetPixelOffset() const { return { this->OffsetX, this->OffsetY }; }
  /// Returns coefficients for the eye coordinates x and y of the point on a pixel's view ray where
  /// eye z is -1 in perspective and 0 in parallel projection. x and y are the dot products of their
  /// coefficients with (pixel x, pixel y, 1).
  std::array<glm::dvec3, 2> GetEyeFromPixels() const;
  /// Returns the change of eye x and eye y per unit of depth along a view ray, in parallel
  /// projection.
  glm::dvec2 GetTilt() const;

  bool operator==(const TetrahedraView& other) const;
  bool operator!=(const TetrahedraView& other) const { return !(*this == other); }

private:
  struct Axes;
  /// Sets the members that depend on the camera. The matrices \a world and \a mesh transform world
  /// and mesh coordinates to clip coordinates; world[i] and mesh[i] are their rows. Returns an
  /// error if a matrix is singular or not finite.
  Error SetEye(glm::dmat4 world, glm::dmat4 mesh, const glm::dvec3& camera,
    const std::array<double, 2>& halfSize);

  int Width = 0;
  int Height = 0;
  bool Parallel = false;
  double Unit = 1.0;
  std::array<double, 12> EyeFromMesh{};
  /// Rows of the matrices from mesh to world and from world to eye coordinates.
  glm::dmat4 WorldFromMesh{ 1.0 };
  std::array<glm::dvec4, 3> EyeFromWorld{};
  double ScaleX = 1.0;
  double SkewX = 0.0;
  double ShiftX = 0.0;
  double OffsetX = 0.0;
  double ScaleY = 1.0;
  double ShiftY = 0.0;
  double OffsetY = 0.0;
  glm::dvec4 NearPlane{};
  glm::dvec4 FarPlane{};
  glm::dvec4 DepthOfBuffer{};
};

}

#endif
