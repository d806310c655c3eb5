// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedScene_h
#define MixedScene_h

#include "Support/Images/ReferenceLightSource.h" // for the points of lights
#include "Support/Images/ShadowScene.h"          // for the volumes

#include <functional>
#include <vector>

namespace reference
{

/**
 * An actor and its color function.
 */
struct SceneSurface
{
  vtkSmartPointer<vtkActor> Actor;
  /// Returns the ambient and diffuse color at a world position. If empty, the color of the actor's
  /// property is used.
  std::function<Double3(const Double3&)> Color;
};

/**
 * A light and the sample points from which it casts shadows. Without sample points, it casts
 * shadows from its position.
 */
struct SceneLight
{
  vtkSmartPointer<vtkLight> Light;
  std::vector<LightPoint> Points;
};

/**
 * Volumes and surfaces that share the same lights. Where volumes overlap, their extinctions are
 * added.
 */
struct MixedScene
{
  std::vector<SceneVolume> Volumes;
  std::vector<SceneSurface> Surfaces;
  std::vector<SceneLight> Lights;
  vtkSmartPointer<vtkCamera> Camera;
  bool Shadows = true;
  std::array<int, 2> Size = { { 64, 64 } };
  /// Maximum visible distance along the view ray of each pixel, bottom row first. If empty, there
  /// is no limit.
  std::vector<double> OpaqueDistance;
};

}

#endif
