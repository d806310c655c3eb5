// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_AxialFrame_h
#define interlume_AxialFrame_h

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   AxialFrame
 * @brief   an axis and two perpendicular directions X and Y, orthonormal and right-handed
 */
struct AxialFrame
{
  glm::dvec3 X{ 1.0, 0.0, 0.0 };
  glm::dvec3 Y{ 0.0, 1.0, 0.0 };
  glm::dvec3 Axis{ 0.0, 0.0, 1.0 };

  /// Sets an axis of any nonzero length. X and Y are computed as in T. Duff et al., "Building an
  /// orthonormal basis, revisited", JCGT 6(1), 2017. If the axis is z, they are x and y.
  void SetAxis(const glm::dvec3& axis);

  /// Sets an axis and a perpendicular X, both of length 1.
  void SetAxis(const glm::dvec3& axis, const glm::dvec3& x);

  /// Returns the components of \a x - \a origin along X, Y and the axis.
  glm::dvec3 GetComponents(const glm::dvec3& x, const glm::dvec3& origin) const;

  /// Returns a X + b Y + c Axis.
  glm::dvec3 GetVector(double a, double b, double c) const;

  /// Returns the angle of vector (x, y) from X toward Y in turns, in [0,1); 0 for a zero vector.
  static double GetAngleInTurns(double x, double y);
};

}

#endif
