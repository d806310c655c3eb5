// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/SlotLocation.h"

#include "Scalars/ExtractionValues.h"

namespace interlume
{

std::vector<SlotLocation> SlotLocation::FindAll(
  const vtkIsotable& table, const ExtractionValues& values)
{
  const bool hasOneItem = values.GetItems().size() == 1;
  std::vector<SlotLocation> locations;
  const auto add = [&locations, hasOneItem](int a, int b, int direction, int kind)
  {
    locations.push_back(
      { static_cast<Slot>(a >> 1), static_cast<Slot>(a & 1), static_cast<Slot>(direction),
        static_cast<Slot>(kind), { static_cast<Slot>(a), static_cast<Slot>(b) },
        direction != 0 && (kind == 1 || !hasOneItem) });
  };
  for (int v = 0; v < 8; ++v)
  {
    add(v, v, 0, 0);
  }
  for (int kind = 0; kind < 2; ++kind)
  {
    for (int e = 0; e < table.GetNumberOfEdges(); ++e)
    {
      const int a = table.GetEdge(e)[0];
      const int b = table.GetEdge(e)[1];
      add(a, b, b - a == 1 ? 1 : b - a == 2 ? 2 : 3, kind);
    }
  }
  return locations;
}

vtkIsotable::RankArray SlotLocation::FindRanks(const vtkIsotable& table)
{
  constexpr Slot ascending[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  return table.GetSlotRanks(ascending);
}

}
