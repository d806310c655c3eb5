// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/LightBufferProjection.h"

#include "Common/Vectors.h"
#include "Lights/EmitterSamples.h"
#include "Plan/SliceNormal.h"
#include "Space/UnitSpace.h"

#include "vtkMath.h"

#include <limits>

namespace interlume
{

namespace
{

using namespace UnitVector;

// Minimum cosine between the axis of a perspective window and a light ray through a box corner.
constexpr double SmallestDepth = 1e-3;

constexpr int SmallestBuffer = 16;
constexpr int SmallestAutomatic = 64;
constexpr int SmallestWithLayers = 96;
constexpr int LargestAutomatic = 2048;
constexpr int Multiple = 16;

// Number of emitter samples that PlanSoftShadows tests if the soft method is not LAYERS.
constexpr int CornerSamples = 16;

// Returns the light direction at a point.
glm::dvec3 GetRay(const LightSource& source, const glm::dvec3& point)
{
  return source.IsPositional ? Normalize(point - source.Position, source.Direction)
                             : source.Direction;
}

}

LightBufferProjection::LightBufferProjection(const BoxCorners& corners,
  const std::vector<SlicePlan::SlicedVolume>& volumes, const SlicePlan::Settings& settings)
  : Corners(corners)
  , Volumes(volumes)
  , Settings(settings)
  , Center(corners.GetCenter())
{
}

double LightBufferProjection::GetArea(const Window& window)
{
  return (window.Range[0][1] - window.Range[0][0]) * (window.Range[1][1] - window.Range[1][0]);
}

// Fits the window's range to the boxes. Returns false if part of a box is beside or behind the
// light.
bool LightBufferProjection::Bound(Window& window) const
{
  window.Range = {
    { { { std::numeric_limits<double>::max(), -std::numeric_limits<double>::max() } },
      { { std::numeric_limits<double>::max(), -std::numeric_limits<double>::max() } } }
  };
  for (const glm::dvec3& corner : this->Corners.Get())
  {
    const glm::dvec3 offset = corner - window.Origin;
    const double depth = glm::dot(offset, window.Axis);
    if (window.IsPerspective && depth <= SmallestDepth * Vectors::SafeLength(offset))
    {
      return false;
    }
    for (std::size_t i = 0; i < 2; ++i)
    {
      const double position =
        glm::dot(offset, window.Across[i]) / (window.IsPerspective ? depth : 1.0);
      window.Range[i][0] = std::min(window.Range[i][0], position);
      window.Range[i][1] = std::max(window.Range[i][1], position);
    }
  }
  return true;
}

LightBufferProjection::Window LightBufferProjection::FitWindowToBoxes(
  const LightSource& source) const
{
  Window window;
  const glm::dvec3 toCenter = this->Center - source.Position;
  const double distance = Vectors::SafeLength(toCenter);
  window.IsPerspective = source.IsPositional && distance < FarDistance;
  window.Axis = source.IsPositional ? Normalize(toCenter, source.Direction) : source.Direction;
  if (window.IsPerspective)
  {
    window.Origin = source.Position;
    SliceNormal axis;
    axis.Add(this->Corners.GetRays(source.Position), 1.0, 1.0);
    if (axis.FindBest() > 0.0)
    {
      window.Axis = axis.GetBest();
    }
  }

  Window best;
  const std::vector<glm::dvec3>& corners = this->Corners.Get();
  for (std::size_t edge = 0; edge < 3 * (corners.size() / 8); ++edge)
  {
    const std::size_t first = 8 * (edge / 3);
    const glm::dvec3 along = corners[first + (std::size_t(1) << edge % 3)] - corners[first];
    window.Across[0] = Perpendicular(window.Axis, along);
    window.Across[1] = glm::cross(window.Axis, window.Across[0]);
    this->Bound(window);
    if (edge == 0 || GetArea(window) < GetArea(best))
    {
      best = window;
    }
  }
  return best;
}

// Computes the part of the screen through which light reaches the boxes. Returns false if there is
// no such part.
bool LightBufferProjection::FitWindowToScreen(const LightSource& source, Window& window) const
{
  const glm::dmat4& screen = source.ScreenFromUnit;
  window.IsPerspective = source.IsPositional;
  window.Origin = source.IsPositional ? source.Position : glm::dvec3(0.0, 0.0, 0.0);
  window.Axis = source.Direction;
  std::array<std::array<double, 2>, 2> edges;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const glm::dvec3 depth = source.IsPositional ? GetRow(screen, 3) : glm::dvec3(0.0, 0.0, 0.0);
    const glm::dvec3 across = GetRow(screen, i) - 0.5 * depth;
    const double length = Vectors::SafeLength(across);
    window.Across[i] = Normalize(across, source.Direction);
    if (source.IsPositional)
    {
      const double half = 0.5 * Vectors::SafeLength(depth) / length;
      edges[i] = { { -half, half } };
    }
    else
    {
      const double constant = screen[3][i];
      edges[i] = { { -constant / length, (1.0 - constant) / length } };
    }
  }
  if (!this->Bound(window))
  {
    window.Range = edges;
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    window.Range[i][0] = std::max(window.Range[i][0], edges[i][0]);
    window.Range[i][1] = std::min(window.Range[i][1], edges[i][1]);
  }
  return window.Range[0][0] < window.Range[0][1] && window.Range[1][0] < window.Range[1][1];
}

