// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Polytope_h
#define interlume_Polytope_h

#include <array>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   Polytope
 * @brief   a convex cell with integer vertices, in 2 to 6 dimensions
 *
 * Isotables are computed for these cells. Coordinates are even integers, so that midpoints of edges
 * are integer too and all predicates are exact. The order of Edges is the order of the points in
 * the tables of C. Zhang, dissertation, Ohio State 2006, section 3.3.
 *
 * The vertex order is that of the corresponding VTK cell. Coordinate k of vertex i of Cube() is 2 *
 * ((i >> k) & 1). This is the order of VTK_VOXEL.
 *
 * Coordinates must be in -128 ... 128. A cell has at most 32 vertices and 96 edges.
 */
class Polytope
{
public:
  static constexpr int MaximumDimension = 6;
  static constexpr int MaximumNumberOfVertices = 32;
  static constexpr int MaximumNumberOfEdges = 96;
  static constexpr int MaximumCoordinate = 128;
  using Point = std::array<int, MaximumDimension>;

  int Dimension = 0;
  std::vector<Point> Vertices;
  /// Edges, as pairs of vertex indices.
  std::vector<std::array<int, 2>> Edges;

  ///@{
  /**
   * Create a cell. In three dimensions, these are VTK_TETRA, VTK_VOXEL, VTK_WEDGE and VTK_PYRAMID.
   * The edges of the cube are ordered recursively: the edges of its lower face along the last axis,
   * the edges parallel to this axis, then the edges of its upper face. The edges of the simplex are
   * in lexicographic order.
   */
  static Polytope Simplex(int dimension);
  static Polytope Cube(int dimension);
  static Polytope Wedge();
  static Polytope Pyramid();
  ///@}

  /// Creates the cell of a vtkIsotable::Shapes value.
  static Polytope FromShape(int shape);

  /**
   * Creates a convex polytope from its vertices, with edges in lexicographic order. Returns a
   * polytope without vertices if a point is not a vertex of the hull, if a coordinate is odd or out
   * of range, or if there are too many points or edges.
   */
  static Polytope FromVertices(int dimension, const std::vector<Point>& vertices);

  /**
   * Returns the prism over this polytope, in one more dimension. If the polytope has n vertices,
   * vertex i of the prism is at 0 and vertex i + n is at 2 along the new axis. The edges of the
   * prism are in the order: edges at 0, edges at 2, edges parallel to the new axis.
   */
  Polytope Prism() const;

  /// Returns the edges, each with its smaller vertex index first.
  std::vector<std::array<std::uint8_t, 2>> GetSortedEdges() const;

  Point Midpoint(int edge) const;
};

}

#endif
