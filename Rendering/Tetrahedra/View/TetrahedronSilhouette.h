// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetrahedronSilhouette_h
#define interlume_TetrahedronSilhouette_h

#include "View/TetrahedraView.h"

#include <array>
#include <cmath>
#include <utility>

namespace interlume
{

/**
 * @class   TetrahedronSilhouette
 * @brief   the projection of a tetrahedron, and its depth and attributes at any pixel
 *
 * The four projected corners p_k have one affine dependency, sum S_k p_k = 0 with sum S_k = 0,
 * where S_k is the signed area of the face opposite corner k. The convex hull of the corners with
 * positive S_k and the convex hull of the corners with negative S_k meet in one point, the thick
 * point (Radon's theorem). It is either a corner that projects into the opposite face, or the
 * intersection of two projected edges. At the thick point, any value v that is affine in the
 * tetrahedron differs by sum S_k v_k / P between the front side and the back side, where P is the
 * sum of the positive S_k. The difference decreases linearly to 0 toward each edge of the
 * silhouette. For each edge, take the affine function that is 1 at the thick point and 0 on the
 * edge, and let lambda(x, y) be the minimum of these functions. Call one of the two sides the base
 * side. Then
 *
 *   other side = base side + lambda * difference at the thick point
 *
 * for depth and all attributes, without case distinctions. Because the difference is computed
 * before anything is rounded, the relative error does not increase for thin tetrahedra.
 *
 * If a corner projects into the opposite face, this face is the base side. Otherwise, the base side
 * consists of two triangles that meet at the crease, the edge between corners 0 and 2 of the
 * silhouette. Let h(x, y) be the affine function that is 0 on the crease and 1 at corner 3. The
 * slope changes where h > 0:
 *
 *   base side = affine + bend * max(0, h(x, y))
 *
 * The affine function is computed from the larger triangle. A thin triangle, such as a face seen
 * nearly edge-on, has unbounded slopes, so extrapolating them across the crease would amplify
 * rounding errors.
 */
class TetrahedronSilhouette
{
public:
  using Projected = TetrahedraView::Projected;

  /// A linear function of the offset from the thick point: X (x - ThickX) + Y (y - ThickY).
  struct Slope
  {
    double X;
    double Y;
  };
  /// A depth or attribute: its value at the thick point and its slope and bend, all on the base
  /// side, and the difference to the other side at the thick point.
  struct Value
  {
    double At;
    Slope Base;
    double Bend;
    double Difference;
  };

  /**
   * Sets the corners, the polygon of the silhouette and the thick point. Returns false if the
   * projection has no area.
   */
  bool Set(const Projected& p0, const Projected& p1, const Projected& p2, const Projected& p3)
  {
    this->Points = { { &p0, &p1, &p2, &p3 } };
    std::array<double, 4>& s = this->Areas;
    s[0] = this->Area(1, 2, 3);
    s[1] = -this->Area(0, 2, 3);
    s[2] = this->Area(0, 1, 3);
    s[3] = -this->Area(0, 1, 2);
    int positive = 0;
    this->Sum = 0.0;
    for (double area : s)
    {
      positive += area > 0.0;
      this->Sum += area > 0.0 ? area : 0.0;
    }
    if (!(this->Sum > 0.0))
    {
      return false;
    }
    if (positive == 2)
    {
      this->SetCrossing();
    }
    else
    {
      this->SetInner(positive == 1);
    }
    return true;
  }

  /**
   * Sets the slopes that GetEdge(), GetCrease() and GetValue() use. Call it after Set(), unless the
   * tetrahedron covers no pixel center.
   */
  void SetSlopes()
  {
    this->InverseSum = 1.0 / this->Sum;
    const Projected& p = this->GetPoint(0);
    const Projected& q = this->GetPoint(1);
    const Projected& r = this->GetPoint(2);
    const double area = this->Area(this->Polygon[0], this->Polygon[1], this->Polygon[2]);
    const double inverse = 1.0 / area;
    this->First = { (r.Y - p.Y) * inverse, (p.X - r.X) * inverse };
    this->Second = { (p.Y - q.Y) * inverse, (q.X - p.X) * inverse };
    if (this->Size == 3)
    {
      this->SetInnerEdges(area);
    }
    else
    {
      this->SetCrossingEdges();
    }
  }

