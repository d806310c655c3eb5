#ifndef vtkFaceExtent_h
#define vtkFaceExtent_h

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

/**
 * @class   vtkFaceExtent
 * @brief   how wide a cell's face is, how far it is from flat, and where it looks to
 *
 * What is near to a face is near by its width, that of its narrow side: a triangle's least height,
 * a quadrilateral's area over its longest edge. A quadrilateral's bilinear form is nowhere further
 * than Bend from the triangles that either diagonal cuts it into.
 */
struct vtkFaceExtent
{
  double Width = 0.0;
  double Bend = 0.0;
  /// Of length 1, to either side; 0 for a face without an area.
  double Normal[3] = { 0.0, 0.0, 0.0 };

  /// Of three or four corners in cyclic order.
  static vtkFaceExtent Of(const double (*corners)[3], int number)
  {
    vtkFaceExtent extent;
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
    extent.Width = longest > 0.0 ? area / std::sqrt(longest) : 0.0;
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

#endif
