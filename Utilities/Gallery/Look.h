// SPDX-License-Identifier: BSD-3-Clause
#ifndef Look_h
#define Look_h

#include "vtkColor.h"
#include "vtkColorTransferFunction.h"
#include "vtkSmartPointer.h"

class vtkLight;
class vtkRenderer;

/**
 * Background, text color, lights and color maps that all images of the gallery share.
 */
namespace gallery
{
/// Returns the default background color.
vtkColor3d Background();

/// Returns a dark background color for volumes with additive blending. Their bright parts become
/// white, which would not be visible on a light background.
vtkColor3d DarkBackground();

/// Returns the color of text.
vtkColor3d TextColor();

/// Returns the color of outlines and of surfaces that only provide context.
vtkColor3d OutlineColor();

/**
 * Returns the color of interval \a i, 0 to 5. The six hues have similar saturation and remain
 * distinguishable for color-blind readers and in grayscale.
 */
vtkColor3d IntervalColor(int i);

enum class Map
{
  /// For magnitudes: dark blue, green, yellow.
  Viridis,
  /// For magnitudes such as temperatures: purple, red, yellow.
  Inferno,
  /// For signed values: blue, gray, red.
  CoolWarm
};

/**
 * Returns a color map over [lower, upper].
 */
vtkSmartPointer<vtkColorTransferFunction> MakeColorMap(Map map, double lower, double upper);

/**
 * Returns a light that moves with the camera. The position is in camera coordinates, and the light
 * points at the focal point of the camera.
 */
vtkSmartPointer<vtkLight> MakeCameraLight(double x, double y, double z, double intensity);

/**
 * Sets the background and the lights of \a renderer: a key light from the upper left, a weaker fill
 * light from the right, and a headlight. The lights move with the camera.
 */
void ApplyLook(vtkRenderer* renderer);
}

#endif
