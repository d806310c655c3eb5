// SPDX-License-Identifier: BSD-3-Clause
#ifndef SoftShadows_h
#define SoftShadows_h

#include "Gallery/Scenes/Light/ShadowScene.h"

/**
 * What scenes in the light of a disk share.
 */
namespace gallery
{
/**
 * The lights, those that cast shadows as round lights of \a diameter.
 */
Lights MakeRoundLights(const Lights& lights, double diameter);

/// The two panels of a pair that shows what an extended light changes.
struct SoftPair
{
  Panel& Hard;
  Panel& Soft;

  /// Both from the same side, framed alike; up is z.
  void Look(const vtkVector3d& from, const vtkBoundingBox& frame) const;
};

/**
 * Adds \a image in the light of points, and in that of round lights of \a diameter in their place,
 * at the same camera.
 * \a lightBuffer is the size of the round light's buffer: flat and steep surfaces need more.
 */
SoftPair AddSoftPair(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double diameter, double surfaceGradient = 0.0, int lightBuffer = 320);
}

#endif
