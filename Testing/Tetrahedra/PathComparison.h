// SPDX-License-Identifier: BSD-3-Clause
#ifndef PathComparison_h
#define PathComparison_h

#include "Tetrahedra/MapperImage.h" // for ImageCase

#include <string> // for names

namespace reference
{

class Check;

/**
 * Compares both render paths with each other and with the reference.
 *
 * All pixels of the two paths are compared. The reference computes a regular subset of pixels, and
 * every pixel in which the paths differ by more than 1e-3. Therefore, an error can only remain
 * undetected if it occurs in both paths.
 *
 * The error of the software path must be at most 1e-3. The paths may differ by more than 2/255
 * only in silhouette pixels: OpenGL rounds corners to 1/256 pixel, so a silhouette edge may lie on
 * the other side of a pixel's center. The fraction of these pixels is limited.
 */
void CompareRenderPaths(
  const ImageCase& what, const std::string& name, Check& check, double silhouetteFraction = 5e-4);

/// Compares the paths along both directions of each axis, in parallel and perspective projection.
/// The camera of \a what is replaced.
void CompareRenderPathsAlongAxes(
  ImageCase what, const std::string& name, Check& check, double silhouetteFraction = 5e-4);

}

#endif
