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
 * @brief   edges that are to be cut, numbered by their points, and the order to cut them in
 */
class MarkedEdges
{
public:
  /// An edge as two points, the lower id first.
  using Edge = std::array<vtkIdType, 2>;
  static Edge Make(vtkIdType a, vtkIdType b) { return a < b ? Edge{ { a, b } } : Edge{ { b, a } }; }

  /// Builds the list of edges, of which each may be given several times. \a points have all points
  /// of the mesh.
  void Build(std::vector<Edge> edges, vtkPoints* points);

  vtkIdType GetNumber() const { return static_cast<vtkIdType>(this->Edges.size()); }
  const Edge& Get(vtkIdType edge) const { return this->Edges[static_cast<std::size_t>(edge)]; }

  /// Returns the number of the edge between two points; -1 where it is not marked, or a point is a
  /// new one.
  vtkIdType Find(vtkIdType a, vtkIdType b) const;

  /// Returns the place of an edge in the order of all: the longest edge first, of equal ones that
  /// of lower points.
  vtkIdType GetRank(vtkIdType edge) const { return this->Ranks[static_cast<std::size_t>(edge)]; }

private:
  std::vector<Edge> Edges;
  std::vector<vtkIdType> Ranks;
  // The first of the edges whose lower point it is, by point.
  std::vector<vtkIdType> Starts;
};

}

#endif
