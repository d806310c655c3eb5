// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/LightGroup.h"

#include "Common/Vectors.h"
#include "Plan/LightFit.h"
#include "Plan/SliceNormal.h"

namespace interlume
{

namespace
{

// Light that is perpendicular to the view but for rounding goes with it.
constexpr double Perpendicularity = 1e-9;
// The length below which sums of directions have no direction.
constexpr double Nothing = 1e-9;

}

using namespace UnitVector;

LightGroup::Caster::Caster(int index, const LightSource& source, const BoxCorners& corners)
  : Light(index)
  , Direction(source.Direction)
  , Rays({ source.Direction })
{
  if (source.IsPositional)
  {
    const glm::dvec3 toCenter = corners.GetCenter() - source.Position;
    this->Direction = Normalize(toCenter, source.Direction);
    this->Rays = Vectors::SafeLength(toCenter) < LightFit::FarDistance
      ? corners.GetRays(source.Position)
      : std::vector<glm::dvec3>{ this->Direction };
  }
}

LightGroup::LightGroup(const ViewRange& view, const Caster& caster, double side)
  : Side(side)
  , Casters({ caster })
{
  this->FindNormal(view);
}

LightGroup LightGroup::Make(const ViewRange& view, const Caster& caster)
{
  const double side = glm::dot(view.Direction, caster.Direction) >= -Perpendicularity ? 1.0 : -1.0;
  LightGroup own(view, caster, side);
  if (own.Ratio >= 1.0)
  {
    return own;
  }
  LightGroup other(view, caster, -side);
  return other.Ratio > own.Ratio ? other : own;
}

bool LightGroup::Join(const ViewRange& view, const Caster& caster, std::size_t most)
{
  if (this->Casters.size() >= most)
  {
    return false;
  }
  LightGroup joined = *this;
  joined.Casters.push_back(caster);
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
  for (const Caster& caster : this->Casters)
  {
    rays.Add(caster.Rays, 1.0, 1.0);
  }
  return rays.GetRatio(this->Normal);
}

void LightGroup::FindNormal(const ViewRange& view)
{
  SliceNormal normal;
  normal.Add(view.Rays, this->Side, SlicePlan::EyeCosine);
  glm::dvec3 sum{ 0.0, 0.0, 0.0 };
  for (const Caster& caster : this->Casters)
  {
    normal.Add(caster.Rays, 1.0, SlicePlan::LightCosine);
    sum += caster.Direction;
  }
  this->Ratio = normal.FindBest();
  const glm::dvec3 along = this->Side * view.Direction;
  const glm::dvec3 average = Vectors::SafeLength(sum) > Nothing ? Normalize(sum, along) : along;
  const glm::dvec3 half = along + average;
  this->Normal = normal.Turn(Vectors::SafeLength(half) > Nothing ? Normalize(half, along) : along);
}

}
