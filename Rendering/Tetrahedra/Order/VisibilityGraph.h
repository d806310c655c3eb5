// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VisibilityGraph_h
#define interlume_VisibilityGraph_h

#include <cstdint>

namespace interlume
{

/**
 * @class   VisibilityGraph
 * @brief   for each tetrahedron those that must be drawn directly before it
 *
 * It is a view of arrays held elsewhere.
 */
struct VisibilityGraph
{
  static constexpr std::uint32_t None = 0xffffffffu;

  /// The bits of each tetrahedron, one for each face beyond which its neighbour is in front.
  const unsigned char* InFront = nullptr;
  /// The twin of each face 4 t + k: the same face of the neighbour.
  const std::uint32_t* Twins = nullptr;
  /// The tetrahedra in front across a gap of t: Gaps[GapOffsets[t]] to Gaps[GapOffsets[t + 1] - 1];
  /// null where there are no gaps.
  const std::uint32_t* GapOffsets = nullptr;
  const std::uint32_t* Gaps = nullptr;

  /// Returns the next tetrahedron in front of \a tetrahedron, or None after the last; \a position
  /// begins with 0 and is moved on.
  std::uint32_t GetNext(std::uint32_t tetrahedron, std::uint32_t& position) const
  {
    if (position < 4)
    {
      for (unsigned int rest = this->InFront[tetrahedron] >> position; rest; rest >>= 1)
      {
        const std::uint32_t k = position++;
        if (rest & 1)
        {
          return this->Twins[4 * static_cast<std::size_t>(tetrahedron) + k] / 4;
        }
      }
      position = 4;
    }
    if (this->GapOffsets &&
      position - 4 < this->GapOffsets[tetrahedron + 1] - this->GapOffsets[tetrahedron])
    {
      return this->Gaps[this->GapOffsets[tetrahedron] + position++ - 4];
    }
    return None;
  }
};

}

#endif
