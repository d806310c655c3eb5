// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoxCutTable_h
#define interlume_BoxCutTable_h

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   BoxCutTable
 * @brief   the edges of a box that a plane cuts, one after the other around its polygon
 *
 * Corner i of the box is at bit a of i along axis a. Edge 4 a + b goes along axis a upwards; bits 0
 * and 1 of b are its places along axes a + 1 and a + 2 (modulo 3).
 */
class BoxCutTable
{
public:
  struct Edge
  {
    int Axis;
    /// The corner that the edge starts from, at 0 along its axis.
    unsigned Start;
  };

  BoxCutTable();

  static Edge GetEdge(int edge);

  /// Returns the edges that a plane cuts; \a above has a bit for each corner above the plane. Empty
  /// if no plane separates them so.
  const std::vector<int>& GetEdges(unsigned above) const { return this->Edges[above]; }

private:
  std::array<std::vector<int>, 256> Edges;
};

}

#endif
