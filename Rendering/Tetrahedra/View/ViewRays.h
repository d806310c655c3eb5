// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ViewRays_h
#define interlume_ViewRays_h

#include "Common/Vectors.h"
#include "Mesh/TetrahedraMesh.h"

#include <array>

namespace interlume
{

/**
 * The lines of sight through the centres of a picture's pixels, in the mesh's own coordinates.
 * Pixel (i, j), counted from the lower left, is at x = Center[0] + (2 (i + 1/2) / Width - 1)
 * HalfSize[0], y = Center[1] + (2 (j + 1/2) / Height - 1) HalfSize[1], and its line of sight is Eye
 * + t (Direction + x Right + y Up), t > 0, in perspective, Eye + x Right + y Up + t Direction, any
 * t, in parallel, with Eye and Direction of Viewpoint. Right and Up need not be of unit length or
 * perpendicular, as after a transformation of the mesh; the three axes must not lie in a plane.
 */
struct ViewRays
{
  interlume::Viewpoint Viewpoint;
  glm::dvec3 Right{ 1.0, 0.0, 0.0 };
  glm::dvec3 Up{ 0.0, 1.0, 0.0 };
  /// Half the picture's width and height: tangents of half the angles of view in perspective,
  /// lengths in parallel.
  std::array<double, 2> HalfSize{ { 1.0, 1.0 } };
  /// The picture's middle, in the same units: other than 0 for shifted windows and tiles.
  std::array<double, 2> Center{ { 0.0, 0.0 } };
  /// The number of pixels; 0 for a view without a picture.
  int Width = 0;
  int Height = 0;
};

}

#endif
