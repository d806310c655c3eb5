// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SpaceTimeSlots_h
#define interlume_SpaceTimeSlots_h

#include "SpaceTime/SpaceTimeTable.h"

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * @class   SpaceTimeSlots
 * @brief   properties of the slots of a cell between two time steps, derived from the case table
 *
 * Cell corners are numbered as in vtkIsotable. With n corners, corner v is vertex v of the table at
 * the first step and vertex v + n at the second step. A slot is above a corner, edge or face of the
 * cell if its spatial position lies on that corner, edge or face.
 */
class SpaceTimeSlots
{
public:
  using Slot = SpaceTimeTable::Slot;
  using Simplex = SpaceTimeTable::Simplex;

  /// Parts of the boundary that may contain a slot, as bits: isosurfaces and time steps.
  enum Sides : std::uint8_t
  {
    LOWER = 1,
    UPPER = 2,
    START = 4,
    END = 8
  };

  explicit SpaceTimeSlots(vtkIsotable::Shapes shape);

  /// Returns the sides of a slot: LOWER or UPPER for a crossing of the lower or upper value, and
  /// START or END for a slot at the first or second step.
  std::uint8_t GetSides(Slot slot) const { return this->SidesOf[slot]; }

  /// Returns the points of a simplex that are on a side, as a bit mask.
  std::uint8_t GetPointsOn(Sides side, const Simplex& simplex) const
  {
    unsigned points = 0;
    for (int i = 0; i < 5; ++i)
    {
      points |= (this->SidesOf[simplex[i]] & side) ? 1u << i : 0u;
    }
    return static_cast<std::uint8_t>(points);
  }

  /**
   * Finds the degenerate facets of a simplex that is projected along time. Bit i is set if the
   * points other than point i are coplanar: two of them are above one corner, three above one edge,
   * or all four above a planar face. Bit f of \a planar must be set if face f of the cell is
   * planar.
   */
  std::uint8_t FindFlatFacets(const Simplex& simplex, unsigned planar) const;

  /// Returns true if all points of a simplex are above the same face of the cell.
  bool IsAboveFace(const Simplex& simplex) const
  {
    unsigned faces = this->FacesOf[simplex[0]];
    for (const Slot slot : simplex)
    {
      faces &= this->FacesOf[slot];
    }
    return faces != 0;
  }

  /// Returns the corners of face f of the cell as a bit mask, or 0 if there is no such face.
  unsigned GetFace(int f) const { return this->Faces[f]; }
  static constexpr int MaximumNumberOfFaces = 6;

private:
  std::array<std::uint8_t, SpaceTimeTable::MaximumNumberOfSlots> SidesOf{};
  // The cell corners below a slot, as a bit mask: one corner, or both ends of a cell edge.
  std::array<std::uint8_t, SpaceTimeTable::MaximumNumberOfSlots> Supports{};
  // The cell faces below a slot, as a bit mask.
  std::array<std::uint8_t, SpaceTimeTable::MaximumNumberOfSlots> FacesOf{};
  std::array<unsigned, MaximumNumberOfFaces> Faces{};
};

}

#endif
