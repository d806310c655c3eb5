// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightFrame_h
#define interlume_LightFrame_h

#include "Space/UnitVector.h"

namespace interlume
{

/**
 * @class   LightFrame
 * @brief   orthonormal frame of a light: forward, right and up
 */
struct LightFrame
{
  glm::dvec3 Origin{ 0.0, 0.0, 0.0 };
  /// The light direction, right and up: perpendicular unit vectors, with right = forward x up.
  glm::dvec3 Forward{ 0.0, 0.0, -1.0 };
  glm::dvec3 Right{ 1.0, 0.0, 0.0 };
  glm::dvec3 Up{ 0.0, 1.0, 0.0 };
  /// Distance from the position to the focal point.
  double Distance = 1.0;

  /**
   * Computes the frame. If \a viewUp is parallel to the axis or 0, another direction is used.
   * Returns false if the position and the focal point coincide or are not finite.
   */
  bool Set(const double position[3], const double focalPoint[3], const double viewUp[3])
  {
    this->Origin = glm::make_vec3(position);
    const glm::dvec3 axis = glm::make_vec3(focalPoint) - this->Origin;
    this->Distance = Vectors::SafeLength(axis);
    if (!(this->Distance > 0.0) || !std::isfinite(this->Distance))
    {
      return false;
    }
    this->Forward = UnitVector::Normalize(axis, axis);
    this->Up = UnitVector::Perpendicular(
      this->Forward, UnitVector::Normalize(glm::make_vec3(viewUp), { 0.0, 1.0, 0.0 }));
    this->Right = glm::cross(this->Forward, this->Up);
    return true;
  }

  /// Sets the view-up vector of a light, if \a up is finite. Returns true if it has changed.
  static bool SetViewUp(double (&viewUp)[3], const glm::dvec3& up)
  {
    if (!IsFinite(up) || glm::make_vec3(viewUp) == up)
    {
      return false;
    }
    std::copy_n(glm::value_ptr(up), 3, viewUp);
    return true;
  }
  static bool IsFinite(const glm::dvec3& up)
  {
    return std::isfinite(up.x) && std::isfinite(up.y) && std::isfinite(up.z);
  }
};

}

#endif
