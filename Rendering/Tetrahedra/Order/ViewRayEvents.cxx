// SPDX-License-Identifier: BSD-3-Clause
#include "Order/ViewRayEvents.h"

#include <algorithm>

namespace interlume
{

namespace
{
// Insertion sort, which is fastest for few events.
void SortByInsertion(ViewRayEvents::Event* first, ViewRayEvents::Event* last)
{
  for (ViewRayEvents::Event* next = first + 1; next < last; ++next)
  {
    const ViewRayEvents::Event event = *next;
    ViewRayEvents::Event* slot = next;
    for (; slot > first && event < slot[-1]; --slot)
    {
      *slot = slot[-1];
    }
    *slot = event;
  }
}

// Removes both events of each tetrahedron that the ray only touches. Because of rounding, either
// event may be first. Returns the new end.
ViewRayEvents::Event* RemoveTouched(
  ViewRayEvents::Event* first, ViewRayEvents::Event* last, double tolerance)
{
  ViewRayEvents::Event* end = first;
  while (first < last)
  {
    ViewRayEvents::Event* other = first + 1;
    while (other < last && other->Depth - first->Depth <= tolerance &&
      (other->Face / 4 != first->Face / 4 || other->IsEntry == first->IsEntry))
    {
      ++other;
    }
    if (other < last && other->Depth - first->Depth <= tolerance)
    {
      // Shift the events in between to close the gap.
      std::copy_backward(first + 1, other, other + 1);
      first += 2;
    }
    else
    {
      *end++ = *first++;
    }
  }
  return end;
}

// Moves the first entry (or the first exit if isEntry is false) to the front if its depth is within
// the tolerance of the first depth.
void BringForward(
  ViewRayEvents::Event* first, ViewRayEvents::Event* last, bool isEntry, double tolerance)
{
  ViewRayEvents::Event* match = first;
  while (match < last && match->IsEntry != isEntry)
  {
    ++match;
  }
  if (match < last && match->Depth - first->Depth <= tolerance)
  {
    std::rotate(first, match, match + 1);
  }
}
}

void ViewRayEvents::Relate(
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
  last = RemoveTouched(first, last, tolerance);
  const auto entries = std::count_if(first, last, [](const Event& e) { return e.IsEntry; });
  bool isInside = last - first - entries > entries;
  const Event* entry = nullptr;
  const Event* exit = nullptr;
  // Relates the last exit to the entry after it.
  const auto relate = [&]()
  {
    if (entry && exit && exit->Face / 4 != entry->Face / 4)
    {
      relations.push_back({ entry->Face / 4, exit->Face / 4 });
    }
    entry = nullptr;
  };
  for (Event* event = first; event < last; ++event)
  {
    BringForward(event, last, !isInside, tolerance);
    isInside = event->IsEntry;
    if (isInside)
    {
      relate();
      entry = event;
    }
    else if (entry && event->Depth - entry->Depth <= tolerance)
    {
      entry = nullptr;
    }
    else
    {
      relate();
      exit = event;
    }
  }
  relate();
}

}
