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
 * @brief   splits tetrahedra that are larger than the volume bound
 *
 * An edge is split with all tetrahedra around it when it is the longest one of each: from the
 * longest edge of the tetrahedron that is too large, the search continues with a longer edge
 * around it (M.-C. Rivara, "New longest-edge algorithms for the refinement and/or improvement of
 * unstructured triangulations", International Journal for Numerical Methods in Engineering 40,
 * 1997). So shapes get worse by a bounded factor. Where the boundary is preserved and a tetrahedron
 * has no other edge, it is split at its center.
 */
class VolumeBisection
{
public:
  VolumeBisection(const MeshingJob& job, TetGenSolution& mesh);

  /// Splits until the bound holds, or the mesh has \a maximumNumberOfPoints.
  void Execute(int maximumNumberOfPoints);

private:
  using Edge = std::array<int, 2>; ///< points in ascending order; { -1, -1 } is no edge

  bool IsTooLarge(int tetrahedron) const;
  bool IsFixed(const Edge& edge) const;
  /// Returns whether \a edge is shorter than \a other. Points decide between edges of one length.
  bool IsShorter(const Edge& edge, const Edge& other) const;
  Edge FindLongest(int tetrahedron) const;
  /// Returns the first edge on the path to longer ones that no tetrahedron around it exceeds.
  Edge FindTerminal(int tetrahedron) const;
  std::vector<int> FindAround(const Edge& edge) const;
  /// Splits an edge, or a tetrahedron if there is none. Returns the tetrahedra that changed, none
  /// if rounding would leave one without volume.
  std::vector<int> Split(const Edge& edge, int tetrahedron);
  /// Splits the triangles on facets that have an edge at \a point.
  void SplitTriangles(const Edge& edge, int point);
  void ConnectNeighbors();

  const MeshingJob& Job;
  TetGenSolution& Mesh;
  std::vector<std::vector<int>> TetrahedraOf; ///< of each point
  std::vector<std::vector<int>> TrianglesOf;  ///< of each point
};

}

#endif
