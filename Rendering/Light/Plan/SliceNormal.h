// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceNormal_h
#define interlume_SliceNormal_h

#include "Space/UnitVector.h"

#include <vector>

namespace interlume
{

/**
 * @class   SliceNormal
 * @brief   a direction that makes small enough angles with rays
 *
 * Of the normals n of length 1 the best one has the greatest m = min d_k.n / c_k over all rays d_k,
 * with c_k the cosine wanted. It is along the point nearest to 0 of the convex hull of all d_k /
 * c_k, and m is that point's distance (the two problems are dual). All rays have their cosines if m
 * >= 1.
 */
class SliceNormal
{
public:
  /// Wants a normal that makes \a cosine, above 0, or more with \a ray, of length 1.
  void Add(const glm::dvec3& ray, double cosine);
  void Add(const std::vector<glm::dvec3>& rays, double sign, double cosine);

  /// Finds the best normal, and returns its m; 0 without rays, and if every normal is perpendicular
  /// to some ray or goes against it.
  double FindBest();
  /// The best normal after FindBest; not defined where that was 0.
  const glm::dvec3& GetBest() const { return this->Best; }

  /// m of this normal.
  double GetRatio(const glm::dvec3& normal) const;

  /// \a preferred turned towards the best normal as far as the rays need it, which is not at all
  /// where they have their cosines already; the best normal where they cannot have them, and
  /// \a preferred where there is no best. After FindBest. Continuous in the rays and in \a
  /// preferred.
  glm::dvec3 Turn(const glm::dvec3& preferred) const;

private:
  /// d_k / c_k
  std::vector<glm::dvec3> Rays;
  glm::dvec3 Best{ 0.0, 0.0, 0.0 };
  double BestRatio = 0.0;
};

}

#endif
