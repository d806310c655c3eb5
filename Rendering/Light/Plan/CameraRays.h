// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CameraRays_h
#define interlume_CameraRays_h

#include "Common/Vectors.h"
#include "Plan/SlicePlan.h"
#include "Space/BoxCorners.h"

namespace interlume
{

/**
 * @class   CameraRays
 * @brief   view rays that must not be nearly parallel to the slices
 *
 * In parallel projection, the only ray is the view direction. In perspective, the rays pass through
 * the corners of the volumes' boxes. If the camera is close to a volume or inside it, the rays
 * through the corners of the frame are used if they span a smaller range of directions.
 */
struct CameraRays
{
  CameraRays(const SlicePlan::Camera& eye, const BoxCorners& corners);

  /// Direction to the center of the boxes if the rays pass through their corners, otherwise the
  /// view direction.
  glm::dvec3 Direction;
  std::vector<glm::dvec3> Rays;
};

}

#endif
