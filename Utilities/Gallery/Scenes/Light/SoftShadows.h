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
 * Returns \a lights with each shadow-casting light replaced by a disk light of \a diameter.
 */
Lights MakeDiskLights(const Lights& lights, double diameter);

/// Two panels of the same volume, with hard and with soft shadows.
struct SoftShadowPair
{
  Panel& Hard;
  Panel& Soft;

  /// Sets the same view direction and framing in both panels. z is up.
  void Look(const vtkVector3d& from, const vtkBoundingBox& frame) const;

  /// Sets the same backdrop in both panels.
  void SetBackground(const vtkColor3d& lower, const vtkColor3d& upper) const;
};

/**
 * Adds two panels of \a image, one lit by \a lights, the other by disk lights of \a diameter at the
 * positions of shadow-casting lights. SoftShadowPair::Look() gives them a common camera. \a
 * lightBuffer is the size of the light buffers of disk lights. Flat surfaces, and surfaces at
 * grazing angles to the light, need larger buffers.
 */
SoftShadowPair AddSoftShadowPair(Stage& stage, vtkImageData* image, vtkVolumeProperty* property,
  const Lights& lights, double diameter, double surfaceGradient = 0.0, int lightBuffer = 320);
}

#endif
