#include "vtkLightGroup.h"

#include "vtkLightFit.h"
#include "vtkSliceNormal.h"

namespace
{

// Light that is perpendicular to the view but for rounding goes with it.
constexpr double Perpendicularity = 1e-9;
// Sums of directions below this have none.
constexpr double Nothing = 1e-9;

}

using namespace vtkUnitVector;

vtkLightGroup::Caster::Caster(int index, const vtkLightSource& source, const vtkBoxCorners& corners)
  : Light(index)
  , Direction(source.Direction)
  , Rays({ source.Direction })
{
  if (source.IsPositional)
  {
    const Vector toCenter = Combine(1.0, corners.GetCenter(), -1.0, source.Position);
    this->Direction = Normalize(toCenter, source.Direction);
    this->Rays = Length(toCenter) < vtkLightFit::FarDistance
      ? corners.GetRays(source.Position)
      : std::vector<Vector>{ this->Direction };
  }
}

vtkLightGroup::vtkLightGroup(const vtkSliceView& view, const Caster& caster, double side)
  : Side(side)
  , Casters({ caster })
{
  this->FindNormal(view);
}

vtkLightGroup vtkLightGroup::Make(const vtkSliceView& view, const Caster& caster)
{
  const double side = Dot(view.Direction, caster.Direction) >= -Perpendicularity ? 1.0 : -1.0;
  vtkLightGroup own(view, caster, side);
  if (own.Ratio >= 1.0)
  {
    return own;
  }
  vtkLightGroup other(view, caster, -side);
  return other.Ratio > own.Ratio ? other : own;
}

bool vtkLightGroup::Join(const vtkSliceView& view, const Caster& caster, std::size_t most)
{
  if (this->Casters.size() >= most)
  {
    return false;
  }
  vtkLightGroup joined = *this;
  joined.Casters.push_back(caster);
  joined.FindNormal(view);
  if (joined.Ratio < 1.0)
  {
    return false;
  }
  *this = joined;
  return true;
}

double vtkLightGroup::GetLightCosine() const
{
  vtkSliceNormal rays;
  for (const Caster& caster : this->Casters)
  {
    rays.Add(caster.Rays, 1.0, 1.0);
  }
  return rays.GetRatio(this->Normal);
}

void vtkLightGroup::FindNormal(const vtkSliceView& view)
{
  vtkSliceNormal normal;
  normal.Add(view.Rays, this->Side, vtkSlicePlan::EyeCosine);
  Vector sum{ { 0.0, 0.0, 0.0 } };
  for (const Caster& caster : this->Casters)
  {
    normal.Add(caster.Rays, 1.0, vtkSlicePlan::LightCosine);
    sum = Combine(1.0, sum, 1.0, caster.Direction);
  }
  this->Ratio = normal.FindBest();
  const Vector along = Scale(this->Side, view.Direction);
  const Vector average = Length(sum) > Nothing ? Normalize(sum, along) : along;
  const Vector half = Combine(1.0, along, 1.0, average);
  this->Normal = normal.Turn(Length(half) > Nothing ? Normalize(half, along) : along);
}
