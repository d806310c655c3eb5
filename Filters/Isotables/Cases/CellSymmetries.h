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
 * @brief   the affine symmetries of a cell and their action on the cases of its interval table
 *
 * The symmetries are the automorphisms of the vertex-edge graph that are affine maps: 384 for the
 * four-dimensional cube, 48 for the prisms over the tetrahedron and the wedge, 16 for the prism
 * over the pyramid. Cases that a symmetry maps to each other form a class. The smallest key
 * represents the class.
 *
 * A cell has at most 16 vertices. Slots are defined by SlotOrder.
 */
class CellSymmetries
{
public:
  using Slot = std::uint8_t;

  struct Symmetry
  {
    /// Image of each slot, indexed by slot. Vertex slots come first.
    std::vector<Slot> Slots;
    /// If true, the symmetry is a reflection.
    bool Reverses;
  };

  /// Smallest key of a class, and the index of a symmetry that maps its case to another case of the
  /// class.
  struct Origin
  {
    std::uint32_t Key;
    int Symmetry;
  };

  explicit CellSymmetries(const Polytope& cell);

  /// Returns the symmetries, the identity first.
  const std::vector<Symmetry>& Get() const { return this->Symmetries; }

  /// Returns the smallest key in the class of \a key, and the first symmetry that maps the case of
  /// the smallest key to the case of \a key.
  Origin FindRepresentative(std::uint32_t key) const;

private:
  // Keys are processed in groups of this number of base-3 digits.
  static constexpr int GroupSize = 4;
  static constexpr int GroupCases = 81;

  void FillTransformedKeys(int numberOfVertices);

  std::vector<Symmetry> Symmetries;
  int NumberOfGroups = 0;
  /// Each entry belongs to a group of digits, a value of that group and a symmetry. It is the
  /// group's contribution to the key after the inverse symmetry has been applied.
  std::vector<std::uint32_t> MovedKeys;
};

}

#endif
