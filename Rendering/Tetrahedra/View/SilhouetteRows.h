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
 * @brief   the pixels of a silhouette, row by row
 *
 * A pixel belongs to it if its centre does; a centre on an edge belongs to the right and the upper
 * one of both neighbours, which find the same crossing of row and edge.
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
      // An edge is taken from its lower end, whichever tetrahedron it is seen from.
      if (b->Y < a->Y || (b->Y == a->Y && b->X < a->X))
      {
        std::swap(a, b);
      }
      this->Edges[i] = { a->Y, b->Y, a->X, (b->X - a->X) / (b->Y - a->Y) };
      this->Low = std::min(this->Low, a->Y);
      this->High = std::max(this->High, b->Y);
    }
  }

  /// Return the first row and the one after the last, counted from \a bottom, of \a height.
  int GetBegin(int bottom) const
  {
    return GetCeiling(this->Low - 0.5 - bottom, std::numeric_limits<int>::max());
  }
  int GetEnd(int bottom, int height) const { return GetCeiling(this->High - 0.5 - bottom, height); }

  /// Computes the first pixel and the one after the last of the row with its centre at \a y,
  /// counted from \a left, of \a width.
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

  // Returns the ceiling of a value between 0 and the limit, else 0 or the limit; faster than
  // std::ceil, which may be a call.
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
    const int whole = static_cast<int>(value);
    return whole + (whole < value ? 1 : 0);
  }

  int Size;
  std::array<Edge, 4> Edges;
  double Low = std::numeric_limits<double>::max();
  double High = std::numeric_limits<double>::lowest();
};

}

#endif
