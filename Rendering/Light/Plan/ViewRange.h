// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ViewRange_h
#define interlume_ViewRange_h

#include "Common/Vectors.h"
#include "Plan/SlicePlan.h"
#include "Space/BoxCorners.h"

namespace interlume
{

/**
 * @class   ViewRange
 * @brief   the rays of the eye to which slices must not be too flat
 *
 * They are the rays through the box's corners, or those through the picture's corners where these
 * spread less, as from close to the volume or inside it.
 */
struct ViewRange
{
  ViewRange(const SlicePlan::Eye& eye, const BoxCorners& corners);

  /// To the box's middle with the first kind of rays, else the eye's.
  glm::dvec3 Direction;
  std::vector<glm::dvec3> Rays;
};

}

#endif
