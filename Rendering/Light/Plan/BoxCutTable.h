// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BoxCutTable_h
#define interlume_BoxCutTable_h

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   BoxCutTable
 * @brief   table of the box edges that a plane cuts, in order around the cut polygon
 *
 * Bit a of a corner index is the corner's position along axis a: 0 at the lower end, 1 at the upper
 * end. Edge 4 * a + b runs along axis a in the positive direction. Bits 0 and 1 of b are the edge's
 * positions along axes a + 1 and a + 2 (modulo 3).
 */
class BoxCutTable
{
public:
  struct Edge
  {
    int Axis;
    /// The corner where the edge starts, at position 0 along its axis.
    unsigned Start;
  };

  BoxCutTable();

  static Edge GetEdge(int edge);

  /// Returns the edges that a plane cuts, in order. Bit i of \a above is set if corner i is above
  /// the plane. Returns no edges if no plane separates the corners in this way.
  const std::vector<int>& GetEdges(unsigned above) const { return this->Edges[above]; }

private:
  std::array<std::vector<int>, 256> Edges;
};

}

#endif
