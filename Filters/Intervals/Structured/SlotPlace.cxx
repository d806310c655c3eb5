// SPDX-License-Identifier: BSD-3-Clause
#include "Structured/SlotPlace.h"

#include "Scalars/ExtractionValues.h"

namespace interlume
{

std::vector<SlotPlace> SlotPlace::FindAll(const vtkIsotable& table, const ExtractionValues& values)
{
  const bool hasOneItem = values.GetItems().size() == 1;
  std::vector<SlotPlace> places;
  const auto add = [&places, hasOneItem](int a, int b, int direction, int kind)
  {
    places.push_back(
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
  return places;
}

vtkIsotable::RankArray SlotPlace::FindRanks(const vtkIsotable& table)
{
  constexpr Slot ascending[8] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  return table.GetSlotRanks(ascending);
}

}
