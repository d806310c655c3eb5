// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PlaneView_h
#define interlume_PlaneView_h

#include <array>

#include <glm/mat3x3.hpp>
#include <glm/mat3x4.hpp>
#include <glm/mat4x4.hpp>

namespace interlume
{

/**
 * Views of one plane.
 */
namespace PlaneView
{
/**
 * Computes the points of a plane from clip coordinates (x, y, 1) of a view, homogeneous ones: (X,
 * Y, Z, W). The view is a matrix as BufferFromUnit of SlicePlan::ShadowedLight; \a
 * plane is n.x + plane[3] = 0. The matrix is 0 where the view sees the plane edge-on.
 */
glm::dmat3x4 GetPoints(const glm::dmat4& view, const std::array<double, 4>& plane);

/**
 * Computes the homography from one view of a plane to another one: (x, y, 1) in clip coordinates of
 * the first to (x', y', 1) of the second, times a factor that is above 0 where a point is before
 * both views or behind both. Views are matrices as BufferFromUnit of
 * SlicePlan::ShadowedLight; \a plane is n.x + plane[3] = 0. The matrix is 0 where the first view
 * sees the plane edge-on.
 */
glm::dmat3 GetHomography(
  const glm::dmat4& from, const glm::dmat4& to, const std::array<double, 4>& plane);
}

}

#endif
