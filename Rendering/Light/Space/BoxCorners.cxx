// SPDX-License-Identifier: BSD-3-Clause
#include "Space/BoxCorners.h"

#include "Common/Vectors.h"
#include "Space/UnitSpace.h"

#include <limits>

namespace interlume
{

using namespace UnitVector;

BoxCorners::BoxCorners(const UnitSpace& space, const std::array<std::array<double, 2>, 3>& box)
{
  this->Add(space, box);
}

void BoxCorners::Add(const UnitSpace& space, const std::array<std::array<double, 2>, 3>& box)
{
  for (unsigned i = 0; i < 8; ++i)
  {
    this->Corners.push_back(TransformPoint(
      space.UnitFromTexture, { box[0][i & 1u], box[1][i >> 1 & 1u], box[2][i >> 2 & 1u] }));
  }
}

glm::dvec3 BoxCorners::GetCenter() const
{
  glm::dvec3 lower = this->Corners[0];
  glm::dvec3 upper = this->Corners[7];
  if (this->Corners.size() > 8)
  {
    upper = lower;
    for (const glm::dvec3& corner : this->Corners)
    {
      lower = glm::min(lower, corner);
      upper = glm::max(upper, corner);
    }
  }
  return 0.5 * lower + 0.5 * upper;
}

std::array<double, 2> BoxCorners::GetRange(const glm::dvec3& normal) const
{
  std::array<double, 2> range{ { std::numeric_limits<double>::max(),
    -std::numeric_limits<double>::max() } };
  for (const glm::dvec3& corner : this->Corners)
  {
    range[0] = std::min(range[0], glm::dot(corner, normal));
    range[1] = std::max(range[1], glm::dot(corner, normal));
  }
  return range;
}

std::vector<glm::dvec3> BoxCorners::GetRays(const glm::dvec3& from) const
{
  const glm::dvec3 none{ 0.0, 0.0, 0.0 };
  std::vector<glm::dvec3> rays;
  rays.reserve(this->Corners.size());
  for (const glm::dvec3& corner : this->Corners)
  {
    const glm::dvec3 ray = Normalize(corner - from, none);
    if (ray != none)
    {
      rays.push_back(ray);
    }
  }
  return rays;
}

}
