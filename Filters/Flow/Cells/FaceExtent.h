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
 * @brief   width of a cell at one of its faces, deviation of the face from a plane, and the face
 * normal
 *
 * The distance to a face is measured relative to Width. Width is the smaller of two lengths: the
 * narrow extent of the face and the height of the cell above the face. The narrow extent is the
 * smallest height of a triangle, or the area of a quadrilateral divided by its longest edge. The
 * bilinear surface of a quadrilateral deviates by at most Bend from its triangulation along either
 * diagonal.
 */
struct FaceExtent
{
  double Width = 0.0;
  double Bend = 0.0;
  /// Unit normal with arbitrary orientation, or 0 if the face has no area.
  double Normal[3] = { 0.0, 0.0, 0.0 };

  /**
   * Computes the extent from the \a number corners of a face (three or four, in cyclic order) and
   * the \a size corners of its cell.
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
    // Cross product of the diagonals of a quadrilateral, or of two edges of a triangle. These
    // vectors are scaled to a length of about 1, so that the product neither overflows nor
    // underflows.
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
