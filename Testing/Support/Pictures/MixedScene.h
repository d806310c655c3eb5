// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedScene_h
#define MixedScene_h

#include "Support/Pictures/ReferenceLightSource.h" // for the points of lights
#include "Support/Pictures/ShadowScene.h"          // for the volumes

#include <functional>
#include <vector>

namespace reference
{

/**
 * An ordinary actor, and how its colour varies.
 */
struct SceneSurface
{
  vtkSmartPointer<vtkActor> Actor;
  /// The ambient and diffuse colour of a place in the world; that of the actor's property where
  /// this is empty.
  std::function<Double3(const Double3&)> Color;
};

/**
 * A light, and the points of it that cast shadows; without any it is where its position is.
 */
struct SceneLight
{
  vtkSmartPointer<vtkLight> Light;
  std::vector<LightPoint> Points;
};

/**
 * Volumes and surfaces under the same lights. Volumes may overlap: their extinctions add up.
 */
struct MixedScene
{
  std::vector<SceneVolume> Volumes;
  std::vector<SceneSurface> Surfaces;
  std::vector<SceneLight> Lights;
  vtkSmartPointer<vtkCamera> Camera;
  bool Shadows = true;
  std::array<int, 2> Size = { { 64, 64 } };
  /// The distance along each pixel's line of sight beyond which nothing is seen, rows from the
  /// bottom; empty for no such limit.
  std::vector<double> OpaqueDistance;
};

}

#endif
