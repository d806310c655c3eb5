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
 * @brief   edges of triangles, and a consistent orientation of connected triangles
 *
 * Edge i of a triangle is the edge from corner i to the next corner.
 */
class TriangleEdges
{
public:
  /// Finds the edges.
  void Connect(const TerminationTriangles& mesh);

  /**
   * Flips triangles so that the two triangles at an edge are consistently oriented. Ignores edges
   * with more than two triangles. A connected part is oriented outward if all its edges have two
   * triangles. Any other part keeps the orientation of the majority of its triangles, or of its
   * first triangle in case of a tie. Returns an error if a part is one-sided, like a Moebius strip.
   */
  Error Orient(TerminationTriangles& mesh);

  int GetEdge(int triangle, int edge) const { return this->EdgeIds[3 * triangle + edge]; }
  bool IsBorder(int edge) const { return this->Faces[edge] == 1; }
  int GetNumberOfEdges() const { return static_cast<int>(this->Faces.size()); }

  vtkIdType NumberOfBorderEdges = 0;
  /// Number of edges with more than two triangles.
  vtkIdType NumberOfBranchingEdges = 0;

private:
  /// Computes which triangles must be flipped in the connected part that contains triangle \a
  /// first. Returns the same error as Orient().
  Error OrientPart(
    const TerminationTriangles& mesh, int first, std::vector<signed char>& turns) const;

  /// Three edge ids per triangle.
  std::vector<int> EdgeIds;
  /// Number of triangles at each edge, and the indices of the first two of them.
  std::vector<int> Faces;
  std::vector<std::array<int, 2>> Triangles;
};

}

#endif
