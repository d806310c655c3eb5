// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowTextures_h
#define FlowTextures_h

#include "vtkColor.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <vector>

/**
 * Textures for stream and time surfaces.
 */
namespace gallery
{
/**
 * Squares of one colour and lines between them, \a cellsU x \a cellsV, over parameters 0 to 1.
 */
vtkSmartPointer<vtkTexture> MakeGridTexture(
  int cellsU, int cellsV, const vtkColor3d& area, const vtkColor3d& line);

/**
 * A dark line at each whole number of the first coordinate, on the colour that the second chooses:
 * those of \a colours at the middles of as many equal parts of 0 to 1. The colours have \a opacity,
 * the lines are opaque.
 */
vtkSmartPointer<vtkTexture> MakeStreamlineTexture(
  const std::vector<vtkColor3d>& colours, double opacity);
}

#endif
