// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_MarkedBisection_h
#define interlume_MarkedBisection_h

#include "Samples/MarkedEdges.h"

#include <array>

namespace interlume
{

/**
 * @class   MarkedBisection
 * @brief   tetrahedra cut at the middles of marked edges
 *
 * A tetrahedron is cut in two at its first marked edge, and both halves go on with the marked edges
 * that they have left. A face is cut as it would be cut alone in the same order: the cuts of a face
 * depend on its own edges, and neighbours agree.
 */
class MarkedBisection
{
public:
  using Tetrahedron = std::array<vtkIdType, 4>;

  /// Takes the edges, which the caller keeps. The middle of edge e is point \a firstMiddle + e.
  MarkedBisection(const MarkedEdges& edges, vtkIdType firstMiddle)
    : Edges(edges)
    , FirstMiddle(firstMiddle)
  {
  }

  /// Calls \a visit for each part, oriented as \a whole is.
  template <typename Visit>
  void Split(const Tetrahedron& whole, Visit&& visit) const
  {
    vtkIdType cut = -1;
    std::array<std::size_t, 2> ends{};
    for (std::size_t a = 0; a < 4; ++a)
    {
      for (std::size_t b = a + 1; b < 4; ++b)
      {
        const vtkIdType edge = this->Edges.Find(whole[a], whole[b]);
        if (edge >= 0 && (cut < 0 || this->Edges.GetRank(edge) < this->Edges.GetRank(cut)))
        {
          cut = edge;
          ends = { { a, b } };
        }
      }
    }
    if (cut < 0)
    {
      visit(whole);
      return;
    }
    for (const std::size_t end : ends)
    {
      Tetrahedron half = whole;
      half[end] = this->FirstMiddle + cut;
      this->Split(half, visit);
    }
  }

private:
  const MarkedEdges& Edges;
  vtkIdType FirstMiddle;
};

}

#endif
