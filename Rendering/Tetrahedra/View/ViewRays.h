// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ViewRays_h
#define interlume_ViewRays_h

#include "Common/Vectors.h"
#include "Mesh/TetrahedraMesh.h"

#include <array>

namespace interlume
{

/**
 * The view rays through the pixel centers of an image, in mesh coordinates. Pixel (i, j), counted
 * from the lower left, is at
 *
 *   x = Center[0] + (2 (i + 1/2) / Width - 1) HalfSize[0],
 *   y = Center[1] + (2 (j + 1/2) / Height - 1) HalfSize[1].
 *
 * In perspective, its view ray is Eye + t (Direction + x Right + y Up) for t > 0. In parallel
 * projection, its view ray is Eye + x Right + y Up + t Direction for any t. Eye and Direction are
 * members of Viewpoint. Right and Up need not be perpendicular or of unit length, because a
 * transformation of the mesh may distort them. Direction, Right and Up must not be coplanar.
 */
struct ViewRays
{
  interlume::Viewpoint Viewpoint;
  glm::dvec3 Right{ 1.0, 0.0, 0.0 };
  glm::dvec3 Up{ 0.0, 1.0, 0.0 };
  /// Half the image's width and height. They are tangents of half the view angles in perspective,
  /// and lengths in parallel projection.
  std::array<double, 2> HalfSize{ { 1.0, 1.0 } };
  /// The image center, in the units of HalfSize. It is not 0 for shifted windows and tiles.
  std::array<double, 2> Center{ { 0.0, 0.0 } };
  /// The image size in pixels; 0 for a view without an image.
  int Width = 0;
  int Height = 0;
};

}

#endif
