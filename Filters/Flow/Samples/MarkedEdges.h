// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MarkedEdges_h
#define interlume_MarkedEdges_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkPoints;

namespace interlume
{

/**
 * @class   MarkedEdges
 * @brief   numbers the edges to bisect, and defines the order of bisection
 */
class MarkedEdges
{
public:
  /// An edge as two point ids, the lower one first.
  using Edge = std::array<vtkIdType, 2>;
  static Edge Make(vtkIdType a, vtkIdType b) { return a < b ? Edge{ { a, b } } : Edge{ { b, a } }; }

  /// Sets the marked edges. \a edges may contain duplicates. \a points are all points of the mesh.
  void Build(std::vector<Edge> edges, vtkPoints* points);

  vtkIdType GetNumber() const { return static_cast<vtkIdType>(this->Edges.size()); }
  const Edge& Get(vtkIdType edge) const { return this->Edges[static_cast<std::size_t>(edge)]; }

  /// Returns the index of the edge between two points; -1 if it is not marked or if a point did not
  /// exist in Build().
  vtkIdType Find(vtkIdType a, vtkIdType b) const;

  /// Returns the rank of an edge; the edge with the lowest rank is cut first. Longer edges have
  /// lower ranks; edges of equal length are ranked by point ids.
  vtkIdType GetRank(vtkIdType edge) const { return this->Ranks[static_cast<std::size_t>(edge)]; }

private:
  std::vector<Edge> Edges;
  std::vector<vtkIdType> Ranks;
  // The edges whose lower point is p have the indices from Starts[p] to Starts[p + 1] - 1.
  std::vector<vtkIdType> Starts;
};

}

#endif
