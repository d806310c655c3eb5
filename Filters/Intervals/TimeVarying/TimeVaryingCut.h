// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TimeVaryingCut_h
#define interlume_TimeVaryingCut_h

#include "Scalars/ExtractionValues.h"
#include "TimeVarying/TimeVaryingSlots.h"

#include "SpaceTime/SpaceTimeTable.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   TimeVaryingCut
 * @brief   a case between two steps as it is cut in a cell of which slots are the same point
 *
 * It is what MergedCut is for a cell of one step, with all kinds of boundary cells: the sides of
 * the pieces are cut by themselves, since a piece without hypervolume has sides too. The volume and
 * its surfaces at a step are those of that step alone, as vtkIntervalVolume has them.
 */
class TimeVaryingCut
{
public:
  using Code = ExtractionValues::Code;
  using Item = ExtractionValues::Item;
  using Slot = SpaceTimeTable::Slot;
  using Simplex = SpaceTimeTable::Simplex;

  /// A cell of a boundary; see vtkTimeVaryingSettings::BoundaryKinds.
  struct Side
  {
    std::array<Slot, 4> Points;
    int Number;
    int Kind;
  };

  /// Cuts the case in the order of \a ranks; \a same has for each slot the one that it goes by. \a
  /// inside is the case where all corners are in the interval.
  void Make(const SpaceTimeTable& table, const TimeVaryingSlots& slots, const Item& item,
    const Code* codes, const SpaceTimeTable::Case& what, const SpaceTimeTable::Case& inside,
    const SpaceTimeTable::RankArray& ranks, const Slot* same, bool hasSides);

  const std::vector<Simplex>& GetSimplices() const { return this->Simplices; }
  const std::vector<Side>& GetSides() const { return this->Sides; }

private:
  void AddSides(const SpaceTimeTable& table, const TimeVaryingSlots& slots,
    const SpaceTimeTable::Case& what, const SpaceTimeTable::RankArray& ranks, const Slot* same);
  void AddFlatSides(const SpaceTimeTable& table, const TimeVaryingSlots& slots, const Item& item,
    const Code* codes, const SpaceTimeTable::Case& inside, const SpaceTimeTable::RankArray& ranks,
    const Slot* same);
  void Add(int kind, int number, const Slot* points, bool isTurned);

  std::vector<Simplex> Simplices;
  std::vector<Side> Sides;
};

}

#endif
