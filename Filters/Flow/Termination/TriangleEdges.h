// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TriangleEdges_h
#define interlume_TriangleEdges_h

#include "Termination/TerminationTriangles.h"

#include "vtkType.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   TriangleEdges
 * @brief   the edges of triangles, and one orientation for all that hang together
 *
 * Edge i of a triangle goes from its corner i to the next.
 */
class TriangleEdges
{
public:
  /// Finds the edges.
  void Connect(const TerminationTriangles& mesh);

  /**
   * Turns triangles so that two that share an edge, without a third, agree. A part without borders
   * is turned outward, one with borders to how most of its triangles are, of equal numbers its
   * first. Returns an error for a part that has one side only, as a Moebius strip.
   */
  Error Orient(TerminationTriangles& mesh);

  int GetEdge(int triangle, int edge) const { return this->EdgeIds[3 * triangle + edge]; }
  bool IsBorder(int edge) const { return this->Faces[edge] == 1; }
  int GetNumberOfEdges() const { return static_cast<int>(this->Faces.size()); }

  vtkIdType NumberOfBorderEdges = 0;
  /// The number of edges of more than two triangles.
  vtkIdType NumberOfBranchingEdges = 0;

private:
  /// Decides for all triangles that hang together with the first whether they are turned. Returns
  /// an error as Orient does.
  Error OrientPart(
    const TerminationTriangles& mesh, int first, std::vector<signed char>& turns) const;

  /// The three edges of each triangle.
  std::vector<int> EdgeIds;
  /// The number of triangles that each edge has, and the first two of them.
  std::vector<int> Faces;
  std::vector<std::array<int, 2>> Triangles;
};

}

#endif
