// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SilhouetteRows_h
#define interlume_SilhouetteRows_h

#include "View/TetrahedronSilhouette.h"

#include <algorithm>
#include <limits>

namespace interlume
{

/**
 * @class   SilhouetteRows
 * @brief   rasterizes a silhouette row by row
 *
 * A pixel is inside the silhouette if its center is. A center on the shared edge of two silhouettes
 * belongs to the right or upper one. Both silhouettes compute the same intersections of rows with
 * the edge, so no pixel is drawn twice or missed.
 */
class SilhouetteRows
{
public:
  explicit SilhouetteRows(const TetrahedronSilhouette& shape)
    : Size(shape.GetNumberOfEdges())
  {
    for (int i = 0; i < this->Size; ++i)
    {
      const auto* a = &shape.GetPoint(i);
      const auto* b = &shape.GetPoint((i + 1) % this->Size);
      // Start at the lower end, so that neighboring silhouettes round in the same way.
      if (b->Y < a->Y || (b->Y == a->Y && b->X < a->X))
      {
        std::swap(a, b);
      }
      this->Edges[i] = { a->Y, b->Y, a->X, (b->X - a->X) / (b->Y - a->Y) };
      this->Low = std::min(this->Low, a->Y);
      this->High = std::max(this->High, b->Y);
    }
  }

  /// Return the first row and the row after the last, relative to \a bottom. Both are at least 0,
  /// and the latter is at most \a height.
  int GetBegin(int bottom) const
  {
    return GetCeiling(this->Low - 0.5 - bottom, std::numeric_limits<int>::max());
  }
  int GetEnd(int bottom, int height) const { return GetCeiling(this->High - 0.5 - bottom, height); }

  /// Computes the first pixel and the pixel after the last in the row whose center is at \a y,
  /// relative to \a left, clamped to the range from 0 to \a width.
  void GetSpan(double y, int left, int width, int& begin, int& end) const
  {
    double first = std::numeric_limits<double>::max();
    double last = std::numeric_limits<double>::lowest();
    for (int i = 0; i < this->Size; ++i)
    {
      const Edge& edge = this->Edges[i];
      if (edge.Low <= y && y < edge.High)
      {
        const double x = edge.X + (y - edge.Low) * edge.Slope;
        first = std::min(first, x);
        last = std::max(last, x);
      }
    }
    begin = GetCeiling(first - 0.5 - left, width);
    end = GetCeiling(last - 0.5 - left, width);
  }

private:
  struct Edge
  {
    double Low;
    double High;
    double X;
    double Slope;
  };

  // Returns the ceiling, clamped to [0, limit]. This is faster than std::ceil, which may compile to
  // a function call.
  static int GetCeiling(double value, int limit)
  {
    if (!(value > 0.0))
    {
      return 0;
    }
    if (value >= limit)
    {
      return limit;
    }
    const int truncated = static_cast<int>(value);
    return truncated + (truncated < value ? 1 : 0);
  }

  int Size;
  std::array<Edge, 4> Edges;
  double Low = std::numeric_limits<double>::max();
  double High = std::numeric_limits<double>::lowest();
};

}

#endif
