// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlatFacetCache_h
#define interlume_FlatFacetCache_h

#include "TimeVarying/SpaceTimeSlots.h"

#include "SpaceTime/SpaceTimeTable.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   FlatFacetCache
 * @brief   per-thread cache of the degenerate facets of table cases
 *
 * The degenerate facets depend only on the case and on the planar faces of the cell, so they are
 * computed once per case instead of once per cell.
 */
class FlatFacetCache
{
public:
  FlatFacetCache()
    : Entries(std::size_t(1) << EntryBits)
  {
  }

  /// Returns the result of SpaceTimeSlots::FindFlatFacets() for each simplex of the table case \a
  /// what.
  const std::vector<std::uint8_t>& Find(
    const SpaceTimeTable::Case& what, const SpaceTimeSlots& slots, unsigned planar)
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
        entry.Flats.push_back(slots.FindFlatFacets(simplex, planar));
      }
    }
    return entry.Flats;
  }

  /// Returns the facet mask of a simplex after its first two points were swapped.
  static std::uint8_t SwapFirst(std::uint8_t flat)
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
