// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceNormal_h
#define interlume_SliceNormal_h

#include "Space/UnitVector.h"

#include <vector>

namespace interlume
{

/**
 * @class   SliceNormal
 * @brief   finds a direction that makes small enough angles with a set of rays
 *
 * Each ray d_k has a required minimum cosine c_k with the normal. The best unit normal n maximizes
 * the ratio m = min d_k.n / c_k. All rays have the required cosines if m >= 1. By duality, the best
 * normal points to the point of the convex hull of all d_k / c_k that is closest to the origin, and
 * m is the distance of this point.
 */
class SliceNormal
{
public:
  /// Requires a cosine of at least |\a cosine| between the normal and the unit vector \a ray or, if
  /// \a cosine is negative, -\a ray.
  void Add(const glm::dvec3& ray, double cosine);
  void Add(const std::vector<glm::dvec3>& rays, double sign, double cosine);

  /// Finds the best normal and returns its ratio m. Returns 0 if there are no rays, or if every
  /// normal has a cosine of 0 or less with some ray.
  double FindBest();
  /// Returns the best normal, after FindBest. It is undefined if FindBest returned 0.
  const glm::dvec3& GetBest() const { return this->Best; }

  /// Returns the ratio m for \a normal.
  double GetRatio(const glm::dvec3& normal) const;

  /// Returns \a preferred, rotated toward the best normal only as far as the rays require. Returns
  /// the best normal if the requirements cannot be met, and \a preferred if there is no best
  /// normal. Call FindBest first. The result is continuous in the rays and in \a preferred.
  glm::dvec3 Adjust(const glm::dvec3& preferred) const;

private:
  /// Rays divided by their required cosines, d_k / c_k.
  std::vector<glm::dvec3> Rays;
  glm::dvec3 Best{ 0.0, 0.0, 0.0 };
  double BestRatio = 0.0;
};

}

#endif
