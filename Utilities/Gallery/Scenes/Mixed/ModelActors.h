// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelActors_h
#define ModelActors_h

#include "Support/Inputs/Models.h"

/**
 * Support for scenes with polygonal models.
 */
namespace gallery
{
class Panel;

/// Adds an actor for each part of a model. Diffuse and specular reflection are divided by \a gain.
/// Use EDGE_GAIN if the lights are intensified for the soft edges of volumes, since polygons have
/// hard edges. \a ambient is the ambient coefficient.
void AddModel(
  Panel& panel, const interlume::Model& model, double gain = 1.0, double ambient = 0.25);

/// Renders the panel with a vtkShadowedScenePass, without ambient occlusion: its surfaces and
/// volumes shadow each other. \a samples is the number of samples of area lights.
void UseSceneShadows(Panel& panel, int samples = 16);

/// Renders the panel's volumes at full resolution. At a lower resolution, solid volumes would leave
/// seams around surfaces.
void UseFullResolution(Panel& panel);

/// Adds a polygonal disk as the ground. Its upper side is centered at \a top. For \a gain, see
/// AddModel().
void AddGround(Panel& panel, const interlume::Position3& top, double radius, double gain = 1.0,
  const interlume::Position3& color = { { 0.90, 0.88, 0.84 } });
}

#endif
