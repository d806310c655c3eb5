// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlatSides_h
#define interlume_FlatSides_h

#include "TimeVarying/TimeVaryingSlots.h"

#include "SpaceTime/SpaceTimeTable.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   FlatSides
 * @brief   the flat sides of the simplices of cases, kept by one thread for the cases it met last
 *
 * They follow from the table and from which faces of the cell are planar: once for a case, not for
 * each cell.
 */
class FlatSides
{
public:
  FlatSides()
    : Entries(std::size_t(1) << EntryBits)
  {
  }

  /// Returns what \a slots finds for each simplex of a case's own cut.
  const std::vector<std::uint8_t>& Find(
    const SpaceTimeTable::Case& what, const TimeVaryingSlots& slots, unsigned planar)
  {
    const std::uint64_t hash = reinterpret_cast<std::uintptr_t>(&what) + planar;
    Entry& entry = this->Entries[(hash * 0x9e3779b97f4a7c15) >> (64 - EntryBits)];
    if (entry.Case != &what || entry.Planar != planar)
    {
      entry.Case = &what;
      entry.Planar = planar;
      entry.Flats.clear();
      for (const SpaceTimeTable::Simplex& simplex : what.Simplices)
      {
        entry.Flats.push_back(slots.FindFlat(simplex, planar));
      }
    }
    return entry.Flats;
  }

  /// Returns the flat sides of a simplex whose first two points have changed places.
  static std::uint8_t Turn(std::uint8_t flat)
  {
    return static_cast<std::uint8_t>((flat & ~3u) | ((flat & 1u) << 1) | ((flat >> 1) & 1u));
  }

private:
  static constexpr int EntryBits = 12;

  struct Entry
  {
    const SpaceTimeTable::Case* Case = nullptr;
    unsigned Planar = 0;
    std::vector<std::uint8_t> Flats;
  };

  std::vector<Entry> Entries;
};

}

#endif
