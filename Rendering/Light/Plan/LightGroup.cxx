// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/LightGroup.h"

#include "Common/Vectors.h"
#include "Plan/LightBufferProjection.h"
#include "Plan/SliceNormal.h"

namespace interlume
{

namespace
{

// If the view and light directions are perpendicular within this tolerance, the sweep runs front to
// back.
constexpr double Perpendicularity = 1e-9;
// Length below which a sum of directions is treated as 0.
constexpr double MinimumLength = 1e-9;

}

using namespace UnitVector;

LightGroup::Light::Light(int index, const LightSource& source, const BoxCorners& corners)
  : Index(index)
  , Direction(source.Direction)
  , Rays({ source.Direction })
{
  if (source.IsPositional)
  {
    const glm::dvec3 toCenter = corners.GetCenter() - source.Position;
    this->Direction = Normalize(toCenter, source.Direction);
    this->Rays = Vectors::SafeLength(toCenter) < LightBufferProjection::FarDistance
      ? corners.GetRays(source.Position)
      : std::vector<glm::dvec3>{ this->Direction };
  }
}

LightGroup::LightGroup(const CameraRays& view, const Light& light, double side)
  : Side(side)
  , Lights({ light })
{
  this->FindNormal(view);
}

LightGroup LightGroup::Make(const CameraRays& view, const Light& light)
{
  const double side = glm::dot(view.Direction, light.Direction) >= -Perpendicularity ? 1.0 : -1.0;
  LightGroup own(view, light, side);
  if (own.Ratio >= 1.0)
  {
    return own;
  }
  LightGroup other(view, light, -side);
  return other.Ratio > own.Ratio ? other : own;
}

bool LightGroup::Join(const CameraRays& view, const Light& light, std::size_t maximum)
{
  if (this->Lights.size() >= maximum)
  {
    return false;
  }
  LightGroup joined = *this;
  joined.Lights.push_back(light);
  joined.FindNormal(view);
  if (joined.Ratio < 1.0)
  {
    return false;
  }
  *this = joined;
  return true;
}

double LightGroup::GetLightCosine() const
{
  SliceNormal rays;
  for (const Light& light : this->Lights)
  {
    rays.Add(light.Rays, 1.0, 1.0);
  }
  return rays.GetRatio(this->Normal);
}

void LightGroup::FindNormal(const CameraRays& view)
{
  SliceNormal normal;
  normal.Add(view.Rays, this->Side, SlicePlan::ViewCosine);
  glm::dvec3 sum{ 0.0, 0.0, 0.0 };
  for (const Light& light : this->Lights)
  {
    normal.Add(light.Rays, 1.0, SlicePlan::LightCosine);
    sum += light.Direction;
  }
  this->Ratio = normal.FindBest();
  const glm::dvec3 along = this->Side * view.Direction;
  const glm::dvec3 average =
    Vectors::SafeLength(sum) > MinimumLength ? Normalize(sum, along) : along;
  const glm::dvec3 half = along + average;
  this->Normal =
    normal.Adjust(Vectors::SafeLength(half) > MinimumLength ? Normalize(half, along) : along);
}

}
