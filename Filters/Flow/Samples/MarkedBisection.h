// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MarkedBisection_h
#define interlume_MarkedBisection_h

#include "Samples/MarkedEdges.h"

#include <array>

namespace interlume
{

/**
 * @class   MarkedBisection
 * @brief   cuts tetrahedra at the midpoints of marked edges
 *
 * A tetrahedron is cut in two at its first marked edge (MarkedEdges::GetRank), and both halves are
 * cut at their remaining marked edges in turn. The cuts on a face depend only on the order of the
 * face's own edges. Therefore two cells that share a face cut it in the same way.
 */
class MarkedBisection
{
public:
  using Tetrahedron = std::array<vtkIdType, 4>;

  /// \a edges must outlive this object. The midpoint of edge e is point \a firstMidpoint + e.
  MarkedBisection(const MarkedEdges& edges, vtkIdType firstMidpoint)
    : Edges(edges)
    , FirstMidpoint(firstMidpoint)
  {
  }

  /// Calls \a visit for each piece of \a tetrahedron. The pieces have the same orientation.
  template <typename Visit>
  void Split(const Tetrahedron& tetrahedron, Visit&& visit) const
  {
    vtkIdType cut = -1;
    std::array<std::size_t, 2> ends{};
    for (std::size_t a = 0; a < 4; ++a)
    {
      for (std::size_t b = a + 1; b < 4; ++b)
      {
        const vtkIdType edge = this->Edges.Find(tetrahedron[a], tetrahedron[b]);
        if (edge >= 0 && (cut < 0 || this->Edges.GetRank(edge) < this->Edges.GetRank(cut)))
        {
          cut = edge;
          ends = { { a, b } };
        }
      }
    }
    if (cut < 0)
    {
      visit(tetrahedron);
      return;
    }
    for (const std::size_t end : ends)
    {
      Tetrahedron half = tetrahedron;
      half[end] = this->FirstMidpoint + cut;
      this->Split(half, visit);
    }
  }

private:
  const MarkedEdges& Edges;
  vtkIdType FirstMidpoint;
};

}

#endif
