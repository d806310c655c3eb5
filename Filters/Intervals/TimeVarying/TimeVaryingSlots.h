// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingSlots_h
#define interlume_TimeVaryingSlots_h

#include "SpaceTime/SpaceTimeTable.h"

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * @class   TimeVaryingSlots
 * @brief   the meaning of the slots of a cell between two time steps, known from the table alone
 *
 * Corners of the cell are numbered as in vtkIsotable; corner v is vertex v of the table at the
 * first step and v + n at the second.
 */
class TimeVaryingSlots
{
public:
  using Slot = SpaceTimeTable::Slot;
  using Simplex = SpaceTimeTable::Simplex;

  /// The sides that a slot is on, as bits.
  enum Sides : std::uint8_t
  {
    LOWER = 1,
    UPPER = 2,
    START = 4,
    END = 8
  };

  explicit TimeVaryingSlots(vtkIsotable::Shapes shape);

  /// Returns whether the slot is a crossing of the lower or the upper value, and whether it is at a
  /// step.
  std::uint8_t GetSides(Slot slot) const { return this->SidesOf[slot]; }

  /// Returns the points of a simplex on a side, as bits.
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
   * Finds flat sides: bit i is set where the points of a simplex but i lie in a plane when the
   * simplex is projected along time: two above one corner, three above one edge, or four above a
   * face that is planar. Bit f of \a planar is set where face f of the cell is.
   */
  std::uint8_t FindFlat(const Simplex& simplex, unsigned planar) const;

  /// Returns whether the points of a simplex are all above one face of the cell.
  bool IsAboveFace(const Simplex& simplex) const
  {
    unsigned faces = this->FacesOf[simplex[0]];
    for (const Slot slot : simplex)
    {
      faces &= this->FacesOf[slot];
    }
    return faces != 0;
  }

  /// Returns the corners of face f of the cell, as bits; 0 where there is none.
  unsigned GetFace(int f) const { return this->Faces[f]; }
  static constexpr int MaximumNumberOfFaces = 6;

private:
  std::array<std::uint8_t, SpaceTimeTable::MaximumNumberOfSlots> SidesOf{};
  // The corners of the cell that a slot lies above or between, as bits.
  std::array<std::uint8_t, SpaceTimeTable::MaximumNumberOfSlots> Supports{};
  // The faces of the cell that a slot lies above, as bits.
  std::array<std::uint8_t, SpaceTimeTable::MaximumNumberOfSlots> FacesOf{};
  std::array<unsigned, MaximumNumberOfFaces> Faces{};
};

}

#endif
