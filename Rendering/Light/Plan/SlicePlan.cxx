// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/SlicePlan.h"

#include "Plan/LightBufferProjection.h"
#include "Plan/LightGroup.h"
#include "Plan/SliceNormal.h"
#include "Plan/CameraRays.h"
#include "Space/BoxCorners.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace interlume
{

namespace
{

using namespace UnitVector;

// A wide light needs no sweep on a side where the volumes extend less than this past it.
constexpr double MinimumExtent = 1e-9;

// Adds the light of \a own to a group with a suitable normal, preferably one with the same drawing
// order, or appends \a own.
void AddLight(const CameraRays& view, const LightGroup& own, std::size_t maximum,
  std::vector<LightGroup>& groups)
{
  for (const bool mustHaveSameOrder : { true, false })
  {
    for (LightGroup& group : groups)
    {
      const bool hasSameOrder = group.IsFrontToBack() == own.IsFrontToBack();
      if (hasSameOrder == mustHaveSameOrder && group.Join(view, own.GetLights().front(), maximum))
      {
        return;
      }
    }
  }
  groups.push_back(own);
}

// Returns the index of a sweep along \a normal with fewer than \a maximum lights, or -1.
int FindSweep(
  const std::vector<SlicePlan::Sweep>& sweeps, const glm::dvec3& normal, std::size_t maximum)
{
  for (std::size_t i = 0; i < sweeps.size(); ++i)
  {
    if (sweeps[i].Normal == normal && sweeps[i].Lights.size() < maximum)
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

// Adds a wide light to the sweeps along and against the normal that requires the fewest new sweeps.
void AddWide(const CameraRays& view, const LightSource& source, int index,
  const BoxCorners& corners, std::size_t maximum, const LightBufferProjection& projection,
  std::vector<SlicePlan::Sweep>& sweeps)
{
  std::vector<glm::dvec3> normals;
  normals.reserve(sweeps.size() + 1);
  for (const SlicePlan::Sweep& sweep : sweeps)
  {
    normals.push_back(sweep.Normal);
  }
  normals.push_back(view.Direction);

  const auto getSides = [&](const glm::dvec3& normal)
  {
    const std::array<double, 2> range = corners.GetRange(normal);
    const double light = glm::dot(source.Position, normal);
    std::vector<glm::dvec3> sides;
    if (range[1] > light + MinimumExtent)
    {
      sides.push_back(normal);
    }
    if (range[0] < light - MinimumExtent)
    {
      sides.push_back(-normal);
    }
    return sides;
  };
  const auto countNew = [&](const glm::dvec3& normal)
  {
    const std::vector<glm::dvec3> sides = getSides(normal);
    return std::count_if(sides.begin(), sides.end(),
      [&](const glm::dvec3& side) { return FindSweep(sweeps, side, maximum) < 0; });
  };
  const glm::dvec3 normal = *std::min_element(normals.begin(), normals.end(),
    [&](const glm::dvec3& a, const glm::dvec3& b) { return countNew(a) < countNew(b); });

  for (const glm::dvec3& side : getSides(normal))
  {
    int sweep = FindSweep(sweeps, side, maximum);
    if (sweep < 0)
    {
      sweep = static_cast<int>(sweeps.size());
      sweeps.emplace_back();
      sweeps.back().Normal = side;
      sweeps.back().IsFrontToBack = glm::dot(side, view.Direction) > 0.0;
    }
    SlicePlan::ShadowedLight light;
    light.Light = index;
    projection.FitHalfSpaceBuffer(side, source.Position, light);
    sweeps[static_cast<std::size_t>(sweep)].Lights.push_back(light);
  }
}

bool IsWide(const SlicePlan::ShadowedLight& light)
{
  return light.IsWide;
}

// If two consecutive sweeps cover the half spaces of one wide light and have no other lights, draws
// the half space farther from the camera second, behind the other.
void PairHalves(std::vector<SlicePlan::Sweep>& sweeps)
{
  for (std::size_t i = 1; i < sweeps.size(); ++i)
  {
    SlicePlan::Sweep& first = sweeps[i - 1];
    SlicePlan::Sweep& second = sweeps[i];
    if (first.Lights.size() == 1 && second.Lights.size() == 1 && IsWide(first.Lights[0]) &&
      IsWide(second.Lights[0]) && first.Lights[0].Light == second.Lights[0].Light)
    {
      if (first.IsFrontToBack)
      {
        std::swap(first, second);
      }
      second.IsBehind = true;
    }
  }
}

// Returns true if the sweep must start at the boundary of the volumes rather than at its first
// light: to draw the opacity, or because it has lights that are not wide.
bool CoversVolumes(const std::vector<SlicePlan::Sweep>& sweeps, std::size_t index)
{
  const SlicePlan::Sweep& sweep = sweeps[index];
  const bool isHalf = sweep.IsBehind || (index + 1 < sweeps.size() && sweeps[index + 1].IsBehind);
  return !isHalf &&
    (index == 0 || sweep.IsFrontToBack ||
      !std::all_of(sweep.Lights.begin(), sweep.Lights.end(), IsWide));
}

// Returns the smallest coordinate of the sweep's lights along the sweep's normal.
double GetFirstLight(const SlicePlan::Sweep& sweep, const std::vector<LightSource>& lights)
{
  double first = std::numeric_limits<double>::max();
  for (const SlicePlan::ShadowedLight& light : sweep.Lights)
  {
    first = std::min(
      first, glm::dot(lights[static_cast<std::size_t>(light.Light)].Position, sweep.Normal));
  }
  return first;
}

// Returns the automatic slice spacing. For oblique slices, a spacing of one voxel along the view
// direction suffices, even if voxels are shorter along the normal.
double GetAutomaticSpacing(
  const UnitSpace& space, const glm::dvec3& normal, const glm::dvec3& direction, double factor)
{
  const double seen =
    SlicePlan::GetVoxelSpacing(space, direction) * std::abs(glm::dot(direction, normal));
  return factor * std::max(SlicePlan::GetVoxelSpacing(space, normal), seen);
}

// Divides a range along the normal into slabs.
void SetSlabs(SlicePlan::Sweep& sweep, const std::array<double, 2>& range,
  const std::vector<SlicePlan::SlicedVolume>& volumes, const glm::dvec3& direction,
  const SlicePlan::Settings& settings)
{
  const double extent = range[1] - range[0];
  double spacing = std::numeric_limits<double>::max();
  for (const SlicePlan::SlicedVolume& volume : volumes)
  {
    spacing = std::min(spacing, SlicePlan::GetSpacing(volume, sweep.Normal, direction, settings));
  }
  // Rounding errors must not add a slab.
  constexpr double rounding = 1e-9;
  const double slabs = std::ceil(extent / spacing * (1.0 - rounding));
  const int maximum = std::max(settings.MaximumNumberOfSlabs, 1);
  sweep.Slabs = slabs < maximum ? std::max(static_cast<int>(slabs), 1) : maximum;
  sweep.First = range[0];
  sweep.Spacing = extent / sweep.Slabs;
}

// Refines the buffers of the sweep's lights with hard shadows if slabs are optically dense in any
// volume.
void RefineLights(SlicePlan::Sweep& sweep, const std::vector<LightSource>& lights,
  const std::vector<SlicePlan::SlicedVolume>& volumes, const LightBufferProjection& projection)
{
  if (std::none_of(volumes.begin(), volumes.end(),
        [&sweep](const SlicePlan::SlicedVolume& volume)
        { return volume.RampExtinction * sweep.Spacing > SlicePlan::DenseDepth; }))
  {
    return;
  }
  for (SlicePlan::ShadowedLight& light : sweep.Lights)
  {
    if (!light.IsWide && light.SoftMethod == SlicePlan::HARD)
    {
      projection.Refine(lights[static_cast<std::size_t>(light.Light)], light);
    }
  }
}

}

void SlicePlan::Make(const Camera& eye, const std::vector<LightSource>& lights,
  const UnitSpace& space, const std::array<std::array<double, 2>, 3>& box, const Settings& settings)
{
  this->Make(eye, lights, { { &space, box, 0.0 } }, settings);
}

void SlicePlan::Make(const Camera& eye, const std::vector<LightSource>& lights,
  const std::vector<SlicedVolume>& volumes, const Settings& settings)
{
  BoxCorners corners(*volumes[0].Space, volumes[0].Box);
  for (std::size_t i = 1; i < volumes.size(); ++i)
  {
    corners.Add(*volumes[i].Space, volumes[i].Box);
  }
  const CameraRays view(eye, corners);
  const LightBufferProjection projection(corners, volumes, settings);
  const auto maximum = static_cast<std::size_t>(std::max(settings.LightsOfSweep, 1));

  std::vector<LightGroup> groups;
  std::vector<int> wide;
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    if (lights[i].ShadowStrength > 0.0)
    {
      const LightGroup::Light light(static_cast<int>(i), lights[i], corners);
      const LightGroup own = LightGroup::Make(view, light);
      if (lights[i].IsPositional && own.GetLightCosine() < WideCosine)
      {
        wide.push_back(light.Index);
      }
      else
      {
        AddLight(view, own, maximum, groups);
      }
    }
  }

  this->NotSoft.clear();
  if (settings.SoftMethod != HARD)
  {
    std::copy_if(wide.begin(), wide.end(), std::back_inserter(this->NotSoft),
      [&lights](int light) { return lights[static_cast<std::size_t>(light)].Area != nullptr; });
  }
  this->Sweeps.clear();
  for (const LightGroup& group : groups)
  {
    Sweep sweep;
    sweep.Normal = group.GetNormal();
    sweep.IsFrontToBack = group.IsFrontToBack();
    for (const LightGroup::Light& member : group.GetLights())
    {
      ShadowedLight light;
      light.Light = member.Index;
      const LightSource& source = lights[static_cast<std::size_t>(member.Index)];
      projection.FitPlanarBuffer(source, light);
      if (source.Area && settings.SoftMethod != HARD &&
        !projection.PlanSoftShadows(source, sweep.Normal, light))
      {
        this->NotSoft.push_back(member.Index);
      }
      sweep.Lights.push_back(light);
    }
    this->Sweeps.push_back(sweep);
  }
  for (const int light : wide)
  {
    AddWide(view, lights[static_cast<std::size_t>(light)], light, corners, maximum, projection,
      this->Sweeps);
  }
  if (this->Sweeps.empty())
  {
    SliceNormal normal;
    normal.Add(view.Rays, 1.0, ViewCosine);
    normal.FindBest();
    Sweep sweep;
    sweep.Normal = normal.Adjust(view.Direction);
    this->Sweeps.push_back(sweep);
  }
  PairHalves(this->Sweeps);
  for (std::size_t i = 0; i < this->Sweeps.size(); ++i)
  {
    Sweep& sweep = this->Sweeps[i];
    std::array<double, 2> range = corners.GetRange(sweep.Normal);
    if (!CoversVolumes(this->Sweeps, i))
    {
      range[0] = std::max(range[0], GetFirstLight(sweep, lights));
    }
    SetSlabs(sweep, range, volumes, view.Direction, settings);
    RefineLights(sweep, lights, volumes, projection);
  }
}

double SlicePlan::GetVoxelSpacing(const UnitSpace& space, const glm::dvec3& normal)
{
  return 1.0 / Vectors::SafeLength(space.GetTexels(normal));
}

double SlicePlan::GetSpacing(const SlicedVolume& volume, const glm::dvec3& normal,
  const glm::dvec3& direction, const Settings& settings)
{
  const double set = volume.Spacing > 0.0 ? volume.Spacing : settings.Spacing;
  return set > 0.0
    ? set
    : GetAutomaticSpacing(*volume.Space, normal, direction, settings.AutomaticFactor);
}

std::array<double, 2> SlicePlan::GetBufferPosition(
  const std::array<double, 9>& frame, const glm::dvec3& direction)
{
  double along[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    along[i] = glm::dot(glm::make_vec3(frame.data() + 3 * i), direction);
  }
  const double size = std::abs(along[0]) + std::abs(along[1]) + along[2];
  const double x = along[0] / size;
  const double y = along[1] / size;
  return { { 0.5 * (x + y) + 0.5, 0.5 * (x - y) + 0.5 } };
}

glm::dvec3 SlicePlan::GetBufferDirection(
  const std::array<double, 9>& frame, const std::array<double, 2>& position)
{
  const double x = position[0] + position[1] - 1.0;
  const double y = position[0] - position[1];
  const double z = 1.0 - std::abs(x) - std::abs(y);
  const glm::dvec3 across = x * glm::make_vec3(&frame[0]) + y * glm::make_vec3(&frame[3]);
  const glm::dvec3 normal = glm::make_vec3(&frame[6]);
  return Normalize(across + z * normal, normal);
}

}
