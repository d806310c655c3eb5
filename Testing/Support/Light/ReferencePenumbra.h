// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferencePenumbra_h
#define ReferencePenumbra_h

#include "Common/Vectors.h"

#include <array>

#include <glm/vec2.hpp>

namespace reference
{

/**
 * @class   ReferencePenumbra
 * @brief   the exact shadow of a half plane in the light of a disc or rectangle
 *
 * The half plane z = Height, x < 0 is opaque. A point p below it sees the point y of a light above
 * it where the line between both passes x > 0 at that height, which is linear in y: the share of
 * the light that p sees is the part of a rectangle, or disc, on one side of a line. The light may
 * be tilted.
 */
struct ReferencePenumbra
{
  bool IsRound = true;
  /// The light's centre; of one that is not positional, the direction to it.
  glm::dvec3 Center{ 0.0, 0.0, 2.0 };
  bool IsPositional = true;
  /// The light's width and height as vectors; of one that is not positional, where the distance is
  /// the length of Center.
  std::array<glm::dvec3, 2> Axes{ glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0) };
  double Height = 1.0;

  /// Computes the share of the light that the point sees, 0 to 1.
  double GetShare(const glm::dvec3& point) const
  {
    const double rise = this->Height - point.z;
    // x at the half plane's height, times the height of y above the point.
    const auto pass = [&](const glm::dvec3& toLight)
    { return point.x * toLight.z + toLight.x * rise; };
    const double middle = pass(this->IsPositional ? this->Center - point : this->Center);
    const glm::dvec2 slope(0.5 * pass(this->Axes[0]), 0.5 * pass(this->Axes[1]));
    return this->IsRound ? GetDiscShare(middle, slope) : GetSquareShare(middle, slope);
  }

  /// Computes the penumbra of a parallel light at x from the shadow's edge of the light's centre: a
  /// ramp from 0 to 1 within \a width, which is L dZ / Z. For a square.
  static double GetRamp(double x, double width)
  {
    return std::min(std::max(x / width + 0.5, 0.0), 1.0);
  }

  /// Computes the same for a disc, the area of a segment of a circle.
  static double GetSegment(double x, double width)
  {
    return GetDiscShare(2.0 * x / width, { 1.0, 0.0 });
  }

private:
  // The part of the unit disc where middle + slope . y > 0.
  static double GetDiscShare(double middle, const glm::dvec2& slope)
  {
    const double length = std::hypot(slope.x, slope.y);
    if (std::abs(middle) >= length)
    {
      return middle > 0.0 ? 1.0 : 0.0;
    }
    const double t = middle / length;
    return 0.5 + (std::asin(t) + t * std::sqrt(1.0 - t * t)) / std::acos(-1.0);
  }

  // The part of the square from -1 to 1 where middle + slope . y > 0: the sum of two independent
  // even spreads is a trapezoid.
  static double GetSquareShare(double middle, const glm::dvec2& slope)
  {
    const double wide = std::max(std::abs(slope.x), std::abs(slope.y));
    const double narrow = std::min(std::abs(slope.x), std::abs(slope.y));
    const double t = std::abs(middle);
    double share = 1.0;
    if (t <= wide - narrow)
    {
      share = wide > 0.0 ? 0.5 + 0.5 * t / wide : 0.5;
    }
    else if (t < wide + narrow)
    {
      const double rest = wide + narrow - t;
      share = 1.0 - rest * rest / (8.0 * wide * narrow);
    }
    return middle < 0.0 ? 1.0 - share : share;
  }
};

}

#endif
