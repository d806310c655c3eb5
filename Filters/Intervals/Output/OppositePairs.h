// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OppositePairs_h
#define interlume_OppositePairs_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace interlume
{

/**
 * @class   OppositePairs
 * @brief   finds and removes pairs of simplices with the same points and opposite orientation
 */
class OppositePairs
{
public:
  /// A simplex, with its point ids in ascending order as its key. A group number may precede the
  /// ids, so that only simplices of the same group match.
  template <typename Id, std::size_t Size>
  struct Entry
  {
    std::array<Id, Size> Key;
    /// If true, sorting the point ids took an odd number of swaps.
    bool IsOdd;
    std::size_t Index;

    bool operator<(const Entry& other) const
    {
      return this->Key != other.Key ? this->Key < other.Key : this->Index < other.Index;
    }
  };

  /// Sorts \a number ids. Returns true if sorting took an odd number of swaps.
  template <typename Id>
  static bool Sort(Id* ids, int number)
  {
    bool isOdd = false;
    for (int end = number; end > 1; --end)
    {
      for (int i = 1; i < end; ++i)
      {
        if (ids[i] < ids[i - 1])
        {
          std::swap(ids[i], ids[i - 1]);
          isOdd = !isOdd;
        }
      }
    }
    return isOdd;
  }

  /// Sorts the entries and calls remove(index) for both simplices of each pair. If several
  /// simplices have the same points and orientation, those with the lowest indices are removed.
  template <typename Id, std::size_t Size, typename Remover>
  static void Find(std::vector<Entry<Id, Size>>& entries, Remover&& remove)
  {
    std::sort(entries.begin(), entries.end());
    for (auto first = entries.begin(); first != entries.end();)
    {
      const auto last = std::find_if(
        first, entries.end(), [first](const auto& entry) { return entry.Key != first->Key; });
      const auto odd = std::count_if(first, last, [](const auto& entry) { return entry.IsOdd; });
      auto left = std::min(odd, last - first - odd);
      std::array<decltype(left), 2> pairs{ { left, left } };
      for (; first != last; ++first)
      {
        if (pairs[first->IsOdd]-- > 0)
        {
          remove(first->Index);
        }
      }
    }
  }

  /// Removes the pairs from a list of simplices. The first \a Size values of each simplex are its
  /// point ids.
  template <std::size_t Size, typename Simplex>
  static void Remove(std::vector<Simplex>& simplices)
  {
    using Id = typename Simplex::value_type;
    if (!MayHaveDuplicates<Size>(simplices))
    {
      return;
    }
    std::vector<Entry<Id, Size>> entries(simplices.size());
    for (std::size_t s = 0; s < simplices.size(); ++s)
    {
      std::copy_n(simplices[s].begin(), Size, entries[s].Key.begin());
      entries[s].IsOdd = Sort(entries[s].Key.data(), static_cast<int>(Size));
      entries[s].Index = s;
    }
    std::vector<bool> isRemoved;
    Find(entries,
      [&](std::size_t index)
      {
        isRemoved.resize(simplices.size(), false);
        isRemoved[index] = true;
      });
    if (!isRemoved.empty())
    {
      std::size_t retained = 0;
      for (std::size_t s = 0; s < simplices.size(); ++s)
      {
        if (!isRemoved[s])
        {
          simplices[retained++] = simplices[s];
        }
      }
      simplices.resize(retained);
    }
  }

private:
  // Returns true if any two simplices may have the same points. This quick test rejects most
  // lists because duplicates are rare.
  template <std::size_t Size, typename Simplex>
  static bool MayHaveDuplicates(const std::vector<Simplex>& simplices)
  {
    constexpr std::size_t maximum = 256;
    const std::size_t number = simplices.size();
    if (number > maximum)
    {
      return true;
    }
    std::array<std::uint64_t, maximum> marks;
    for (std::size_t s = 0; s < number; ++s)
    {
      marks[s] = 0;
      for (std::size_t p = 0; p < Size; ++p)
      {
        marks[s] |= std::uint64_t(1) << (static_cast<unsigned>(simplices[s][p]) & 63u);
      }
    }
    const auto end = marks.begin() + static_cast<std::ptrdiff_t>(number);
    std::sort(marks.begin(), end);
    return std::adjacent_find(marks.begin(), end) != end;
  }
};

}

#endif
