// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/ShadowMapViews.h"

#include "Space/UnitSpace.h"

#include "vtkLight.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
using Axes = ShadowMapView::Axes;
using Window = ShadowMapView::Window;

ShadowMapView FitDirectional(
  const glm::dvec3& direction, const std::vector<glm::dvec3>& corners, double size, int resolution)
{
  const Axes axes(direction);
  glm::dvec3 origin(0.0);
  for (const glm::dvec3& corner : corners)
  {
    origin += corner / static_cast<double>(corners.size());
  }
  const Window window = ShadowMapView::FindWindow(origin, axes, glm::dvec2(0.0), corners, size);
  return ShadowMapView::Make(origin, axes, window, false, resolution);
}

void FitPositional(const LightSource& source, const UnitSpace& space,
  const std::vector<glm::dvec3>& corners, int resolution, std::vector<ShadowMapView>& views)
{
  const glm::dvec3 position = space.Center + space.Radius * source.Position;
  double farthest = 0.0;
  glm::dvec3 meanOffset(0.0);
  for (const glm::dvec3& corner : corners)
  {
    farthest = std::max(farthest, Vectors::SafeLength(corner - position));
    meanOffset += (corner - position) / static_cast<double>(corners.size());
  }
  farthest *= 1.0 + ShadowMapView::Margin;
  Window window;
  const Axes toward(UnitVector::Normalize(meanOffset, source.Direction));
  if (ShadowMapView::FindWindow(position, toward, corners, window))
  {
    window.AddSideMargins(1e-6);
    window.AddDepthMargins(farthest);
    views.push_back(ShadowMapView::Make(position, toward, window, true, resolution));
    return;
  }
  window = Window();
  if (source.ConeCosine > ShadowMapView::MinimumCosine)
  {
    const double tangent =
      std::sqrt(std::max(1.0 - source.ConeCosine * source.ConeCosine, 1e-12)) / source.ConeCosine;
    window.SetCone(farthest, tangent, resolution);
    views.push_back(
      ShadowMapView::Make(position, Axes(source.Direction), window, true, resolution));
    return;
  }
  window.SetCubeFace(farthest, resolution);
  for (int side = 0; side < 6; ++side)
  {
    views.push_back(
      ShadowMapView::Make(position, Axes(ShadowMapView::GetSide(side)), window, true, resolution));
  }
}
}

bool ShadowMapViews::CastsShadows(const LightSource& source)
{
  return source.ShadowStrength > 0.0 && !source.Light->LightTypeIsHeadlight();
}

void ShadowMapViews::Fit(const std::vector<LightSource>& lights, const UnitSpace& space,
  const std::vector<ShadowMapView::Box>& occluders, int resolution)
{
  this->Lights.clear();
  this->Views.clear();
  const std::vector<glm::dvec3> corners = ShadowMapView::GetCorners(occluders);
  for (const LightSource& source : lights)
  {
    if (!CastsShadows(source) || source.Area || corners.empty())
    {
      continue;
    }
    Light light;
    light.Source = source.Light;
    light.FirstView = static_cast<int>(this->Views.size());
    if (source.IsPositional)
    {
      FitPositional(source, space, corners, resolution, this->Views);
    }
    else
    {
      this->Views.push_back(FitDirectional(source.Direction, corners, space.Radius, resolution));
    }
    light.Views = static_cast<int>(this->Views.size()) - light.FirstView;
    this->Lights.push_back(light);
  }
}

const ShadowMapViews::Light* ShadowMapViews::Find(vtkLight* light) const
{
  const auto found = std::find_if(this->Lights.begin(), this->Lights.end(),
    [light](const Light& other) { return other.Source == light; });
  return found == this->Lights.end() ? nullptr : &*found;
}

}
