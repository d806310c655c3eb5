// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightFrame_h
#define interlume_LightFrame_h

#include "Space/UnitVector.h"

namespace interlume
{

/**
 * @class   LightFrame
 * @brief   the directions of a light that has an up: its axis, and right and up across it
 */
struct LightFrame
{
  glm::dvec3 Origin{ 0.0, 0.0, 0.0 };
  /// Where the light goes, right and up; of length 1 and perpendicular, right = forward x up.
  glm::dvec3 Forward{ 0.0, 0.0, -1.0 };
  glm::dvec3 Right{ 1.0, 0.0, 0.0 };
  glm::dvec3 Up{ 0.0, 1.0, 0.0 };
  /// The distance from position to focal point.
  double Distance = 1.0;

  /**
   * Computes the frame; where \a viewUp is along the axis or has no length another up is taken.
   * Returns false where position and focal point are the same or not finite.
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

  /// Sets the up of a light. Returns whether it is another now: one that is
  /// not finite changes nothing.
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
