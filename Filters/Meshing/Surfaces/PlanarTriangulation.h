// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PlanarTriangulation_h
#define interlume_PlanarTriangulation_h

#include <array>
#include <cstdint>
#include <set>
#include <vector>

namespace interlume
{

/**
 * @class   PlanarTriangulation
 * @brief   triangulates points and segments in a plane
 *
 * Points are inserted one by one into a large triangle, the frame, with Lawson flips after each
 * insertion. Segments are then recovered by flips (S. W. Sloan, "A fast algorithm for generating
 * constrained Delaunay triangulations", Computers & Structures 47(3), 1993). Coordinates are
 * rounded to a grid of 2^52 steps across the extent of the points, and orientation tests on the
 * grid are exact.
 */
class PlanarTriangulation
{
public:
  using Point = std::array<double, 2>;
  using Edge = std::array<int, 2>; ///< point indices in ascending order

  struct Triangle
  {
    std::array<int, 3>
      Points; ///< counterclockwise; the last three indices are corners of the frame
    std::array<int, 3> Neighbors; ///< opposite the points; -1 outside
  };

  /// Triangulates \a points. \a segments may only meet at their ends. Afterward, IsGood() returns
  /// whether all segments are edges of triangles.
  PlanarTriangulation(const std::vector<Point>& points, const std::vector<Edge>& segments);

  bool IsGood() const { return this->Good; }
  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

private:
  void AddPoint(int point);
  void AddSegment(const Edge& segment);
  int Locate(int point) const;
  /// Flips the edge opposite corner \a i of triangle \a t.
  void Flip(int t, int i);
  /// Flips edges opposite \a point, starting with the triangles \a changed, until the circumcircles
  /// of the triangles around \a point are empty.
  void Legalize(std::vector<int> changed, int point);
  void Replace(int t, int old, int now);
  int Orientation(int a, int b, int c) const;
  bool IsInCircle(int a, int b, int c, int d) const;
  /// Finds the triangle \a t with the edge from \a a to \a b, and its corner \a i opposite the
  /// edge. Returns false if no triangle has this edge.
  bool FindEdge(int a, int b, int& t, int& i) const;
  std::vector<int> FindAround(int point) const;

  std::vector<std::array<std::int64_t, 2>> Positions;
  std::vector<Triangle> Triangles;
  std::vector<int> TriangleOf; ///< a triangle at each point
  std::set<Edge> Fixed;
  int Last = 0;
  bool Good = true;
};

}

#endif
