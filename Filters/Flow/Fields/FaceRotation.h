// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceRotation_h
#define interlume_FaceRotation_h

#include "Fields/FaceLinks.h"

#include <algorithm>

namespace interlume
{

/**
 * @class   FaceRotation
 * @brief   rotation of a face's corners relative to a canonical order
 *
 * The canonical order is the lexicographically smallest among all cyclic orders in both directions.
 * It is the same for all faces with the same points. Its corner i is corner Start + i of the face,
 * or Start - i if IsReversed.
 */
struct FaceRotation
{
  signed char Corners;
  signed char Start;
  bool IsReversed;

  /// Computes the rotation of a face. \a ordered receives the points in canonical order.
  static FaceRotation Order(const vtkIdType* points, int corners, vtkIdType* ordered)
  {
    int start = 0;
    bool isRepeated = false;
    for (int corner = 1; corner < corners; ++corner)
    {
      isRepeated =
        points[corner] == points[start] || (isRepeated && points[corner] > points[start]);
      start = points[corner] < points[start] ? corner : start;
    }
    const vtkIdType next = points[start + 1 < corners ? start + 1 : 0];
    const vtkIdType previous = points[start > 0 ? start - 1 : corners - 1];
    FaceRotation rotation = Rotate(points, corners, start, next > previous, ordered);
    // In a collapsed cell, the smallest point id may be repeated.
    for (int other = start + 1; isRepeated && other < corners; ++other)
    {
      for (const bool isReversed : { false, true })
      {
        vtkIdType candidate[4];
        const FaceRotation found = Rotate(points, corners, other, isReversed, candidate);
        if (points[other] == points[start] &&
          std::lexicographical_compare(candidate, candidate + corners, ordered, ordered + corners))
        {
          rotation = found;
          std::copy(candidate, candidate + corners, ordered);
        }
      }
    }
    return rotation;
  }

  /// Returns the link from a face with the rotation \a from to the face \a other, which has the
  /// same points and the rotation \a to.
  static FaceLinks::Link GetLink(const FaceRotation& from, const FaceRotation& to, vtkIdType other)
  {
    // Corner i of the other face is corner i - to.Start, or to.Start - i, in canonical order.
    const bool isReversed = from.IsReversed != to.IsReversed;
    const int start = isReversed ? from.Start + to.Start : from.Start - to.Start + from.Corners;
    return { other, start % from.Corners, isReversed };
  }

private:
  static FaceRotation Rotate(
    const vtkIdType* points, int corners, int start, bool isReversed, vtkIdType* turned)
  {
    int corner = start;
    for (int i = 0; i < corners; ++i)
    {
      turned[i] = points[corner];
      corner = isReversed ? (corner > 0 ? corner - 1 : corners - 1)
                          : (corner + 1 < corners ? corner + 1 : 0);
    }
    return { static_cast<signed char>(corners), static_cast<signed char>(start), isReversed };
  }
};

}

#endif
