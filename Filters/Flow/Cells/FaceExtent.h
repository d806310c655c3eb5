// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceExtent_h
#define interlume_FaceExtent_h

#include "vtkMath.h"

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
      longest =
        std::max(longest, vtkMath::Distance2BetweenPoints(corners[i], corners[(i + 1) % number]));
    }
    // The diagonals of a quadrilateral, two edges of a triangle.
    double across[2][3];
    vtkMath::Subtract(corners[2], corners[0], across[0]);
    vtkMath::Subtract(corners[number - 1], corners[1], across[1]);
    vtkMath::Cross(across[0], across[1], extent.Normal);
    const double area = vtkMath::Normalize(extent.Normal) * (number == 4 ? 0.5 : 1.0);
    double height = 0.0;
    for (int i = 0; i < size; ++i)
    {
      double above[3];
      vtkMath::Subtract(cell[i], corners[0], above);
      height = std::max(height, std::abs(vtkMath::Dot(above, extent.Normal)));
    }
    extent.Width = longest > 0.0 ? std::min(area / std::sqrt(longest), height) : 0.0;
    if (number == 4)
    {
      double squared = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double bend =
          (corners[0][axis] - corners[1][axis]) + (corners[2][axis] - corners[3][axis]);
        squared += bend * bend;
      }
      extent.Bend = 0.25 * std::sqrt(squared);
    }
    return extent;
  }
};

}

#endif
