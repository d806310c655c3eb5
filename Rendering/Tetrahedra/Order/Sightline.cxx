// SPDX-License-Identifier: BSD-3-Clause
#include "Order/Sightline.h"

#include <algorithm>

namespace interlume
{

namespace
{
// Sorts few events, as there nearly always are, in the fastest way.
void SortByInsertion(Sightline::Event* first, Sightline::Event* last)
{
  for (Sightline::Event* next = first + 1; next < last; ++next)
  {
    const Sightline::Event event = *next;
    Sightline::Event* place = next;
    for (; place > first && event < place[-1]; --place)
    {
      *place = place[-1];
    }
    *place = event;
  }
}

// Leaves out tetrahedra that a line only touches, whose two events are in either order; returns the
// end of what is left.
Sightline::Event* RemoveTouched(Sightline::Event* first, Sightline::Event* last, double tolerance)
{
  Sightline::Event* kept = first;
  while (first < last)
  {
    Sightline::Event* other = first + 1;
    while (other < last && other->Depth - first->Depth <= tolerance &&
      (other->Face / 4 != first->Face / 4 || other->IsEntry == first->IsEntry))
    {
      ++other;
    }
    if (other < last && other->Depth - first->Depth <= tolerance)
    {
      // Events before the other one take its place.
      std::copy_backward(first + 1, other, other + 1);
      first += 2;
    }
    else
    {
      *kept++ = *first++;
    }
  }
  return kept;
}

// Makes the first event of the wanted kind, where there is one as near as that, change places with
// those before it.
void BringForward(
  Sightline::Event* first, Sightline::Event* last, bool wantsEntry, double tolerance)
{
  Sightline::Event* wanted = first;
  while (wanted < last && wanted->IsEntry != wantsEntry)
  {
    ++wanted;
  }
  if (wanted < last && wanted->Depth - first->Depth <= tolerance)
  {
    std::rotate(first, wanted, wanted + 1);
  }
}
}

void Sightline::Relate(
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
  // Relates the last exit and the entry after it.
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