  /// Returns the number of edges, which is also the number of corners. Edge i joins corners i and i
  /// + 1.
  int GetNumberOfEdges() const { return this->Size; }
  const Projected& GetPoint(int i) const { return *this->Points[this->Polygon[i]]; }
  /// Returns the slope of an edge. lambda is 1 plus the minimum of the linear functions with the
  /// slopes of all edges. Edges that never determine the minimum have slope 0, and so does the
  /// unused edge 3 of a triangle.
  const Slope& GetEdge(int i) const { return this->Edges[i]; }
  /// Returns the slope of h; 0 if there is no crease.
  const Slope& GetCrease() const { return this->Crease; }
  double GetThickX() const { return this->ThickX; }
  double GetThickY() const { return this->ThickY; }

  /// Returns the depth or attribute with the values \a v at the four corners.
  Value GetValue(const std::array<double, 4>& v) const
  {
    Value value;
    double difference = 0.0;
    for (int k = 0; k < 4; ++k)
    {
      difference += this->Areas[k] * v[k];
    }
    value.Difference = this->Sign * difference * this->InverseSum;
    const int a = this->Polygon[0];
    const int b = this->Polygon[1];
    const int c = this->Polygon[2];
    value.Bend = 0.0;
    if (this->Size == 3)
    {
      value.At = v[this->Inner] - value.Difference;
      value.Base = this->GetSlope(v[b] - v[a], v[c] - v[a]);
      return value;
    }
    const int d = this->Polygon[3];
    value.At = v[a] + this->ThickFraction * (v[c] - v[a]);
    value.Base = this->GetSlope(v[b] - v[a], v[c] - v[a]);
    if (this->HasBend)
    {
      // h is 1 at corner d, so the bend is the error of the affine function at this corner.
      const Projected& across = *this->Points[d];
      value.Bend = v[d] - value.At - value.Base.X * (across.X - this->ThickX) -
        value.Base.Y * (across.Y - this->ThickY);
    }
    return value;
  }

  ///@{
  /// Return the face that a view ray next to edge \a i crosses on the base side and on the other
  /// side. A face has the index of the opposite corner.
  int GetBaseFace(int i) const
  {
    // Edges 0 and 1 belong to the first triangle of the base side.
    return this->Size == 3 ? this->Inner : this->Polygon[i < 2 ? 3 : 1];
  }
  int GetOtherFace(int i) const
  {
    if (this->Size == 3)
    {
      return this->Polygon[(i + 2) % 3];
    }
    // The crease of the other side joins corners 1 and 3. Its faces contain corner 0 or corner 2.
    return this->Polygon[i == 0 || i == 3 ? 2 : 0];
  }
  ///@}

private:
  double Area(int a, int b, int c) const
  {
    const Projected& p = *this->Points[a];
    const Projected& q = *this->Points[b];
    const Projected& r = *this->Points[c];
    return (q.X - p.X) * (r.Y - p.Y) - (q.Y - p.Y) * (r.X - p.X);
  }

  // Handles a corner that projects into the triangle of the other three corners.
  void SetInner(bool innerIsPositive)
  {
    this->Size = 3;
    this->Inner = 0;
    for (int k = 1; k < 4; ++k)
    {
      const double sign = innerIsPositive ? 1.0 : -1.0;
      if (sign * this->Areas[k] > sign * this->Areas[this->Inner])
      {
        this->Inner = k;
      }
    }
    this->Sign = innerIsPositive ? 1.0 : -1.0;
    int corner = 0;
    for (int k = 0; k < 4; ++k)
    {
      if (k != this->Inner)
      {
        this->Polygon[corner++] = k;
      }
    }
    this->ThickX = this->Points[this->Inner]->X;
    this->ThickY = this->Points[this->Inner]->Y;
  }

