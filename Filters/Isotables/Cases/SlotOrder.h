// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlotOrder_h
#define interlume_SlotOrder_h

#include <algorithm>
#include <cstddef>

namespace interlume
{

/**
 * @class   SlotOrder
 * @brief   the point order in which all isotables are triangulated
 *
 * The points of a case are numbered as slots. In a cell with n vertices and m edges, slots 0 ...
 * n-1 are the vertices, slots n ... n+m-1 are the points on edges at the lower isovalue, and slots
 * n+m ... n+2m-1 are those at the upper isovalue. In the triangulation, vertices also come first,
 * then lower edge points, then upper edge points. Edge points are compared by the smaller vertex
 * rank of their edge's ends, then by the larger one. Two cells that agree on the order of shared
 * vertices agree on the order of the points on their common face.
 */
class SlotOrder
{
public:
  /// Returns the slot of a point that CasePatch identifies by an edge of the lifted cell.
  static int GetSlot(int numberOfVertices, int numberOfEdges, int liftedEdge)
  {
    return liftedEdge < 2 * numberOfEdges ? numberOfVertices + liftedEdge
                                          : liftedEdge - 2 * numberOfEdges;
  }

  /**
   * Fills \a ranks for all slots, including the upper edge points if \a isInterval is true. The n
   * vertices have ranks 0 ... n-1. The ranks of all slots are distinct and less than n + 2 n^2.
   */
  template <typename EdgeList, typename VertexRank, typename SlotRank>
  static void RankSlots(int numberOfVertices, const EdgeList& edges, bool isInterval,
    const VertexRank* vertexRanks, SlotRank* ranks)
  {
    const int n = numberOfVertices;
    std::copy(vertexRanks, vertexRanks + n, ranks);
    const std::size_t m = edges.size();
    for (std::size_t e = 0; e < m; ++e)
    {
      const int a = vertexRanks[edges[e][0]];
      const int b = vertexRanks[edges[e][1]];
      const int lower = n + n * std::min(a, b) + std::max(a, b);
      ranks[n + e] = static_cast<SlotRank>(lower);
      if (isInterval)
      {
        ranks[n + m + e] = static_cast<SlotRank>(lower + n * n);
      }
    }
  }
};

}

#endif