double LightBufferProjection::GetVoxelSpacing(const glm::dvec3& direction, double extent) const
{
  double spacing = std::numeric_limits<double>::max();
  for (const SlicePlan::SlicedVolume& volume : this->Volumes)
  {
    glm::dvec3 texels = volume.Space->GetTexels(direction);
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::array<double, 2>& range = volume.Box[axis];
      const double thickness = (range[1] - range[0]) * volume.Space->Size[axis];
      const bool isSeen = LargestAutomatic * thickness >= std::abs(texels[axis]) * extent;
      texels[axis] = isSeen ? texels[axis] : 0.0;
    }
    spacing = std::min(spacing, 1.0 / Vectors::SafeLength(texels));
  }
  return spacing;
}

int LightBufferProjection::GetSize(double texels, int smallest) const
{
  if (this->Settings.BufferSize > 0)
  {
    return std::max(
      std::min(this->Settings.BufferSize, this->Settings.LargestBufferSize), SmallestBuffer);
  }
  const double bounded =
    std::max(std::min(std::max(texels + 2.0 * Border, double(smallest)), double(LargestAutomatic)),
      double(this->Settings.MinimumBufferSize));
  const int rounded = static_cast<int>(std::ceil(bounded / Multiple)) * Multiple;
  return std::max(std::min(rounded, this->Settings.LargestBufferSize), SmallestBuffer);
}

void LightBufferProjection::FitPlanarBuffer(
  const LightSource& source, SlicePlan::ShadowedLight& light) const
{
  this->FitPlanarBuffer(source, light, 1.0, SmallestAutomatic);
}

void LightBufferProjection::FitPlanarBuffer(
  const LightSource& source, SlicePlan::ShadowedLight& light, double fineness, int smallest) const
{
  Window window = this->FitWindowToBoxes(source);
  Window screen;
  if (source.Projective && this->FitWindowToScreen(source, screen) &&
    GetArea(screen) < GetArea(window))
  {
    window = screen;
  }

  // Depth that BufferFromUnit maps to w = 1, and depth of the boxes' center.
  double depth = 1.0;
  double centerDepth = 1.0;
  if (window.IsPerspective)
  {
    centerDepth = std::abs(glm::dot(this->Center - window.Origin, window.Axis));
    depth = this->Corners.GetRange(window.Axis)[1] - glm::dot(window.Origin, window.Axis);
    depth = depth > 0.0 ? depth : 1.0;
  }

  double texels = 0.0;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double extent = centerDepth * (window.Range[i][1] - window.Range[i][0]);
    texels = std::max(texels, extent / this->GetVoxelSpacing(window.Across[i], extent));
  }
  light.IsWide = false;
  light.BufferSize = this->GetSize(fineness * this->Settings.TexelsOfVoxel * texels, smallest);
  light.BufferFromUnit = glm::dmat4(0.0);
  light.TexelSize = 0.0;
  light.VoxelLength = this->GetVoxelSpacing(window.Axis, 0.0);

  const double inner = 1.0 - 2.0 * Border / light.BufferSize;
  const double widest =
    std::max(window.Range[0][1] - window.Range[0][0], window.Range[1][1] - window.Range[1][0]);
  constexpr double narrowest = 1e-6;
  const auto setRow = [&](int row, const glm::dvec3& a, double constant)
  {
    light.BufferFromUnit =
      glm::row(light.BufferFromUnit, row, glm::dvec4(a, constant - glm::dot(a, window.Origin)));
  };
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double center = 0.5 * (window.Range[i][0] + window.Range[i][1]);
    const double half = 0.5 * std::max(window.Range[i][1] - window.Range[i][0], narrowest * widest);
    const double scale = inner / (half * depth);
    light.TexelSize = std::max(light.TexelSize, 2.0 / (scale * light.BufferSize));
    if (window.IsPerspective)
    {
      setRow(i, scale * window.Across[i] + (-scale * center) * window.Axis, 0.0);
    }
    else
    {
      setRow(i, scale * window.Across[i], -scale * center);
    }
  }
  if (window.IsPerspective)
  {
    setRow(3, (1.0 / depth) * window.Axis, 0.0);
  }
  else
  {
    light.BufferFromUnit[3][3] = 1.0;
  }
}

