// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_EdgeOnRule_h
#define interlume_EdgeOnRule_h

#include "Common/Vectors.h"
#include "Mesh/TetrahedraMesh.h"

#include <limits>

namespace interlume
{

/**
 * @class   EdgeOnRule
 * @brief determines on which side of a face's plane the camera is, with an error bound
 *
 * For a face with edges u and v, normal n = u x v, and vector d from a corner to the camera (in
 * parallel projection: against the view direction), the side is the sign of n . d. The sign is
 * treated as 0 (face seen edge-on) up to the maximum rounding error of the mesh coordinates and of
 * this computation. All other signs are therefore correct.
 *
 * An edge-on face covers no pixels. Without this rule, coplanar faces of a structured mesh, in a
 * plane that contains the camera, would get random signs, which would create visibility cycles.
 */
class EdgeOnRule
{
public:
  /// \a radius is the largest distance of a point from the mesh's origin.
  EdgeOnRule(const Viewpoint& view, double radius)
    : IsPerspective(view.IsParallel ? 0.0 : 1.0)
    , Eye(view.IsParallel ? -view.Direction : view.Eye)
  {
    // The error of |n . d| is less than 66 roundoff units of |d| radius (|u| + |v|), where | | is
    // the infinity norm. Coordinates are known to within 4 roundoff units of radius, and |u| and
    // |v| are at most 2 radius.
    const double size = view.IsParallel ? Vectors::InfinityNorm(this->Eye)
                                        : Vectors::InfinityNorm(this->Eye) + radius;
    this->Error = 64.0 * std::numeric_limits<double>::epsilon() * size * radius;
  }

  /// Returns the vector from \a point to the camera.
  glm::dvec3 GetVectorToEye(const glm::dvec3& point) const
  {
    return this->Eye - this->IsPerspective * point;
  }
  /// Returns the largest |n . d| that is treated as 0. \a sizes is the sum of the infinity norms of
  /// u and v.
  double GetBound(double sizes) const { return this->Error * sizes; }

private:
  double IsPerspective;
  glm::dvec3 Eye;
  double Error;
};

}

#endif
