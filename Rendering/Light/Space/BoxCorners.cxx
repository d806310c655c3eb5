#include "Space/BoxCorners.h"

#include "Space/UnitSpace.h"

namespace interlume
{

using namespace UnitVector;

BoxCorners::BoxCorners(const UnitSpace& space, const std::array<std::array<double, 2>, 3>& box)
{
  for (unsigned i = 0; i < 8; ++i)
  {
    this->Corners[i] = TransformPoint(
      space.UnitFromTexture, { { box[0][i & 1u], box[1][i >> 1 & 1u], box[2][i >> 2 & 1u] } });
  }
}

BoxCorners::Vector BoxCorners::GetCenter() const
{
  return Combine(0.5, this->Corners[0], 0.5, this->Corners[7]);
}

std::array<double, 2> BoxCorners::GetRange(const Vector& normal) const
{
  std::array<double, 2> range{ { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } };
  for (const Vector& corner : this->Corners)
  {
    range[0] = std::min(range[0], Dot(corner, normal));
    range[1] = std::max(range[1], Dot(corner, normal));
  }
  return range;
}

std::vector<BoxCorners::Vector> BoxCorners::GetRays(const Vector& from) const
{
  const Vector none{ { 0.0, 0.0, 0.0 } };
  std::vector<Vector> rays;
  rays.reserve(this->Corners.size());
  for (const Vector& corner : this->Corners)
  {
    const Vector ray = Normalize(Combine(1.0, corner, -1.0, from), none);
    if (ray != none)
    {
      rays.push_back(ray);
    }
  }
  return rays;
}

}
