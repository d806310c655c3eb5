// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferencePenumbra_h
#define ReferencePenumbra_h

#include "Common/Vectors.h"

#include <array>

#include <glm/vec2.hpp>

namespace reference
{

/**
 * @struct  ReferencePenumbra
 * @brief   exact shadow that a half-plane casts in the light of a disk or rectangle
 *
 * The half-plane z = Height, x < 0 is opaque. A point p below the half-plane sees a point y of a
 * light above it if the line between them crosses the plane z = Height at x > 0. This condition is
 * linear in y, so the visible fraction of the light is the fraction of a rectangle or disk on one
 * side of a line. The light may be tilted.
 */
struct ReferencePenumbra
{
  bool IsRound = true;
  /// Center of the light, or direction to the light if the light is directional.
  glm::dvec3 Center{ 0.0, 0.0, 2.0 };
  bool IsPositional = true;
  /// Width and height of the light as vectors. For a directional light, they apply at the distance
  /// |Center|.
  std::array<glm::dvec3, 2> Axes{ glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0) };
  double Height = 1.0;

  /// Returns the fraction of the light that is visible from the point, 0 to 1.
  double GetLightFraction(const glm::dvec3& point) const
  {
    const double rise = this->Height - point.z;
    // The x-coordinate where the line from the point to y crosses z = Height, multiplied by the
    // height of y above the point.
    const auto pass = [&](const glm::dvec3& toLight)
    { return point.x * toLight.z + toLight.x * rise; };
    const double midpoint = pass(this->IsPositional ? this->Center - point : this->Center);
    const glm::dvec2 slope(0.5 * pass(this->Axes[0]), 0.5 * pass(this->Axes[1]));
    return this->IsRound ? GetDiskFraction(midpoint, slope) : GetSquareFraction(midpoint, slope);
  }

  /// Returns the visible fraction of a square directional light, which is a ramp from 0 to 1 over
  /// the penumbra. The penumbra has \a width L dZ / Z, where L is the edge length of the light, Z
  /// its distance, and dZ the distance of the receiver from the half-plane. \a x is the distance
  /// from the shadow edge that the center of the light alone would cast.
  static double GetRamp(double x, double width)
  {
    return std::min(std::max(x / width + 0.5, 0.0), 1.0);
  }

  /// Like GetRamp(), for a disk light: the relative area of a circular segment.
  static double GetDiskLightFraction(double x, double width)
  {
    return GetDiskFraction(2.0 * x / width, { 1.0, 0.0 });
  }

private:
  // Returns the fraction of the unit disk where midpoint + slope . y > 0.
  static double GetDiskFraction(double midpoint, const glm::dvec2& slope)
  {
    const double length = std::hypot(slope.x, slope.y);
    if (std::abs(midpoint) >= length)
    {
      return midpoint > 0.0 ? 1.0 : 0.0;
    }
    const double t = midpoint / length;
    return 0.5 + (std::asin(t) + t * std::sqrt(1.0 - t * t)) / std::acos(-1.0);
  }

  // Returns the fraction of the square [-1, 1]^2 where midpoint + slope . y > 0. The sum of two
  // independent uniform variables has a trapezoidal distribution.
  static double GetSquareFraction(double midpoint, const glm::dvec2& slope)
  {
    const double larger = std::max(std::abs(slope.x), std::abs(slope.y));
    const double smaller = std::min(std::abs(slope.x), std::abs(slope.y));
    const double t = std::abs(midpoint);
    double fraction = 1.0;
    if (t <= larger - smaller)
    {
      fraction = larger > 0.0 ? 0.5 + 0.5 * t / larger : 0.5;
    }
    else if (t < larger + smaller)
    {
      const double rest = larger + smaller - t;
      fraction = 1.0 - rest * rest / (8.0 * larger * smaller);
    }
    return midpoint < 0.0 ? 1.0 - fraction : fraction;
  }
};

}

#endif
