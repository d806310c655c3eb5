// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/CameraRays.h"

#include "Common/Vectors.h"
#include "Plan/SliceNormal.h"

namespace interlume
{

namespace
{

using namespace UnitVector;

double FindBest(const std::vector<glm::dvec3>& rays, double cosine)
{
  SliceNormal normal;
  normal.Add(rays, 1.0, cosine);
  return normal.FindBest();
}

// Returns the rays through the corners of the frame, or no rays if the camera's matrix is singular.
std::vector<glm::dvec3> GetImageRays(const SlicePlan::Camera& eye)
{
  const glm::dmat4& m = eye.ClipFromUnit;
  const glm::dvec3 rows[3] = { GetRow(m, 0), GetRow(m, 1), GetRow(m, 3) };
  const glm::dvec3 none{ 0.0, 0.0, 0.0 };
  std::vector<glm::dvec3> rays;
  for (const double x : { -1.0, 1.0 })
  {
    for (const double y : { -1.0, 1.0 })
    {
      // The ray is the intersection of two planes, which project to the corner's column and row.
      const glm::dvec3 ray =
        Normalize(glm::cross(rows[0] - x * rows[2], rows[1] - y * rows[2]), none);
      const double forward = glm::dot(ray, eye.Direction);
      if (!(std::abs(forward) > 0.0))
      {
        return {};
      }
      rays.push_back((forward > 0.0 ? 1.0 : -1.0) * ray);
    }
  }
  return rays;
}

}

CameraRays::CameraRays(const SlicePlan::Camera& eye, const BoxCorners& corners)
  : Direction(eye.Direction)
  , Rays({ eye.Direction })
{
  if (eye.IsParallel)
  {
    return;
  }
  const std::vector<glm::dvec3> rays = corners.GetRays(eye.Position);
  const double ratio = FindBest(rays, SlicePlan::ViewCosine);
  const std::vector<glm::dvec3> imageRays =
    ratio < 1.0 ? GetImageRays(eye) : std::vector<glm::dvec3>();
  if (!imageRays.empty() && FindBest(imageRays, SlicePlan::ViewCosine) > ratio)
  {
    this->Rays = imageRays;
  }
  else if (ratio > 0.0)
  {
    this->Direction = Normalize(corners.GetCenter() - eye.Position, eye.Direction);
    this->Rays = rays;
  }
}

}
