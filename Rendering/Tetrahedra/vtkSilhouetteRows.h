#ifndef vtkSilhouetteRows_h
#define vtkSilhouetteRows_h

#include "vtkTetrahedronSilhouette.h"

#include <algorithm>
#include <limits>

/**
 * @class   vtkSilhouetteRows
 * @brief   the pixels of a silhouette, row by row
 *
 * A pixel belongs to it if its centre does; a centre on an edge belongs to the right and the upper
 * one of both neighbours, which find the same crossing of row and edge.
 */
class vtkSilhouetteRows
{
public:
  /// Pixels Begin to End - 1, on one side of the crease.
  struct Span
  {
    int Begin;
    int End;
    int Half;
  };

  explicit vtkSilhouetteRows(const vtkTetrahedronSilhouette& shape)
    : Size(shape.GetNumberOfEdges())
  {
    for (int i = 0; i < this->Size; ++i)
    {
      const auto* a = &shape.GetPoint(i);
      const auto* b = &shape.GetPoint((i + 1) % this->Size);
      // From the lower end, whichever tetrahedron it is seen from.
      if (b->Y < a->Y || (b->Y == a->Y && b->X < a->X))
      {
        std::swap(a, b);
      }
      this->Edges[i] = { a->Y, b->Y, a->X, (b->X - a->X) / (b->Y - a->Y) };
      this->Low = std::min(this->Low, a->Y);
      this->High = std::max(this->High, b->Y);
    }
    if (shape.HasCrease())
    {
      const auto& a = shape.GetPoint(0);
      const auto& b = shape.GetPoint(2);
      const auto& c = shape.GetPoint(1);
      this->CreaseX = a.Y - b.Y;
      this->CreaseY = b.X - a.X;
      this->CreaseAt = -this->CreaseX * a.X - this->CreaseY * a.Y;
      if (this->GetSide(c.X, c.Y) < 0.0)
      {
        this->CreaseX = -this->CreaseX;
        this->CreaseY = -this->CreaseY;
        this->CreaseAt = -this->CreaseAt;
      }
    }
  }

  /// The first row and the one after the last, counted from \a bottom, of \a height.
  int GetBegin(int bottom) const
  {
    return GetCeiling(this->Low - 0.5 - bottom, std::numeric_limits<int>::max());
  }
  int GetEnd(int bottom, int height) const
  {
    return GetCeiling(this->High - 0.5 - bottom, height);
  }

  /// The pixels of the row with its centre at \a y, counted from \a left, of \a width: up to two spans.
  int GetSpans(double y, int left, int width, Span spans[2]) const
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
    const int begin = GetCeiling(first - 0.5 - left, width);
    const int end = GetCeiling(last - 0.5 - left, width);
    if (begin >= end)
    {
      return 0;
    }
    spans[0] = { begin, end, 0 };
    if (this->Size == 3)
    {
      return 1;
    }
    const double side = this->GetSide(left + begin + 0.5, y);
    // On the crease itself the half is the one that the row goes into.
    spans[0].Half = side > 0.0 || (side == 0.0 && this->CreaseX > 0.0) ? 0 : 1;
    // The first pixel beyond the crease.
    const double steps = -side / this->CreaseX;
    const int middle = begin + std::max(1, GetCeiling(steps, end - begin));
    if (!(steps > 0.0) || middle >= end)
    {
      return 1;
    }
    spans[0].End = middle;
    spans[1] = { middle, end, 1 - spans[0].Half };
    return 2;
  }

private:
  struct Edge
  {
    double Low;
    double High;
    double X;
    double Slope;
  };

  // Of a value between 0 and the limit, else that; faster than std::ceil, which may be a call.
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

  // Positive in the first half.
  double GetSide(double x, double y) const
  {
    return this->CreaseX * x + this->CreaseY * y + this->CreaseAt;
  }

  int Size;
  std::array<Edge, 4> Edges;
  double Low = std::numeric_limits<double>::max();
  double High = std::numeric_limits<double>::lowest();
  double CreaseX = 0.0;
  double CreaseY = 0.0;
  double CreaseAt = 0.0;
};

#endif
