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
 * @brief   cut of a case between two time steps, in a cell where several slots are the same point
 *
 * This class corresponds to MergedCut, with time as an additional axis. It also finds the boundary
 * cells of all kinds. The sides of the convex pieces are triangulated separately because a piece
 * without hypervolume also has sides. The volume and its surfaces at a step equal the result of
 * vtkIntervalVolume for that step.
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

  /// Cuts the case in the order of \a ranks. \a same maps each slot to the slot that represents its
  /// point. \a inside is the case with all corners inside the interval. If \a hasSides is false,
  /// boundary cells are not computed.
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
