// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CellSymmetries_h
#define interlume_CellSymmetries_h

#include "Hulls/Polytope.h"

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   CellSymmetries
 * @brief   the affine maps of a cell onto itself, and what they do to the cases of its interval
 * table
 *
 * They are the automorphisms of the graph of vertices and edges that are affine in the coordinates:
 * 384 for the four-dimensional cube, 48 for the prisms over tetrahedron and wedge, 16 for that over
 * the pyramid. Cases that one of them takes into each other are of one kind, and the smallest of
 * their keys stands for it.
 *
 * A cell has at most 16 vertices. Slots are those of SlotOrder.
 */
class CellSymmetries
{
public:
  using Slot = std::uint8_t;

  struct Symmetry
  {
    /// The slot that each slot is moved to; the first are the vertices.
    std::vector<Slot> Slots;
    /// Whether the symmetry is a reflection.
    bool Reverses;
  };

  /// The smallest key of a kind, and the symmetry that moves its case to the case of a key.
  struct Origin
  {
    std::uint32_t Key;
    int Symmetry;
  };

  explicit CellSymmetries(const Polytope& cell);

  /// Returns the symmetries, the identity first.
  const std::vector<Symmetry>& Get() const { return this->Symmetries; }

  /// Returns the smallest key of the kind of \a key, with the first of several symmetries.
  Origin FindOrigin(std::uint32_t key) const;

private:
  // The number of digits in each of the groups that a key is taken apart into.
  static constexpr int GroupSize = 4;
  static constexpr int GroupCases = 81;

  void FillMovedKeys(int numberOfVertices);

  std::vector<Symmetry> Symmetries;
  int NumberOfGroups = 0;
  /// The moved keys: for each group, each of its values and each symmetry, the group's share in the
  /// key that the symmetry's inverse makes.
  std::vector<std::uint32_t> MovedKeys;
};

}

#endif
