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
 * Cells have the vertex order of their VTK cell. Cube has vertex i at coordinate 2 * ((i >> k) & 1)
 * along axis k (the order of VTK_VOXEL).
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
   * The edges of the cube are in the order lower, vertical, upper along the last axis, recursively.
   * The edges of the simplex are in lexicographic order.
   */
  static Polytope Simplex(int dimension);
  static Polytope Cube(int dimension);
  static Polytope Wedge();
  static Polytope Pyramid();
  ///@}

  /// Creates the cell of a vtkIsotable::Shapes value.
  static Polytope OfShape(int shape);

  /**
   * Creates a convex polytope from its vertices, with edges in lexicographic order. Returns a
   * polytope without vertices if a point is not a vertex of the hull, if a coordinate is odd or out
   * of range, or if there are too many points or edges.
   */
  static Polytope FromVertices(int dimension, const std::vector<Point>& vertices);

  /**
   * Returns the prism over this polytope, in one more dimension. Vertex i is at 0 and vertex i + n
   * at 2 along the new axis. The edges are the edges at 0, the edges at 2, then the vertical edges.
   */
  Polytope Prism() const;

  /// Returns the edges with the smaller vertex first.
  std::vector<std::array<std::uint8_t, 2>> GetSortedEdges() const;

  /// Returns the midpoint of an edge.
  Point Midpoint(int edge) const;
};

}

#endif
