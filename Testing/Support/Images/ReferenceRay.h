// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceRay_h
#define ReferenceRay_h

#include <array>    // for vectors
#include <optional> // for projections

class vtkCamera;

namespace reference
{

/// Number type of geometric computations.
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
  /// Position of the camera or, for a parallel projection, a point on the plane through the camera.
  Vector Origin;
  /// Unit vector.
  Vector Direction;
  /// Distance along the ray per unit of depth along the direction of projection.
  Real DistancePerDepth;
};

/**
 * @class   PixelRays
 * @brief   view rays through the pixel centers of an image
 *
 * Pixel (i, j), counted from the lower left, has its center at ((i + 1/2) / width, (j + 1/2) /
 * height) in normalized viewport coordinates. Rays are offset by less than 1e-9 of a pixel, so that
 * no ray lies in a common face of two tetrahedra and is counted in both. They are computed from the
 * camera's projection matrix, position and axes. Therefore, no precision is lost far from the
 * origin.
 */
class PixelRays
{
public:
  PixelRays(vtkCamera* camera, const std::array<int, 2>& size);

  Ray Get(int i, int j) const;

  /// Returns the depth of a point: its distance from the camera along the direction of projection.
  Real GetDepth(const Vector& point) const;
  Real GetNear() const { return this->Near; }
  Real GetFar() const { return this->Far; }
  /// Returns the pixel coordinates of a point, or std::nullopt if it is at or behind the camera.
  std::optional<std::array<double, 2>> Project(const Vector& point) const;

private:
  Vector ToEye(const Vector& point) const;
  /// Returns the point, in view coordinates, at \a depth on the ray through (x, y) in normalized
  /// device coordinates.
  Vector GetPointAtDepth(Real x, Real y, Real depth) const;

  std::array<int, 2> Size;
  Vector Position;
  std::array<Vector, 3> Axes;                ///< axes of view coordinates in world coordinates
  std::array<std::array<Real, 4>, 4> Matrix; ///< from view to clip coordinates
  Real Near;
  Real Far;
};

}

#endif
