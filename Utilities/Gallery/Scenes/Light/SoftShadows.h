// SPDX-License-Identifier: BSD-3-Clause
#ifndef SoftShadows_h
#define SoftShadows_h

#include "Gallery/Scenes/Light/ShadowScene.h"

/**
 * Support for scenes with disk lights.
 */
namespace gallery
{
/**
 * Returns the lights, with shadow-casting lights replaced by disk lights of \a diameter.
 */
Lights MakeRoundLights(const Lights& lights, double diameter);

/// A pair of panels with hard and with soft shadows.
struct SoftPair
{
  Panel& Hard;
  Panel& Soft;

  /// Sets the same view direction and framing in both panels. z is up.
  void Look(const vtkVector3d& from, const vtkBoundingBox& frame) const;
};

/**
 * Adds \a image lit by point lights, and by disk lights of \a diameter at their positions, with a
 * common camera. \a lightBuffer is the size of the disk light's buffer. Flat and steep surfaces
 * need larger buffers.
 */
SoftPair AddSoftPair(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double diameter, double surfaceGradient = 0.0, int lightBuffer = 320);
}

#endif
