// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelActors_h
#define ModelActors_h

#include "Support/Inputs/Models.h"

/**
 * Models of polygons on stage.
 */
namespace gallery
{
class Panel;

/// Adds an actor for each part. Where lights are stronger for the soft edges of matter, by
/// EDGE_GAIN, \a gain says so, and these surfaces, which have none, reflect that much less. \a
/// ambient is what is seen of colours without any light.
void AddModel(
  Panel& panel, const interlume::Model& model, double gain = 1.0, double ambient = 0.25);

/// The panel is drawn by a vtkShadowedScenePass, without ambient occlusion: its surfaces and
/// volumes shadow each other, under lights with an extent by so many samples.
void UseSceneShadows(Panel& panel, int samples = 16);

/// Gives the pictures of the panel's volumes all of its pixels: coarser ones of solid matter leave
/// rims around surfaces.
void UseFinePictures(Panel& panel);

/// Adds a disk of polygons whose upper side lies on \a top: a ground that catches shadows. \a gain
/// as for models.
void AddGround(Panel& panel, const interlume::Place3& top, double radius, double gain = 1.0);
}

#endif
