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
 * @brief   on which side of a face's plane the eye is, and when that is not to be asked
 *
 * With edges u and v of a face, its normal n = u x v, and d from a corner of it to the eye (in
 * parallel: against the direction), the sign of n . d is the side. It is taken as 0, the face as
 * seen edge-on, up to the error that the rounding of coordinates, already in the mesh, and of this
 * arithmetic may make, so any other sign is right. Such a face covers nothing of a picture, and
 * without this rule the many coplanar faces of a structured mesh, whose plane the eye is in, would
 * each have a side by chance, which makes cycles.
 */
class EdgeOnRule
{
public:
  /// Takes a view; \a radius is the greatest distance of a point from the mesh's origin.
  EdgeOnRule(const Viewpoint& view, double radius)
    : IsPerspective(view.IsParallel ? 0.0 : 1.0)
    , Eye(view.IsParallel ? -view.Direction : view.Eye)
  {
    // The value |n . d| errs by less than 66 units of rounding of |d| radius (|u| + |v|), with
    // points known to 4 units of radius, |u| and |v| at most 2 radius, and the greatest components
    // for | |.
    const double size = view.IsParallel ? Vectors::InfinityNorm(this->Eye)
                                        : Vectors::InfinityNorm(this->Eye) + radius;
    this->Error = 64.0 * std::numeric_limits<double>::epsilon() * size * radius;
  }

  /// Returns the way from \a point to the eye.
  glm::dvec3 GetTowardEye(const glm::dvec3& point) const
  {
    return this->Eye - this->IsPerspective * point;
  }
  /// Returns the greatest |n . d| that is taken as 0; \a sizes are those of u and v, by
  /// Vectors::InfinityNorm.
  double GetBound(double sizes) const { return this->Error * sizes; }

private:
  double IsPerspective;
  glm::dvec3 Eye;
  double Error;
};

}

#endif
