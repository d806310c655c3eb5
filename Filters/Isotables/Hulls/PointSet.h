// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PointSet_h
#define interlume_PointSet_h

#include <array>
#include <cstdint>

namespace interlume
{

/**
 * @class   PointSet
 * @brief   a set of integers from 0 to 127
 *
 * Represents the hull points on a face. Face lattices are built with subset tests and
 * intersections.
 */
class PointSet
{
public:
  static constexpr int Capacity = 128;

  void Insert(int i) { this->Words[i >> 6] |= std::uint64_t(1) << (i & 63); }
  void Remove(int i) { this->Words[i >> 6] &= ~(std::uint64_t(1) << (i & 63)); }
  bool Contains(int i) const { return (this->Words[i >> 6] >> (i & 63)) & 1; }
  bool IsEmpty() const { return this->Words[0] == 0 && this->Words[1] == 0; }

  int Count() const { return CountBits(this->Words[0]) + CountBits(this->Words[1]); }

  bool HasAtLeast(int number) const
  {
    std::uint64_t low = this->Words[0];
    std::uint64_t high = this->Words[1];
    for (; number > 0 && low != 0; --number)
    {
      low &= low - 1;
    }
    for (; number > 0 && high != 0; --number)
    {
      high &= high - 1;
    }
    return number <= 0;
  }

  /// Returns the smallest member of a non-empty set.
  int GetFirst() const
  {
    return this->Words[0] != 0 ? FindLowestBit(this->Words[0]) : 64 + FindLowestBit(this->Words[1]);
  }

  bool IsSubsetOf(const PointSet& other) const
  {
    return (this->Words[0] & ~other.Words[0]) == 0 && (this->Words[1] & ~other.Words[1]) == 0;
  }

  PointSet operator&(const PointSet& other) const
  {
    PointSet result;
    result.Words = { this->Words[0] & other.Words[0], this->Words[1] & other.Words[1] };
    return result;
  }

  /// Returns the members that are not in \a other.
  PointSet operator-(const PointSet& other) const
  {
    PointSet result;
    result.Words = { this->Words[0] & ~other.Words[0], this->Words[1] & ~other.Words[1] };
    return result;
  }

  bool operator==(const PointSet& other) const
  {
    return this->Words[0] == other.Words[0] && this->Words[1] == other.Words[1];
  }
  bool operator!=(const PointSet& other) const { return !(*this == other); }
  bool operator<(const PointSet& other) const { return this->Words < other.Words; }

  /// Calls \a visit with each member in increasing order.
  template <typename Visitor>
  void ForEach(Visitor&& visit) const
  {
    for (int word = 0; word < 2; ++word)
    {
      for (std::uint64_t bits = this->Words[word]; bits != 0; bits &= bits - 1)
      {
        visit(64 * word + FindLowestBit(bits));
      }
    }
  }

private:
  // Counts bits by summing groups of 2, 4 and 8 bits in parallel, then the bytes.
  static int CountBits(std::uint64_t bits)
  {
    bits -= (bits >> 1) & 0x5555555555555555u;
    bits = (bits & 0x3333333333333333u) + ((bits >> 2) & 0x3333333333333333u);
    bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return static_cast<int>((bits * 0x0101010101010101u) >> 56);
  }

  // Returns the index of the lowest set bit, which is the number of bits below it.
  static int FindLowestBit(std::uint64_t bits) { return CountBits((bits & -bits) - 1); }

  std::array<std::uint64_t, 2> Words{ { 0, 0 } };
};

}

#endif
