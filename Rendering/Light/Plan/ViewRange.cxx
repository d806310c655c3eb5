#include "Plan/ViewRange.h"

#include "Plan/SliceNormal.h"

namespace interlume
{

namespace
{

using namespace UnitVector;

double FindBest(const std::vector<Vector>& rays, double cosine)
{
  SliceNormal normal;
  normal.Add(rays, 1.0, cosine);
  return normal.FindBest();
}

// Through the corners of the picture; empty where the matrix has none.
std::vector<Vector> GetPictureRays(const SlicePlan::Eye& eye)
{
  const Matrix& m = eye.ClipFromUnit;
  const Vector rows[3] = { { { m[0], m[1], m[2] } }, { { m[4], m[5], m[6] } },
    { { m[12], m[13], m[14] } } };
  const Vector none{ { 0.0, 0.0, 0.0 } };
  std::vector<Vector> rays;
  for (const double x : { -1.0, 1.0 })
  {
    for (const double y : { -1.0, 1.0 })
    {
      // What the planes of the pixel's column and row have in common.
      const Vector ray = Normalize(
        Cross(Combine(1.0, rows[0], -x, rows[2]), Combine(1.0, rows[1], -y, rows[2])), none);
      const double forward = Dot(ray, eye.Direction);
      if (!(std::abs(forward) > 0.0))
      {
        return {};
      }
      rays.push_back(Scale(forward > 0.0 ? 1.0 : -1.0, ray));
    }
  }
  return rays;
}

}

ViewRange::ViewRange(const SlicePlan::Eye& eye, const BoxCorners& corners)
  : Direction(eye.Direction)
  , Rays({ eye.Direction })
{
  if (eye.IsParallel)
  {
    return;
  }
  const std::vector<Vector> rays = corners.GetRays(eye.Position);
  const double ratio = FindBest(rays, SlicePlan::EyeCosine);
  const std::vector<Vector> picture = ratio < 1.0 ? GetPictureRays(eye) : std::vector<Vector>();
  if (!picture.empty() && FindBest(picture, SlicePlan::EyeCosine) > ratio)
  {
    this->Rays = picture;
  }
  else if (ratio > 0.0)
  {
    this->Direction =
      Normalize(Combine(1.0, corners.GetCenter(), -1.0, eye.Position), eye.Direction);
    this->Rays = rays;
  }
}

}
