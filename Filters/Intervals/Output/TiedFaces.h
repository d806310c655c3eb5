// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TiedFaces_h
#define interlume_TiedFaces_h

#include "Output/OppositePairs.h"

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <vector>

namespace interlume
{

/**
 * @class   TiedFaces
 * @brief   tells which boundary cells of \a Corners points are faces of simplices
 *
 * Where values equal a bound, boundary cells come from both sides of nothing, or from a part that
 * has no volume. Add() takes them, each of a group; Cancel() takes away pairs with the same points
 * and opposite orientation; Count() is told the faces of all simplices near, by any number of
 * threads; Visit() tells what was found.
 */
template <int Corners>
class TiedFaces
{
public:
  explicit TiedFaces(std::size_t numberOfPoints)
    : Near(numberOfPoints, false)
  {
  }

  bool IsEmpty() const { return this->Entries.empty(); }

  /// Adds a boundary cell; \a place is the caller's number for it.
  void Add(vtkIdType group, const vtkIdType* ids, std::size_t place)
  {
    this->Entries.push_back(MakeEntry(group, ids, place));
  }

  /// Takes away pairs of a group, and calls remove(place) for both.
  template <typename Remover>
  void Cancel(Remover&& remove)
  {
    std::vector<std::size_t> gone;
    OppositePairs::Find(this->Entries, [&](std::size_t place) { gone.push_back(place); });
    std::sort(gone.begin(), gone.end());
    this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                          [&gone](const Entry& entry)
                          { return std::binary_search(gone.begin(), gone.end(), entry.Place); }),
      this->Entries.end());
    std::for_each(gone.begin(), gone.end(), remove);
    for (const Entry& entry : this->Entries)
    {
      std::for_each(
        entry.Key.begin() + 1, entry.Key.end(), [this](vtkIdType id) { this->Near[id] = true; });
    }
    this->Uses = std::vector<Use>(this->Entries.size());
  }

  /// Returns whether enough of the points are those of boundary cells for a face to be one.
  bool IsNear(const vtkIdType* ids, int number) const
  {
    return std::count_if(ids, ids + number, [this](vtkIdType id) { return this->Near[id]; }) >=
      Corners;
  }

  /// Counts a face of a simplex, outward.
  void Count(vtkIdType group, const vtkIdType* face, vtkIdType simplex)
  {
    const Entry wanted = MakeEntry(group, face, 0);
    for (auto at = std::lower_bound(this->Entries.begin(), this->Entries.end(), wanted);
         at != this->Entries.end() && at->Key == wanted.Key; ++at)
    {
      this->Uses[at - this->Entries.begin()].Add(at->IsOdd == wanted.IsOdd, simplex);
    }
  }

  /// Calls visit(place, isFace, simplex) for the cells that Cancel() has left, with whether each is
  /// a face more often than turned over, and of which simplex first.
  template <typename Visitor>
  void Visit(Visitor&& visit) const
  {
    for (std::size_t e = 0; e < this->Entries.size(); ++e)
    {
      visit(this->Entries[e].Place, this->Uses[e].Net.load() > 0, this->Uses[e].First.load());
    }
  }

private:
  using Entry = OppositePairs::Entry<vtkIdType, Corners + 1>;

  struct Use
  {
    std::atomic<int> Net{ 0 };
    std::atomic<vtkIdType> First{ std::numeric_limits<vtkIdType>::max() };

    void Add(bool isAlike, vtkIdType simplex)
    {
      this->Net.fetch_add(isAlike ? 1 : -1, std::memory_order_relaxed);
      vtkIdType first = this->First.load(std::memory_order_relaxed);
      while (isAlike && simplex < first && !this->First.compare_exchange_weak(first, simplex))
      {
      }
    }
  };

  static Entry MakeEntry(vtkIdType group, const vtkIdType* ids, std::size_t place)
  {
    Entry entry{ { { group } }, false, place };
    std::copy_n(ids, Corners, entry.Key.begin() + 1);
    entry.IsOdd = OppositePairs::Sort(entry.Key.data() + 1, Corners);
    return entry;
  }

  std::vector<bool> Near;
  // The boundary cells, sorted from Cancel() on.
  std::vector<Entry> Entries;
  std::vector<Use> Uses;
};

}

#endif
