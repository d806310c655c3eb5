// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingCut_h
#define interlume_TimeVaryingCut_h

#include "Scalars/ExtractionValues.h"
#include "TimeVarying/SpaceTimeSlots.h"

#include "SpaceTime/SpaceTimeTable.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   TimeVaryingCut
 * @brief   cuts a cell between two time steps where several slots are the same point
 *
 * This class extends MergedCut to four dimensions, and also finds the boundary cells of all kinds.
 * Boundary cells are triangulated separately from the 4-simplices, because a convex piece of zero
 * hypervolume also has boundary cells. At each step, the volume and its surfaces are the same as
 * those that vtkIntervalVolume extracts from that step.
 */
class TimeVaryingCut
{
public:
  using Code = ExtractionValues::Code;
  using Item = ExtractionValues::Item;
  using Slot = SpaceTimeTable::Slot;
  using Simplex = SpaceTimeTable::Simplex;

  /// A boundary cell, see vtkTimeVaryingSettings::BoundaryKinds.
  struct Side
  {
    std::array<Slot, 4> Points;
    int Number;
    int Kind;
  };

  /// Triangulates case \a what, with the points ordered by \a ranks. \a same maps each slot to the
  /// slot that represents its point. \a inside is the case with all corners inside the interval. If
  /// \a hasSides is false, boundary cells are not computed.
  void Compute(const SpaceTimeTable& table, const SpaceTimeSlots& slots, const Item& item,
    const Code* codes, const SpaceTimeTable::Case& what, const SpaceTimeTable::Case& inside,
    const SpaceTimeTable::RankArray& ranks, const Slot* same, bool hasSides);

  const std::vector<Simplex>& GetSimplices() const { return this->Simplices; }
  const std::vector<Side>& GetSides() const { return this->Sides; }

private:
  void AddSides(const SpaceTimeTable& table, const SpaceTimeSlots& slots,
    const SpaceTimeTable::Case& what, const SpaceTimeTable::RankArray& ranks, const Slot* same);
  void AddFlatSides(const SpaceTimeTable& table, const SpaceTimeSlots& slots, const Item& item,
    const Code* codes, const SpaceTimeTable::Case& inside, const SpaceTimeTable::RankArray& ranks,
    const Slot* same);
  void Add(int kind, int number, const Slot* points, bool isReversed);

  std::vector<Simplex> Simplices;
  std::vector<Side> Sides;
};

}

#endif