bool LightBufferProjection::PlanSoftShadows(
  const LightSource& source, const glm::dvec3& normal, SlicePlan::ShadowedLight& light) const
{
  const bool hasLayers = this->Settings.SoftMethod == SlicePlan::LAYERS;
  const int count = hasLayers ? this->Settings.Samples : CornerSamples;
  SlicePlan::ShadowedLight soft = light;
  if (hasLayers)
  {
    const double texels = 0.5 * this->Settings.SmallerImageSize / light.BufferSize;
    this->FitPlanarBuffer(
      source, soft, std::min(std::max(texels, 1.0), LargestFineness), SmallestWithLayers);
  }
  const std::vector<EmitterSamples::Sample> samples = EmitterSamples::Make(source, count);
  for (const EmitterSamples::Sample& sample : samples)
  {
    const LightSource placed = EmitterSamples::MakeSource(source, sample);
    for (const glm::dvec3& corner : this->Corners.Get())
    {
      const glm::dvec3 ray = GetRay(placed, corner);
      const double cosine = glm::dot(ray, normal);
      if (cosine < SlicePlan::SampleCosine)
      {
        return false;
      }
      const glm::dvec3 center = GetRay(source, corner);
      const double divergence =
        Vectors::SafeLength(ray / cosine - center / glm::dot(center, normal));
      // The size of a texel is proportional to the depth from the light.
      const double depth =
        glm::dot(GetRow(soft.BufferFromUnit, 3), corner) + soft.BufferFromUnit[3][3];
      const double spread = divergence / (soft.TexelSize * depth);
      const double distance =
        source.IsPositional ? glm::dot(corner - source.Position, normal) : 1.0;
      soft.Spread = std::max(soft.Spread, spread);
      soft.Divergence = std::max(soft.Divergence, spread * distance * distance);
    }
    if (hasLayers)
    {
      SlicePlan::ShadowedLight layer;
      this->FitPlanarBuffer(placed, layer);
      soft.Samples.push_back({ layer.BufferFromUnit, glm::dot(sample.Weight, glm::dvec3(1.0 / 3.0)),
        placed.GetHomogeneousPosition() });
    }
  }
  soft.SoftMethod = this->Settings.SoftMethod;
  soft.Center = source.GetHomogeneousPosition();
  light = soft;
  return true;
}

void LightBufferProjection::Refine(const LightSource& source, SlicePlan::ShadowedLight& light) const
{
  const double texels = double(this->Settings.SmallerImageSize) / light.BufferSize;
  const double fineness = std::min(texels, LargestFineness);
  if (fineness > 1.0)
  {
    this->FitPlanarBuffer(source, light, fineness, SmallestAutomatic);
  }
}

void LightBufferProjection::FitHalfSpaceBuffer(
  const glm::dvec3& normal, const glm::dvec3& position, SlicePlan::ShadowedLight& light) const
{
  const glm::dvec3 first = Perpendicular(normal, { 1.0, 0.0, 0.0 });
  const std::array<glm::dvec3, 3> axes{ { first, glm::cross(normal, first), normal } };
  double texels = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    std::copy_n(glm::value_ptr(axes[i]), 3, light.Frame.begin() + 3 * i);
    const std::array<double, 2> range = this->Corners.GetRange(axes[i]);
    const double height = glm::dot(position, axes[i]);
    const double farthest = std::max(range[1] - height, i < 2 ? height - range[0] : 0.0);
    // If the light is near a face of the box, few rays reach the farthest point, so the buffer is
    // not enlarged to resolve it.
    const double outside = std::max({ range[0] - height, height - range[1], 0.0 });
    const double reach = std::min(farthest, 0.7 * (range[1] - range[0]) + 2.0 * outside);
    texels = std::max(texels, reach / this->GetVoxelSpacing(axes[i], reach));
  }
  light.IsWide = true;
  light.BufferFromUnit = glm::dmat4(0.0);
  // The directions in a half space span an angle of pi.
  light.BufferSize = this->GetSize(vtkMath::Pi() * texels, SmallestAutomatic);
}

}
