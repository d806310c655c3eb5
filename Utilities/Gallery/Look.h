// SPDX-License-Identifier: BSD-3-Clause
#ifndef Look_h
#define Look_h

#include "vtkColor.h"
#include "vtkColorTransferFunction.h"
#include "vtkSmartPointer.h"

class vtkRenderer;

/**
 * The one look of all pictures of the gallery: background, ink, light, colour maps.
 */
namespace gallery
{
/// Colour of the background, the same in every picture.
vtkColor3d Background();

/// Colour behind volumes whose colours are added up: dark, so that white can be told from nothing.
vtkColor3d DarkBackground();

/// Colour of text.
vtkColor3d Ink();

/// Colour of outlines and of surfaces that are there for orientation only.
vtkColor3d Pencil();

/**
 * Colour of interval \a i, 0 to 5: six hues of about the same strength that stay distinct for
 * colour-blind readers and in grey.
 */
vtkColor3d IntervalColour(int i);

enum class Map
{
  /// Magnitudes: dark blue over green to yellow.
  Viridis,
  /// Magnitudes of something hot: purple over red to yellow.
  Inferno,
  /// Signed values: blue over grey to red.
  CoolWarm
};

/**
 * The colour map over [lower, upper].
 */
vtkSmartPointer<vtkColorTransferFunction> MakeColourMap(Map map, double lower, double upper);

/**
 * Background and lights: a key light from above and one side so that form reads, a weak fill from
 * the other side. The lights move with the camera.
 */
void ApplyLook(vtkRenderer* renderer);
}

#endif
