// SPDX-License-Identifier: BSD-3-Clause
#ifndef PathComparison_h
#define PathComparison_h

#include "Tetrahedra/MapperPicture.h" // for what is drawn

#include <string> // for names

namespace reference
{

class Check;

/**
 * Compares both render paths with each other and with the reference.
 *
 * Every pixel of the software path's picture is compared with the OpenGL path's. The reference
 * draws a lattice of pixels, and besides every pixel in which the two are more than a thousandth
 * apart, so that no pixel of the software path is off unless OpenGL is off alike.
 *
 * Expected are an error of the software path of 1e-3 at most, and paths that differ by 2/255 at
 * most but for silhouette pixels: OpenGL rounds corners to 1/256 of a pixel, so that a pixel whose
 * center is as near to the edge of a tetrahedron's silhouette can be on its other side. They are
 * at most a share of all.
 */
void ComparePaths(const PictureCase& what, const std::string& name, Check& check,
  double shareOfSilhouettePixels = 5e-4);

/// Compares those along both directions of each axis, in parallel and in perspective. The camera of
/// \a what is set.
void ComparePathsAlongAxes(
  PictureCase what, const std::string& name, Check& check, double shareOfSilhouettePixels = 5e-4);

}

#endif
