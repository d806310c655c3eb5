// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeBisection_h
#define interlume_VolumeBisection_h

#include <array>
#include <vector>

namespace interlume
{

struct MeshingJob;
struct TetGenSolution;

/**
 * @class   VolumeBisection
 * @brief   splits tetrahedra that exceed the volume bound
 *
 * Bisects an edge and thereby all tetrahedra around it. The search for the edge starts at the
 * longest edge of a tetrahedron that is too large. It moves to longer edges of adjacent tetrahedra
 * until an edge is the longest edge of all tetrahedra around it (M.-C. Rivara, "New longest-edge
 * algorithms for the refinement and/or improvement of unstructured triangulations", International
 * Journal for Numerical Methods in Engineering 40, 1997). Therefore quality degrades only by a
 * bounded factor. If the boundary is preserved and all edges of a tetrahedron are on it, the
 * tetrahedron is split at its centroid.
 */
class VolumeBisection
{
public:
  VolumeBisection(const MeshingJob& job, TetGenSolution& mesh);

  /// Splits tetrahedra until the bound is met or the mesh has \a maximumNumberOfPoints points.
  void Execute(int maximumNumberOfPoints);

private:
  using Edge = std::array<int, 2>; ///< point indices in ascending order; { -1, -1 } for no edge

  bool IsTooLarge(int tetrahedron) const;
  bool IsFixed(const Edge& edge) const;
  /// Returns whether \a edge is shorter than \a other. Point indices break ties.
  bool IsShorter(const Edge& edge, const Edge& other) const;
  Edge FindLongestEdge(int tetrahedron) const;
  /// Follows longer edges from the longest edge of \a tetrahedron, and returns the first edge that
  /// is the longest edge of all tetrahedra around it.
  Edge FindTerminalEdge(int tetrahedron) const;
  std::vector<int> FindAround(const Edge& edge) const;
  /// Splits an edge, or a tetrahedron if \a edge is { -1, -1 }. Returns the changed tetrahedra, or
  /// an empty list if rounding error would create a tetrahedron without volume.
  std::vector<int> Split(const Edge& edge, int tetrahedron);
  /// Splits the facet triangles that contain \a edge. \a point is the new midpoint of the edge.
  void SplitTriangles(const Edge& edge, int point);
  void ConnectNeighbors();

  const MeshingJob& Job;
  TetGenSolution& Mesh;
  std::vector<std::vector<int>> TetrahedraOf; ///< tetrahedra around each point
  std::vector<std::vector<int>> TrianglesOf;  ///< facet triangles around each point
};

}

#endif
