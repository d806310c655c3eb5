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
 * @brief   finds pairs of equal cell faces and the mapping between their face coordinates
 *
 * Two faces are equal if they have the same points, or points at equal positions, in the same or
 * reverse cyclic order. Therefore periodic and multi-block grids are continuous across their seams.
 * Positions are equal if their distance is at most Tolerance times the width of the narrower cell
 * (FaceExtent) plus rounding error, and at most a tenth of the width. The tolerance is needed
 * because the first and last points of a closed grid rarely coincide exactly. Positions are only
 * compared for faces without a match by point ids. If three or more cells share a face, none of
 * their faces match. A quadrilateral does not match two triangles.
 *
 * CellShape::Face defines the face coordinates (u,v).
 */
class FaceLinks
{
public:
  static constexpr int MaximumPerBlock = 6;
  static constexpr double Tolerance = 1e-3;

  /// Number of matched face pairs whose corner positions differ, and the largest distance between
  /// matched corners, in cell widths.
  struct MatchGaps
  {
    vtkIdType Number = 0;
    double LargestGap = 0.0;
  };

  /// Faces processed together, such as the faces of a cell. A face with 0 corners is unused.
  struct Block
  {
    int Corners[MaximumPerBlock];
    vtkIdType Points[MaximumPerBlock][4];
  };
  /// Callback that fills a block. Several threads may call it at the same time.
  using FillBlock = std::function<void(vtkIdType number, Block& block)>;

  /// Callback that writes the point ids of the cell to which a face belongs, at most eight, to
  /// \a points and returns their number.
  using CellPoints = std::function<int(vtkIdType face, vtkIdType* points)>;

  /// Link to another face. Corner i of the other face is corner \a Start + i of this face, or
  /// \a Start - i if \a IsReversed, modulo the number of corners. \a Gap is the largest distance
  /// between matched corners, in cell widths.
  struct Link
  {
    vtkIdType Face;
    int Start;
    bool IsReversed;
    double Gap = 0.0;
  };
  /// Callback for matched faces. Several threads may call it at the same time, but only once per
  /// face.
  using SetLink = std::function<void(vtkIdType face, const Link& link)>;

  /**
   * Finds the links. \a cells returns the points that determine the width of a face's cell. Several
   * threads call it, and only for faces without a match by point ids.
   *
   * Face i of block b has the index b times \a facesPerBlock + i. \a positions holds the positions
   * of the points.
   */
  static MatchGaps Find(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
    const CellPoints& cells, const ArrayRows& positions, const SetLink& setLink);

  /// Finds only the links between faces with equal point ids.
  static void FindByPoints(vtkIdType numberOfBlocks, int facesPerBlock, const FillBlock& fill,
    vtkIdType numberOfPoints, const SetLink& setLink);

  /// Returns the distance up to which corners count as equal. \a largest is the largest absolute
  /// coordinate, and \a rounding the rounding error of float coordinates.
  static double GetTolerance(double width, double largest, double rounding)
  {
    return std::min(Tolerance * width + 64.0 * DBL_EPSILON * largest + 4.0 * rounding, 0.1 * width);
  }

  /// Maps (u,v) in a face with three or four corners to (u,v) in the linked face.
  static void Map(int corners, int start, bool isReversed, double uv[2])
  {
    const int step = isReversed ? corners - 1 : 1;
    const int second = (start + step) % corners;
    const int last = (start + (corners - 1) * step) % corners;
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
  // Returns the coordinate of (u,v) along an edge of [0,1]^2. It is 0 at corner \a from and 1 at
  // corner \a to.
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
