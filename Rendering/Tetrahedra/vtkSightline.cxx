#include "vtkSightline.h"

#include <algorithm>

namespace
{
// Few events, as nearly always, are sorted fastest so.
void SortByInsertion(vtkSightline::Event* first, vtkSightline::Event* last)
{
  for (vtkSightline::Event* next = first + 1; next < last; ++next)
  {
    const vtkSightline::Event event = *next;
    vtkSightline::Event* place = next;
    for (; place > first && event < place[-1]; --place)
    {
      *place = place[-1];
    }
    *place = event;
  }
}
}

void vtkSightline::Relate(
  Event* first, Event* last, double tolerance, std::vector<Relation>& relations)
{
  constexpr std::ptrdiff_t few = 32;
  if (last - first <= few)
  {
    SortByInsertion(first, last);
  }
  else
  {
    std::sort(first, last);
  }
  const auto entries = std::count_if(first, last, [](const Event& e) { return e.IsEntry; });
  bool isInside = last - first - entries > entries;
  const Event* exit = nullptr;
  for (Event* event = first; event < last; ++event)
  {
    if (event->IsEntry == isInside)
    {
      Event* other = event + 1;
      while (other < last && other->IsEntry == isInside)
      {
        ++other;
      }
      if (other < last && other->Depth - event->Depth <= tolerance)
      {
        std::rotate(event, other, other + 1);
      }
    }
    isInside = event->IsEntry;
    if (!isInside)
    {
      exit = event;
    }
    else if (exit && exit->Face / 4 != event->Face / 4)
    {
      relations.push_back({ event->Face / 4, exit->Face / 4 });
    }
  }
}
