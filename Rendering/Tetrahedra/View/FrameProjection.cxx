// SPDX-License-Identifier: BSD-3-Clause
#include "View/FrameProjection.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

FrameProjection::FrameProjection(const ViewRays& rays)
  : Parallel(rays.Viewpoint.IsParallel)
  , Origin(rays.Viewpoint.Eye)
  , Width(std::max(rays.Width, 0))
  , Height(std::max(rays.Height, 0))
  , PixelWidth(1.0 / std::max(rays.Width, 1))
  , PixelHeight(1.0 / std::max(rays.Height, 1))
{
  const glm::dvec3 right = rays.HalfSize[0] * rays.Right;
  const glm::dvec3 up = rays.HalfSize[1] * rays.Up;
  glm::dvec3 direction = rays.Viewpoint.Direction;
  // A shifted window translates the origin in parallel projection. In perspective it rotates the
  // central view ray.
  glm::dvec3& shifted = this->Parallel ? this->Origin : direction;
  shifted += rays.Center[0] * rays.Right;
  shifted += rays.Center[1] * rays.Up;

  // Rows of the inverse of the matrix with columns right, up, direction.
  const double determinant = glm::dot(glm::cross(right, up), direction);
  const double inverse = 1.0 / determinant;
  this->Valid = this->Width > 0 && this->Height > 0 && std::isfinite(inverse);
  this->Mirrored = determinant > 0.0;
  if (this->Valid)
  {
    this->Rows[0] = inverse * glm::cross(up, direction);
    this->Rows[1] = inverse * glm::cross(direction, right);
    this->Rows[2] = inverse * glm::cross(right, up);
  }
}

FrameProjection::Range FrameProjection::FindRange(double minimum, double maximum, int pixels)
{
  // The margin exceeds the projection error, so no pixel is missed; each pixel of the range is
  // tested exactly later. Clamp before converting to int, because a point near the camera plane
  // projects outside the range of int.
  constexpr double margin = 1e-3;
  const double first = std::ceil((minimum + 1.0) * 0.5 * pixels - 0.5 - margin);
  const double last = std::floor((maximum + 1.0) * 0.5 * pixels - 0.5 + margin);
  return { static_cast<int>(std::clamp(first, 0.0, static_cast<double>(pixels))),
    static_cast<int>(std::clamp(last, -1.0, pixels - 1.0)) };
}

}
