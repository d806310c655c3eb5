// SPDX-License-Identifier: BSD-3-Clause
#include "TimeVarying/TimeVaryingCut.h"

#include "Cuts/CoincidentSlots.h"
#include "Output/OppositePairs.h"

#include "vtkTimeVaryingSettings.h"

#include <algorithm>

namespace interlume
{

namespace
{
using Kinds = vtkTimeVaryingSettings::BoundaryKinds;
using Sides = SpaceTimeSlots::Sides;
using Slot = SpaceTimeTable::Slot;
using SideArray = std::array<std::uint8_t, SpaceTimeTable::MaximumNumberOfSlots>;

// Bit used in addition to those of Sides: the value at the corner equals the bound of an interval
// of zero width.
constexpr unsigned Equal = 16;

int GetNumberOfSlots(const SpaceTimeTable& table)
{
  return table.GetNumberOfVertices() + 2 * table.GetNumberOfEdges();
}
}

void TimeVaryingCut::Compute(const SpaceTimeTable& table, const SpaceTimeSlots& slots,
  const Item& item, const Code* codes, const SpaceTimeTable::Case& what,
  const SpaceTimeTable::Case& inside, const SpaceTimeTable::RankArray& ranks, const Slot* same,
  bool hasSides)
{
  this->Simplices.clear();
  this->Sides.clear();
  const Code* const end = codes + table.GetNumberOfVertices();
  if (item.IsFlat && std::any_of(codes, end, [&item](Code code) { return code != item.First; }))
  {
    if (hasSides)
    {
      this->AddFlatSides(table, slots, item, codes, inside, ranks, same);
    }
    return;
  }
  table.CutMerged(what, ranks, same,
    [this](const Simplex& simplex)
    {
      if (!CoincidentSlots::IsCollapsed(simplex.data(), 5))
      {
        this->Simplices.push_back(simplex);
      }
    });
  OppositePairs::Remove<5>(this->Simplices);
  if (hasSides)
  {
    this->AddSides(table, slots, what, ranks, same);
  }
}

void TimeVaryingCut::Add(int kind, int number, const Slot* points, bool isReversed)
{
  if (CoincidentSlots::IsCollapsed(points, number))
  {
    return;
  }
  Side side{ {}, number, kind };
  std::copy_n(points, number, side.Points.begin());
  if (isReversed)
  {
    std::swap(side.Points[0], side.Points[1]);
  }
  this->Sides.push_back(side);
}

void TimeVaryingCut::AddSides(const SpaceTimeTable& table, const SpaceTimeSlots& slots,
  const SpaceTimeTable::Case& what, const SpaceTimeTable::RankArray& ranks, const Slot* same)
{
  SideArray sides{};
  for (int slot = 0; slot < GetNumberOfSlots(table); ++slot)
  {
    sides[slot] = slots.GetSides(static_cast<Slot>(slot));
  }
  table.CutSides(
    what, ranks, same, sides.data(),
    [this](unsigned on, const std::array<Slot, 4>& points)
    {
      if (on & (Sides::LOWER | Sides::UPPER))
      {
        this->Add(on & Sides::LOWER ? Kinds::LOWER_SURFACE_IN_TIME : Kinds::UPPER_SURFACE_IN_TIME,
          4, points.data(), false);
      }
      if (on & (Sides::START | Sides::END))
      {
        const bool isAtEnd = on & Sides::END;
        this->Add(
          isAtEnd ? Kinds::VOLUME_AT_END : Kinds::VOLUME_AT_START, 4, points.data(), isAtEnd);
      }
    },
    [this](unsigned on, unsigned onPolygon, const std::array<Slot, 3>& points)
    {
      if ((on & (Sides::START | Sides::END)) && (onPolygon & (Sides::LOWER | Sides::UPPER)))
      {
        const bool isAtEnd = on & Sides::END;
        const int lower = isAtEnd ? Kinds::LOWER_SURFACE_AT_END : Kinds::LOWER_SURFACE_AT_START;
        const int upper = isAtEnd ? Kinds::UPPER_SURFACE_AT_END : Kinds::UPPER_SURFACE_AT_START;
        this->Add(onPolygon & Sides::LOWER ? lower : upper, 3, points.data(), isAtEnd);
      }
    });
}

void TimeVaryingCut::AddFlatSides(const SpaceTimeTable& table, const SpaceTimeSlots& slots,
  const Item& item, const Code* codes, const SpaceTimeTable::Case& inside,
  const SpaceTimeTable::RankArray& ranks, const Slot* same)
{
  const int vertices = table.GetNumberOfVertices();
  const Code tie = item.First;
  // The surface belongs to the lower bound if the value at any corner is less than the bound,
  // otherwise to the upper bound. Test all corners together, and the corners at each step
  // separately.
  const int corners = vertices / 2;
  const int upper = *std::min_element(codes, codes + vertices) < tie ? 0 : 1;
  const int upperAt[2] = { *std::min_element(codes, codes + corners) < tie ? 0 : 1,
    *std::min_element(codes + corners, codes + vertices) < tie ? 0 : 1 };
  SideArray sides{};
  // The steps at which the values at all corners equal the bound.
  unsigned full = Sides::START | Sides::END;
  for (int v = 0; v < vertices; ++v)
  {
    const Slot slot = static_cast<Slot>(v);
    const unsigned at = slots.GetSides(slot);
    sides[v] = static_cast<std::uint8_t>(at | (codes[v] == tie ? Equal : 0));
    full &= codes[v] == tie ? full : ~at;
  }
  table.CutSides(
    inside, ranks, same, sides.data(),
    [&](unsigned on, const std::array<Slot, 4>& points)
    {
      if (on & Equal)
      {
        // Reverse the side, because the region that it bounds is in the neighbor cell.
        this->Add(Kinds::LOWER_SURFACE_IN_TIME + upper, 4, points.data(), true);
        if (on & full)
        {
          const bool isAtEnd = on & Sides::END;
          this->Add(
            isAtEnd ? Kinds::VOLUME_AT_END : Kinds::VOLUME_AT_START, 4, points.data(), isAtEnd);
        }
      }
    },
    [&](unsigned on, unsigned onPolygon, const std::array<Slot, 3>& points)
    {
      const unsigned step = on & (Sides::START | Sides::END);
      if (step && (onPolygon & Equal) && !(full & step))
      {
        const bool isAtEnd = step == Sides::END;
        const int lower = isAtEnd ? Kinds::LOWER_SURFACE_AT_END : Kinds::LOWER_SURFACE_AT_START;
        this->Add(lower + upperAt[isAtEnd], 3, points.data(), !isAtEnd);
      }
    });
}

}
