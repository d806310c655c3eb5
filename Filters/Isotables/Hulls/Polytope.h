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
 * @brief   a convex cell with lattice vertices, in 2 to 6 dimensions
 *
 * The cells that isotables are made for. Coordinates are even integers, so that the midpoint of an
 * edge is a lattice point too and every predicate is exact. The order of Edges is the order of the
 * points in the tables of C. Zhang, dissertation, Ohio State 2006, section 3.3.
 *
 * Cells have the vertex order of their VTK cell; Cube has vertex i at coordinate
 * 2 * ((i >> k) & 1) along axis k (the order of VTK_VOXEL).
 *
 * The valid range of a coordinate is -128 to 128. A cell has at most 32 vertices and 96 edges.
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
  /// The edges as pairs of vertex indices.
  std::vector<std::array<int, 2>> Edges;

  ///@{
  /**
   * Make the cells of VTK. The edges of the cube are in the order lower, vertical, upper along the
   * last axis, recursively; those of the simplex are in lexicographic order.
   */
  static Polytope Simplex(int dimension);
  static Polytope Cube(int dimension);
  static Polytope Wedge();
  static Polytope Pyramid();
  ///@}

  /// Makes the cell of a shape of vtkIsotable.
  static Polytope OfShape(int shape);

  /**
   * Makes any convex polytope from its vertices, and finds its edges, in lexicographic order.
   * Returns a polytope without vertices when a point is not a vertex of the hull, a coordinate is
   * odd or out of range, or there are too many points.
   */
  static Polytope FromVertices(int dimension, const std::vector<Point>& vertices);

  /**
   * Returns the prism over this polytope, which has one dimension more: vertex i at 0, vertex i + n
   * at 2 along the new axis. Its edges are those at 0, those at 2, then the vertical ones.
   */
  Polytope Prism() const;

  /// Returns the edges with the smaller vertex first.
  std::vector<std::array<std::uint8_t, 2>> GetSortedEdges() const;

  /// Returns the midpoint of an edge.
  Point Midpoint(int edge) const;
};

}

#endif
