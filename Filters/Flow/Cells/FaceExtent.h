// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceExtent_h
#define interlume_FaceExtent_h

#include "Cells/MultilinearCell.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

/**
 * @class   FaceExtent
 * @brief   how wide a cell is at one of its faces, how far the face is from flat, where it looks to
 *
 * Nearness to a face is measured in the cell's width there: the narrow side of the face, which is a
 * triangle's least height or a quadrilateral's area over its longest edge, or the height of the
 * cell above the face, whichever is less. A quadrilateral's bilinear form is nowhere further than
 * Bend from the triangles that either diagonal cuts it into.
 */
struct FaceExtent
{
  double Width = 0.0;
  double Bend = 0.0;
  /// The normal of length 1, to either side; 0 for a face without an area.
  double Normal[3] = { 0.0, 0.0, 0.0 };

  /**
   * Computes the extent from the three or four corners of a face in cyclic order, and any number of
   * corners of its cell.
   */
  static FaceExtent Of(const double (*corners)[3], int number, const double (*cell)[3], int size)
  {
    FaceExtent extent;
    double longest = 0.0;
    for (int i = 0; i < number; ++i)
    {
      longest = std::max(
        longest, Vectors::SafeLength(Vectors::Difference(corners[i], corners[(i + 1) % number])));
    }
    // The diagonals of a quadrilateral, two edges of a triangle, at a length of about 1, so that
    // the square of their product is a number.
    const double scale = MultilinearCell::GetScale(longest);
    const glm::dvec3 product = glm::cross(scale * Vectors::Difference(corners[2], corners[0]),
      scale * Vectors::Difference(corners[number - 1], corners[1]));
    const double length = glm::length(product);
    for (int axis = 0; axis < 3 && length > 0.0; ++axis)
    {
      extent.Normal[axis] = product[axis] / length;
    }
    const double area = length * (number == 4 ? 0.5 : 1.0);
    double height = 0.0;
    for (int i = 0; i < size; ++i)
    {
      const glm::dvec3 above = Vectors::Difference(cell[i], corners[0]);
      height = std::max(height, std::abs(glm::dot(above, glm::make_vec3(extent.Normal))));
    }
    extent.Width = longest > 0.0 ? std::min(area / (scale * longest) / scale, height) : 0.0;
    if (number == 4)
    {
      extent.Bend = 0.25 *
        Vectors::SafeLength(Vectors::Difference(corners[0], corners[1]) +
          Vectors::Difference(corners[2], corners[3]));
    }
    return extent;
  }
};

}

#endif
