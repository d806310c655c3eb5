// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceRay_h
#define ReferenceRay_h

#include <array>    // for vectors
#include <optional> // for projections

class vtkCamera;

namespace reference
{

/// Geometry is computed in long double.
using Real = long double;
using Vector = std::array<Real, 3>;

inline Real Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/**
 * A view ray.
 */
struct Ray
{
  /// Position of the camera, or a point on the camera's plane in a parallel projection.
  Vector Origin;
  /// Direction of the ray, of length 1.
  Vector Direction;
  /// Distance along the ray per unit of depth along the direction of projection.
  Real DistancePerDepth;
};

/**
 * @class   PixelRays
 * @brief   view rays through the pixel centers of an image
 *
 * Pixel (i, j), counted from the lower left, has its center at ((i + 1/2) / width, (j + 1/2) /
 * height) of the viewport. Rays are offset by less than 1e-9 of a pixel, so that no ray lies in a
 * common face of two tetrahedra and is counted in both. Rays are computed from the camera's
 * projection matrix, position and axes. Precision is therefore not lost far from the origin.
 */
class PixelRays
{
public:
  PixelRays(vtkCamera* camera, const std::array<int, 2>& size);

  Ray Get(int i, int j) const;

  /// Returns the depth of a point, which is its distance in front of the camera's plane.
  Real GetDepth(const Vector& point) const;
  Real GetNear() const { return this->Near; }
  Real GetFar() const { return this->Far; }
  /// Returns the pixel coordinates of a point, or std::nullopt if it is at or behind the camera.
  std::optional<std::array<double, 2>> Project(const Vector& point) const;

private:
  Vector ToEye(const Vector& point) const;
  /// Returns the point at \a depth on the ray through the normalized position (x, y), in view
  /// coordinates.
  Vector EyePoint(Real x, Real y, Real depth) const;

  std::array<int, 2> Size;
  Vector Position;
  std::array<Vector, 3> Axes;                ///< axes of view coordinates in world coordinates
  std::array<std::array<Real, 4>, 4> Matrix; ///< from view to clip coordinates
  Real Near;
  Real Far;
};

}

#endif
