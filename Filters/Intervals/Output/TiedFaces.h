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
 * @brief   determines which boundary cells, of \a Corners points each, are faces of simplices
 *
 * If values equal a bound, two boundary cells with the same points and opposite orientation may
 * enclose no volume, and others may bound a degenerate region. Call Add() for all boundary cells,
 * Cancel() to remove opposite pairs, Count() for the faces of all simplices that are near boundary
 * cells, and Visit() to get the result. Count() is thread-safe.
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

  /// Adds a boundary cell. \a index identifies it for the caller.
  void Add(vtkIdType group, const vtkIdType* ids, std::size_t index)
  {
    this->Entries.push_back(MakeEntry(group, ids, index));
  }

  /// Removes opposite pairs of the same group, and calls remove(index) for both cells.
  template <typename Remover>
  void Cancel(Remover&& remove)
  {
    std::vector<std::size_t> removed;
    OppositePairs::Find(this->Entries, [&](std::size_t index) { removed.push_back(index); });
    std::sort(removed.begin(), removed.end());
    this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                          [&removed](const Entry& entry) {
                            return std::binary_search(removed.begin(), removed.end(), entry.Index);
                          }),
      this->Entries.end());
    std::for_each(removed.begin(), removed.end(), remove);
    for (const Entry& entry : this->Entries)
    {
      std::for_each(
        entry.Key.begin() + 1, entry.Key.end(), [this](vtkIdType id) { this->Near[id] = true; });
    }
    this->Uses = std::vector<Use>(this->Entries.size());
  }

  /// Returns true if at least \a Corners points of a cell belong to boundary cells, so that one of
  /// its faces may be a boundary cell.
  bool IsNear(const vtkIdType* ids, int number) const
  {
    return std::count_if(ids, ids + number, [this](vtkIdType id) { return this->Near[id]; }) >=
      Corners;
  }

  /// Counts a face of a simplex if it has the points of a boundary cell. The face is oriented
  /// outward, or has the orientation of the boundary cell if \a isOriented is false.
  void Count(vtkIdType group, const vtkIdType* face, vtkIdType simplex, bool isOriented = true)
  {
    const Entry target = MakeEntry(group, face, 0);
    for (auto at = std::lower_bound(this->Entries.begin(), this->Entries.end(), target);
         at != this->Entries.end() && at->Key == target.Key; ++at)
    {
      this->Uses[at - this->Entries.begin()].Add(!isOriented || at->IsOdd == target.IsOdd, simplex);
    }
  }

  /// Calls visit(index, isFace, simplex) for the cells remaining after Cancel(). \a isFace is true
  /// if more of the counted faces have the same orientation as the cell than the opposite one.
  /// \a simplex is then the first simplex with such a face.
  template <typename Visitor>
  void Visit(Visitor&& visit) const
  {
    for (std::size_t e = 0; e < this->Entries.size(); ++e)
    {
      visit(this->Entries[e].Index, this->Uses[e].Net.load() > 0, this->Uses[e].First.load());
    }
  }

private:
  using Entry = OppositePairs::Entry<vtkIdType, Corners + 1>;

  struct Use
  {
    std::atomic<int> Net{ 0 };
    std::atomic<vtkIdType> First{ std::numeric_limits<vtkIdType>::max() };

    void Add(bool isSameOrientation, vtkIdType simplex)
    {
      this->Net.fetch_add(isSameOrientation ? 1 : -1, std::memory_order_relaxed);
      vtkIdType first = this->First.load(std::memory_order_relaxed);
      while (
        isSameOrientation && simplex < first && !this->First.compare_exchange_weak(first, simplex))
      {
      }
    }
  };

  static Entry MakeEntry(vtkIdType group, const vtkIdType* ids, std::size_t index)
  {
    Entry entry{ { { group } }, false, index };
    std::copy_n(ids, Corners, entry.Key.begin() + 1);
    entry.IsOdd = OppositePairs::Sort(entry.Key.data() + 1, Corners);
    return entry;
  }

  std::vector<bool> Near;
  // The boundary cells, sorted by Cancel().
  std::vector<Entry> Entries;
  std::vector<Use> Uses;
};

}

#endif