  void SetInnerEdges(double area)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = this->Polygon[i];
      const int b = this->Polygon[(i + 1) % 3];
      this->SetEdge(i, this->Area(a, b, this->Inner), area);
    }
    this->Edges[3] = { 0.0, 0.0 };
    this->Crease = { 0.0, 0.0 };
  }

  // Handles two crossing edges. The corners with positive area become corners 0 and 2 of the
  // polygon.
  void SetCrossing()
  {
    this->Size = 4;
    this->Sign = -1.0;
    int positive = 0;
    int negative = 1;
    for (int k = 0; k < 4; ++k)
    {
      int& slot = this->Areas[k] > 0.0 ? positive : negative;
      this->Polygon[slot] = k;
      slot += 2;
    }
    // The first triangle is the larger one, so its plane is extrapolated by at most its own size.
    if (std::abs(this->Areas[this->Polygon[1]]) > std::abs(this->Areas[this->Polygon[3]]))
    {
      std::swap(this->Polygon[1], this->Polygon[3]);
    }
    const int a = this->Polygon[0];
    const int c = this->Polygon[2];
    this->ThickFraction = this->Areas[c] / this->Sum;
    this->ThickX =
      this->Points[a]->X + this->ThickFraction * (this->Points[c]->X - this->Points[a]->X);
    this->ThickY =
      this->Points[a]->Y + this->ThickFraction * (this->Points[c]->Y - this->Points[a]->Y);
  }

  void SetCrossingEdges()
  {
    const int a = this->Polygon[0];
    const int c = this->Polygon[2];
    for (int i = 0; i < 4; ++i)
    {
      const int from = this->Polygon[i];
      const int to = this->Polygon[(i + 1) % 4];
      // The corner with positive area that is not on this edge.
      const int across = this->Polygon[i == 0 || i == 3 ? 2 : 0];
      const double fraction = this->Areas[across] * this->InverseSum;
      const double area = this->Area(from, to, across);
      this->SetEdge(i, fraction * area, area);
    }
    // Ignore the second triangle if it has no area.
    this->HasBend = std::abs(this->Areas[this->Polygon[1]]) > 1e-12 * this->Sum;
    this->Crease = { 0.0, 0.0 };
    if (this->HasBend)
    {
      const double inverse = 1.0 / this->Area(a, c, this->Polygon[3]);
      const Projected& p = *this->Points[a];
      const Projected& q = *this->Points[c];
      this->Crease = { (p.Y - q.Y) * inverse, (q.X - p.X) * inverse };
    }
  }

  void SetEdge(int i, double atThick, double inside)
  {
    // Ignore the edge if the thick point is on it.
    if (atThick * inside <= 0.0 || std::abs(atThick) < 1e-12 * this->Sum)
    {
      this->Edges[i] = { 0.0, 0.0 };
      return;
    }
    const Projected& a = this->GetPoint(i);
    const Projected& b = this->GetPoint((i + 1) % this->Size);
    const double inverse = 1.0 / atThick;
    this->Edges[i] = { (a.Y - b.Y) * inverse, (b.X - a.X) * inverse };
  }

  // Returns the slope of a value, given its differences from corner 0 to corners 1 and 2 of the
  // first triangle.
  Slope GetSlope(double toFirst, double toSecond) const
  {
    return { toFirst * this->First.X + toSecond * this->Second.X,
      toFirst * this->First.Y + toSecond * this->Second.Y };
  }

  std::array<const Projected*, 4> Points;
  std::array<double, 4> Areas;
  double Sum = 0.0;
  double InverseSum = 0.0;
  // Slopes of the affine functions that are 1 at corner 1 (First) or corner 2 (Second) of the first
  // triangle and 0 at its other corners.
  Slope First;
  Slope Second;
  double Sign = 1.0;
  int Size = 0;
  int Inner = 0;
  bool HasBend = false;
  std::array<int, 4> Polygon{};
  std::array<Slope, 4> Edges;
  Slope Crease;
  double ThickX = 0.0;
  double ThickY = 0.0;
  double ThickFraction = 0.0;
};

}

#endif
