// SPDX-License-Identifier: BSD-3-Clause
#include "Order/FaceRaster.h"

#include <algorithm>
#include <limits>

namespace interlume
{

FaceRaster::FaceRaster(const FrameProjection& projection, const std::array<glm::dvec3, 3>& corners,
  const std::array<std::uint32_t, 3>& ids)
  : Projection(projection)
  , Normal(glm::cross(corners[1] - corners[0], corners[2] - corners[0]))
  , Offset(glm::dot(this->Normal, corners[0]))
  , MinimumDepth(std::min({ corners[0][2], corners[1][2], corners[2][2] }))
  , MaximumDepth(std::max({ corners[0][2], corners[1][2], corners[2][2] }))
{
  this->FindBoundingRectangle(corners);
  for (int e = 0; e < 3; ++e)
  {
    glm::dvec3 a = corners[e];
    glm::dvec3 b = corners[(e + 1) % 3];
    if (projection.IsParallel())
    {
      a[2] = b[2] = 1.0;
    }
    this->Edges[e] = MakeEdge(a, ids[e], b, ids[(e + 1) % 3]);
  }
}

FaceRaster::Edge FaceRaster::MakeEdge(
  const glm::dvec3& a, std::uint32_t idA, const glm::dvec3& b, std::uint32_t idB)
{
  const double sign = idA < idB ? 1.0 : -1.0;
  const glm::dvec3 line = idA < idB ? glm::cross(a, b) : glm::cross(b, a);
  return { sign * line[0], sign * line[1], sign * line[2] };
}

void FaceRaster::FindBoundingRectangle(const std::array<glm::dvec3, 3>& corners)
{
  // In perspective, use only the part of the triangle in front of the camera. Ignore points closer
  // to the camera plane than a millionth of the triangle's maximum depth: they are visible only if
  // they are also that close to the camera itself.
  const double nearest = this->Projection.IsParallel() ? std::numeric_limits<double>::lowest()
                                                       : 1e-6 * this->MaximumDepth;
  if (!this->Projection.IsParallel() && this->MaximumDepth <= 0.0)
  {
    return;
  }
  double minimum[2] = { std::numeric_limits<double>::max(), std::numeric_limits<double>::max() };
  double maximum[2] = { std::numeric_limits<double>::lowest(),
    std::numeric_limits<double>::lowest() };
  const auto add = [&](const glm::dvec3& p)
  {
    const double scale = this->Projection.IsParallel() ? 1.0 : 1.0 / p[2];
    for (int axis = 0; axis < 2; ++axis)
    {
      minimum[axis] = std::min(minimum[axis], p[axis] * scale);
      maximum[axis] = std::max(maximum[axis], p[axis] * scale);
    }
  };
  for (int e = 0; e < 3; ++e)
  {
    const glm::dvec3& a = corners[e];
    const glm::dvec3& b = corners[(e + 1) % 3];
    if (a[2] >= nearest)
    {
      add(a);
    }
    if ((a[2] >= nearest) != (b[2] >= nearest))
    {
      glm::dvec3 cut = a + (nearest - a[2]) / (b[2] - a[2]) * (b - a);
      cut[2] = nearest;
      add(cut);
    }
  }
  this->Columns = this->Projection.GetColumns(minimum[0], maximum[0]);
  this->Rows = this->Projection.GetRows(minimum[1], maximum[1]);
}

}
