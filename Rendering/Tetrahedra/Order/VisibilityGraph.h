// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VisibilityGraph_h
#define interlume_VisibilityGraph_h

#include <cstdint>

namespace interlume
{

/**
 * @class   VisibilityGraph
 * @brief   for each tetrahedron, the neighbors across faces and gaps that must be drawn before it
 *
 * It does not own its arrays.
 */
struct VisibilityGraph
{
  static constexpr std::uint32_t None = 0xffffffffu;

  /// Bits of each tetrahedron: bit k is set if the neighbor across face k is in front.
  const unsigned char* InFront = nullptr;
  /// Twin of each face 4 t + k: the same face in the neighbor.
  const std::uint32_t* Twins = nullptr;
  /// Tetrahedra in front of t across gaps: Gaps[GapOffsets[t]] to Gaps[GapOffsets[t + 1] - 1]. Null
  /// if there are no gaps.
  const std::uint32_t* GapOffsets = nullptr;
  const std::uint32_t* Gaps = nullptr;

  /// Returns the next of the tetrahedra in front of \a tetrahedron, or None after the last one.
  /// \a position must be 0 in the first call, and is advanced by each call.
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
