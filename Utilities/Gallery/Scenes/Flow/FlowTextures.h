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
 * Returns a texture with a grid of \a cellsU x \a cellsV cells, for texture coordinates from 0 to
 * 1. \a area is the color of the cells, \a line the color of the lines between them.
 */
vtkSmartPointer<vtkTexture> MakeGridTexture(
  int cellsU, int cellsV, const vtkColor3d& area, const vtkColor3d& line);

/**
 * Returns a texture with a dark opaque line at each integer of the first texture coordinate. The
 * second texture coordinate, from 0 to 1, selects one of \a colors for the areas between the lines.
 * These areas have the given \a opacity.
 */
vtkSmartPointer<vtkTexture> MakeStreamlineTexture(
  const std::vector<vtkColor3d>& colors, double opacity);
}

#endif
