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

/// Adds an actor for each part of a model. \a gain is the factor by which lights are stronger
/// because of the soft edges of volumes (EDGE_GAIN, or 1). Polygons have hard edges, so their
/// reflection is divided by \a gain. \a ambient is the ambient coefficient.
void AddModel(
  Panel& panel, const interlume::Model& model, double gain = 1.0, double ambient = 0.25);

/// Renders the panel with a vtkShadowedScenePass, without ambient occlusion: its surfaces and
/// volumes shadow each other. \a samples is the number of samples of area lights.
void UseSceneShadows(Panel& panel, int samples = 16);

/// Renders the panel's volumes at full resolution. At a lower resolution, solid volumes would leave
/// seams around surfaces.
void UseFullResolution(Panel& panel);

/// Adds a polygonal disk whose upper side is centered at \a top, as a ground that receives shadows.
/// For \a gain, see AddModel().
void AddGround(Panel& panel, const interlume::Position3& top, double radius, double gain = 1.0,
  const interlume::Position3& color = { { 0.90, 0.88, 0.84 } });
}

#endif
