// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetGenProblem_h
#define interlume_TetGenProblem_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace interlume
{

/**
 * A problem for TetGen: its switches and a list of points, alone (Delaunay), with triangles (a
 * piecewise linear complex) or with tetrahedra (to refine; the triangles are faces of them on the
 * facets). Indices start at 0.
 */
struct TetGenProblem
{
  std::string Switches;
  std::vector<double> Points;  ///< three a point
  std::vector<int> Triangles;  ///< three a triangle
  std::vector<int> Markers;    ///< one a triangle, above 0: coplanar ones of one are one facet
  std::vector<int> Tetrahedra; ///< four a tetrahedron
};

/**
 * The solution of TetGen. The points of the problem come first, in their order.
 */
struct TetGenSolution
{
  /// The error: 0, or the number that TetGen threw: 1 memory, 2 internal, 3 self-intersection, 4
  /// small feature, 5 close facets, 10 input; -1 anything else.
  int Code = 0;
  std::vector<double> Points;
  std::vector<int> Tetrahedra; ///< four a tetrahedron, positively oriented
  std::vector<int> Neighbors;  ///< four a tetrahedron, opposite its points; -1 outside
  std::vector<int> Triangles;  ///< three a triangle on a facet of the problem
  std::vector<int> Markers;    ///< the marker of each of these triangles

  /// Returns the points of the face opposite corner \a i % 4 of tetrahedron \a i / 4, ascending.
  std::array<int, 3> GetFace(std::size_t i) const
  {
    const int* p = &this->Tetrahedra[i - i % 4];
    std::array<int, 3> face{ { p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4] } };
    std::sort(face.begin(), face.end());
    return face;
  }
  int GetNumberOfPoints() const { return static_cast<int>(this->Points.size() / 3); }
  int GetNumberOfTetrahedra() const { return static_cast<int>(this->Tetrahedra.size() / 4); }
};

}

#endif
