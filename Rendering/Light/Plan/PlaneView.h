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
 * Maps between a plane and its views.
 */
namespace PlaneView
{
/**
 * Computes the matrix from clip coordinates (x, y, 1) of a view to homogeneous points (X, Y, Z, W)
 * on a plane. The view matrix has the form of SlicePlan::ShadowedLight::BufferFromUnit. The plane
 * is n.x + plane[3] = 0, where n is the first three elements of \a plane. The result is 0 if the
 * view sees the plane edge-on.
 */
glm::dmat3x4 GetPoints(const glm::dmat4& view, const std::array<double, 4>& plane);

/**
 * Computes the homography between two views of a plane: it maps (x, y, 1) in clip coordinates of
 * the first view to (x', y', 1) of the second, times a factor. The factor is positive if a point is
 * in front of both views or behind both. The view matrices and the plane are as in GetPoints. The
 * result is 0 if the first view sees the plane edge-on.
 */
glm::dmat3 GetHomography(
  const glm::dmat4& from, const glm::dmat4& to, const std::array<double, 4>& plane);
}

}

#endif
