// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowTextures_h
#define FlowTextures_h

#include "vtkColor.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

/**
 * Textures for stream and time surfaces.
 */
namespace gallery
{
/**
 * Returns a texture with a grid of \a cellsU x \a cellsV cells, for texture coordinates from 0 to
 * 1. \a area is the color of the cells, \a line the color of the lines between them. The cells have
 * the given \a opacity, and the lines are opaque. There are no lines along u if \a cellsV is 0.
 */
vtkSmartPointer<vtkTexture> MakeGridTexture(
  int cellsU, int cellsV, const vtkColor3d& area, const vtkColor3d& line, double opacity = 1.0);
}

#endif
