// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FaceLinks_h
#define interlume_FaceLinks_h

#include "Common/ArrayRows.h"

#include "vtkType.h"

#include <algorithm>
#include <cfloat>
#include <functional>
#include <vector>

namespace interlume
{

/**
 * @class   FaceLinks
 * @brief   which faces of cells are the same, and how the coordinates of one are in the other's
 *
 * Faces are the same that have the same points, or points at the same coordinates, in the same
 * cyclic order: a grid that is closed on itself, or put together of blocks, goes on over the seam.
 * Coordinates are the same within Tolerance of the narrower cell's width (FaceExtent) and what
 * rounding may have done to them, of which no more than a tenth of the width counts: the last angle
 * of a closed grid is rarely the first one to the last bit. They are compared of the faces that
 * match none by their points' ids. Faces of three or more cells match none. A quadrilateral does
 * not match two triangles.
 *
 * Coordinates (u,v) are those of CellShape::Face.
 */
class FaceLinks
{
public:
  static constexpr int MaximumPerBlock = 6;
  static constexpr double Tolerance = 1e-3;

  /// The number of pairs of faces whose coordinates are not the same to the last bit, and the
  /// largest distance between corners of such faces, in widths of the cell.
  struct Joins
  {
    vtkIdType Number = 0;
    double LargestGap = 0.0;
  };

  /// Faces that are asked for together, such as those of a cell; a face with 0 corners is none.
  struct Block
  {
    int Corners[MaximumPerBlock];
    vtkIdType Points[MaximumPerBlock][4];
  };
  /// A function that fills a block, called by several threads.
  using FillBlock = std::function<void(vtkIdType number, Block& block)>;

  /// A function that gives the points of a face's cell, and returns how many.
  using CellPoints = std::function<int(vtkIdType face, vtkIdType* points)>;

  /// A link to another face, and how its corners lie: corner i is corner \a Start + i, or \a Start
  /// - i, of this one. Gap is the largest distance between corners, in widths of the cell.
  struct Link
  {
    vtkIdType Face;
    int Start;
    bool IsReversed;
    double Gap = 0.0;
  };
  /// A function that is called once for each face that has another, by several threads, but never
  /// twice for one face.
  using SetLink = std::function<void(vtkIdType face, const Link& link)>;

  /**
   * Finds the links. \a cells gives at most eight points of the cell of a face, by which its width
   * is known; several threads ask it, for those faces only that match none by their points' ids.
   *
   * Face i of block b has the number b times \a facesPerBlock + i. \a positions are the positions
   * of the points.
   */
  static Joins Find(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
    const CellPoints& cells, const ArrayRows& positions, const SetLink& setLink);

  /// Finds the links between faces that have the same points, by their ids, alone.
  static void FindByPoints(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
    vtkIdType numberOfPoints, const SetLink& setLink);

  /// Returns the largest distance at which corners are the same, for the width of a cell, the
  /// largest coordinate, and what rounding may have done to it.
  static double GetTolerance(double width, double largest, double rounding)
  {
    return std::min(Tolerance * width + 64.0 * DBL_EPSILON * largest + 4.0 * rounding, 0.1 * width);
  }

  /// Maps (u,v) in a face of three or four corners to (u,v) in the linked one.
  static void Map(int corners, int start, bool isReversed, double uv[2])
  {
    const int way = isReversed ? corners - 1 : 1;
    const int second = (start + way) % corners;
    const int last = (start + (corners - 1) * way) % corners;
    const double u = uv[0];
    const double v = uv[1];
    if (corners == 3)
    {
      const double weights[3] = { 1.0 - u - v, u, v };
      uv[0] = weights[second];
      uv[1] = weights[last];
      return;
    }
    uv[0] = GetAlong(start, second, u, v);
    uv[1] = GetAlong(start, last, u, v);
  }

private:
  // Returns the coordinate that is 0 at one corner of [0,1]^2 and 1 at the next.
  static double GetAlong(int from, int to, double u, double v)
  {
    constexpr int us[4] = { 0, 1, 1, 0 };
    constexpr int vs[4] = { 0, 0, 1, 1 };
    if (us[from] != us[to])
    {
      return us[from] ? 1.0 - u : u;
    }
    return vs[from] ? 1.0 - v : v;
  }
};

}

#endif
