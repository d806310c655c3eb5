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
 * Input of TetGen: its switches and a list of points. Points alone are a Delaunay problem, points
 * and triangles are a piecewise linear complex. If there are tetrahedra, they are a mesh to refine,
 * and the triangles are the tetrahedron faces on facets. Indices start at 0.
 */
struct TetGenProblem
{
  std::string Switches;
  std::vector<double> Points; ///< three per point
  std::vector<int> Triangles; ///< three per triangle
  std::vector<int>
    Markers; ///< one per triangle, > 0; coplanar triangles with the same marker form a facet
  std::vector<int> Tetrahedra; ///< four per tetrahedron
};

/**
 * Output of TetGen. The points of the problem come first, in the same order.
 */
struct TetGenSolution
{
  /// Error code of TetGen: 0 none, 1 out of memory, 2 internal, 3 self-intersection, 4 small
  /// feature, 5 close facets, 10 input, -1 other.
  int Code = 0;
  std::vector<double> Points;
  std::vector<int> Tetrahedra; ///< four per tetrahedron, positively oriented
  std::vector<int> Neighbors;  ///< four per tetrahedron, opposite its points; -1 outside
  std::vector<int> Triangles;  ///< three per triangle on a facet of the problem
  std::vector<int> Markers;    ///< marker of each triangle

  /// Returns the indices, in ascending order, of the points of the face opposite corner \a i % 4 of
  /// tetrahedron \a i / 4.
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
