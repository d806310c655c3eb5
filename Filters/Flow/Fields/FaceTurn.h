// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceTurn_h
#define interlume_FaceTurn_h

#include "Fields/FaceLinks.h"

#include <algorithm>

namespace interlume
{

/**
 * @class   FaceTurn
 * @brief   the turn of a face's corners against the order that all faces of the same points share
 *
 * That order is the smallest, by comparison from the first point on, of those that go around the
 * face either way: corner i of it is the face's corner Start + i, or Start - i.
 */
struct FaceTurn
{
  signed char Corners;
  signed char Start;
  bool IsReversed;

  /// Computes the turn of a face; \a ordered gets the points in the shared order.
  static FaceTurn Order(const vtkIdType* points, int corners, vtkIdType* ordered)
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
    FaceTurn turn = Turn(points, corners, start, next > previous, ordered);
    // Where a cell has collapsed, the least point may come twice.
    for (int other = start + 1; isRepeated && other < corners; ++other)
    {
      for (const bool isReversed : { false, true })
      {
        vtkIdType candidate[4];
        const FaceTurn found = Turn(points, corners, other, isReversed, candidate);
        if (points[other] == points[start] &&
          std::lexicographical_compare(candidate, candidate + corners, ordered, ordered + corners))
        {
          turn = found;
          std::copy(candidate, candidate + corners, ordered);
        }
      }
    }
    return turn;
  }

  /// Returns the link from a face to \a other, which has the same points in that order and is
  /// turned by \a to.
  static FaceLinks::Link GetLink(const FaceTurn& from, const FaceTurn& to, vtkIdType other)
  {
    // Corner i of the other face is corner i - to.Start, or to.Start - i, in the shared order.
    const bool isReversed = from.IsReversed != to.IsReversed;
    const int start = isReversed ? from.Start + to.Start : from.Start - to.Start + from.Corners;
    return { other, start % from.Corners, isReversed };
  }

private:
  static FaceTurn Turn(
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
