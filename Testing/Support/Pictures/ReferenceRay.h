// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceRay_h
#define ReferenceRay_h

#include <array>    // for vectors
#include <optional> // for projections

class vtkCamera;

namespace reference
{

/// The geometry of the reference is in long double.
using Real = long double;
using Vector = std::array<Real, 3>;

inline Real Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/**
 * A line of sight.
 */
struct Ray
{
  /// The eye, or the point of the camera's plane in a parallel projection.
  Vector Origin;
  /// Of length 1.
  Vector Direction;
  /// Distance along the line for each unit of depth along the direction of projection.
  Real DistancePerDepth;
};

/**
 * @class   PixelRays
 * @brief   the lines of sight through the centres of a picture's pixels
 *
 * Pixel (i, j), counted from the lower left, has its centre at ((i + 1/2) / width, (j + 1/2) /
 * height) of the viewport; the line passes it by less than 1e-9 of a pixel, so that it lies in no
 * face that two tetrahedra share and both would count. The rays come from the camera's projection
 * matrix for the picture's aspect, and from its position and axes, so that nothing is lost far from
 * the origin.
 */
class PixelRays
{
public:
  PixelRays(vtkCamera* camera, const std::array<int, 2>& size);

  Ray Get(int i, int j) const;

  /// Depth of a point: its distance in front of the camera's plane.
  Real GetDepth(const Vector& point) const;
  /// Depth of the near plane.
  Real GetNear() const { return this->Near; }
  /// Depth of the far plane.
  Real GetFar() const { return this->Far; }
  /// Where a point is in the picture, in pixels; nothing for one at or behind the eye.
  std::optional<std::array<double, 2>> Project(const Vector& point) const;

private:
  Vector ToEye(const Vector& point) const;
  /// Where the line through the normalised position (x, y) passes the depth.
  Vector EyePoint(Real x, Real y, Real depth) const;

  std::array<int, 2> Size;
  Vector Position;
  std::array<Vector, 3> Axes;                ///< of the eye's coordinates, in the world
  std::array<std::array<Real, 4>, 4> Matrix; ///< from the eye to the clip coordinates
  Real Near;
  Real Far;
};

}

#endif
