// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/AreaLightViews.h"

#include "ShadowMaps/ShadowMapViews.h"
#include "Space/UnitSpace.h"

#include "vtkAreaLight.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace interlume
{

namespace
{
using Axes = ShadowMapView::Axes;
using Window = ShadowMapView::Window;

/// Sine and cosine of 30 degrees, the angle that is added to the half angle of a light's cone.
constexpr double WIDER_SINE = 0.5;
constexpr double WIDER_COSINE = 0.866025403784438647;
/// Size of the filter that smooths a sample's shadow, as a fraction of the sample's part of the
/// emitter. Smaller values leave visible steps. A value of 1 makes penumbras slightly too wide.
constexpr double STRATUM = 0.8;
constexpr double MINIMUM_CONE_COSINE = 0.70710678118654752;

// Returns the tangent of a cone's half angle plus 30 degrees.
double GetWiderTangent(double cosine)
{
  const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
  return (sine * WIDER_COSINE + cosine * WIDER_SINE) / (cosine * WIDER_COSINE - sine * WIDER_SINE);
}
}

int AreaLightViews::GetResolution(int resolution, int samples)
{
  const int divisor =
    static_cast<int>(std::ceil(std::sqrt(std::sqrt(static_cast<double>(samples)))));
  return std::max(resolution / std::max(divisor, 1), 4);
}

void AreaLightViews::FindSamples(
  const LightSource& source, int samples, std::vector<Emitter>& before)
{
  const vtkMTimeType time = source.Area->GetMTime();
  const auto found = std::find_if(before.begin(), before.end(),
    [&](const Emitter& emitter)
    {
      return emitter.Source == source.Light && emitter.Time == time &&
        static_cast<int>(emitter.Samples.size()) == samples;
    });
  this->Emitters.push_back(found != before.end()
      ? std::move(*found)
      : Emitter{ source.Light, time, EmitterSamples::Make(source, samples) });
}

void AreaLightViews::AddWindow(Light& light, const Window& window, const glm::dvec3& offset,
  const glm::dvec3& weight, double unit)
{
  Sample sample;
  sample.Offset = offset;
  sample.Scale = 2.0 * unit / glm::dvec2(window.Right.GetSize(), window.Up.GetSize());
  sample.Center = glm::dvec2(window.Right.GetCenter(), window.Up.GetCenter()) / unit;
  sample.Weight = weight;
  this->Samples.push_back(sample);
  ++light.Samples;
}

void AreaLightViews::FitDirectional(const LightSource& source, const UnitSpace& space,
  const std::vector<glm::dvec3>& corners, int resolution, Light& light)
{
  const Axes axes(source.Direction);
  this->Sides.push_back(axes);
  for (const EmitterSamples::Sample& sample : this->Emitters.back().Samples)
  {
    const glm::dvec3 direction = EmitterSamples::MakeSource(source, sample).Direction;
    const double along = glm::dot(direction, axes.Along);
    const glm::dvec2 shear(
      glm::dot(direction, axes.Right) / along, glm::dot(direction, axes.Up) / along);
    const Window window =
      ShadowMapView::FindWindow(space.Center, axes, shear, corners, space.Radius);
    light.Depth = window.GetDepth(false) * glm::dvec2(1.0, space.Radius);
    this->AddWindow(light, window, glm::dvec3(shear, 0.0), sample.Weight, space.Radius);
    this->Views.push_back(ShadowMapView::Make(space.Center, axes, window, false, resolution));
  }
}

void AreaLightViews::FitPositional(const LightSource& source, const UnitSpace& space,
  const std::vector<glm::dvec3>& corners, int resolution, Light& light)
{
  const std::vector<EmitterSamples::Sample>& samples = this->Emitters.back().Samples;
  light.Position = source.Position;
  const glm::dvec3 center = space.Center + space.Radius * source.Position;
  glm::dvec3 meanOffset(0.0);
  for (const glm::dvec3& corner : corners)
  {
    meanOffset += (corner - center) / static_cast<double>(corners.size());
  }
  const Axes toward(UnitVector::Normalize(meanOffset, source.Direction));
  std::vector<glm::dvec3> positions;
  std::vector<Window> windows(samples.size());
  Window all;
  double farthest = 0.0;
  bool isSeen = true;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    positions.push_back(
      space.Center + space.Radius * EmitterSamples::MakeSource(source, samples[i]).Position);
    isSeen = ShadowMapView::FindWindow(positions[i], toward, corners, windows[i]) && isSeen;
    all.Along.Add(windows[i].Along.First);
    all.Along.Add(windows[i].Along.Last);
    for (const glm::dvec3& corner : corners)
    {
      farthest = std::max(farthest, Vectors::SafeLength(corner - positions[i]));
    }
  }
  farthest *= 1.0 + ShadowMapView::Margin;
  if (isSeen)
  {
    all.AddDepthMargins(farthest);
    this->Sides.push_back(toward);
  }
  else if (source.ConeCosine >= MINIMUM_CONE_COSINE)
  {
    all.SetCone(farthest, GetWiderTangent(source.ConeCosine), resolution);
    this->Sides.emplace_back(source.Direction);
  }
  else
  {
    all.SetCubeFace(farthest, resolution);
    light.Sides = 6;
    for (int side = 0; side < light.Sides; ++side)
    {
      this->Sides.emplace_back(ShadowMapView::GetSide(side));
    }
  }
  light.Depth = all.GetDepth(true) / glm::dvec2(1.0, space.Radius);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    Window window = isSeen ? windows[i] : all;
    if (isSeen)
    {
      window.AddSideMargins(1e-6);
      window.Along = all.Along;
    }
    this->AddWindow(light, window, (positions[i] - center) / space.Radius, samples[i].Weight, 1.0);
    for (int side = 0; side < light.Sides; ++side)
    {
      const Axes& axes = this->Sides[static_cast<std::size_t>(light.FirstSide + side)];
      this->Views.push_back(ShadowMapView::Make(positions[i], axes, window, true, resolution));
    }
  }
}

void AreaLightViews::Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
  const std::vector<ShadowMapView::Box>& occluders, int resolution, int samples)
{
  this->Lights.clear();
  this->Samples.clear();
  this->Sides.clear();
  this->Views.clear();
  std::vector<Emitter> before = std::move(this->Emitters);
  this->Emitters.clear();
  const std::vector<glm::dvec3> corners = ShadowMapView::GetCorners(occluders);
  for (const LightSource& source : lights)
  {
    if (!ShadowMapViews::CastsShadows(source) || !source.Area || corners.empty())
    {
      continue;
    }
    this->FindSamples(source, samples, before);
    Light light;
    light.Source = source.Light;
    light.IsPositional = source.IsPositional;
    for (std::size_t i = 0; i < 2; ++i)
    {
      light.Stratum[i] = STRATUM / std::sqrt(static_cast<double>(samples)) * source.EmitterAxes[i];
    }
    light.FirstView = static_cast<int>(this->Views.size());
    light.FirstSample = static_cast<int>(this->Samples.size());
    light.FirstSide = static_cast<int>(this->Sides.size());
    if (source.IsPositional)
    {
      this->FitPositional(source, space, corners, resolution, light);
    }
    else
    {
      this->FitDirectional(source, space, corners, resolution, light);
    }
    this->Lights.push_back(light);
  }
}

int AreaLightViews::Find(vtkLight* light) const
{
  const auto found = std::find_if(this->Lights.begin(), this->Lights.end(),
    [light](const Light& other) { return other.Source == light; });
  return found == this->Lights.end() ? -1 : static_cast<int>(found - this->Lights.begin());
}

}
