// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RadixSorter_h
#define interlume_RadixSorter_h

#include <cstdint>
#include <cstring>
#include <vector>

namespace interlume
{

/**
 * @class   RadixSorter
 * @brief   multithreaded radix sort of indices by 32-bit keys
 *
 * It sorts by the least significant digit first, and is stable: indices with equal keys remain
 * ascending. The result does not depend on the number of threads. Keys are sorted by their
 * difference from the minimum key, in at most three passes. Buffers of at most 20 bytes per key are
 * reused.
 */
class RadixSorter
{
public:
  /// Writes the indices 0 to \a number - 1 to \a order, in ascending order of their keys.
  void Sort(const std::uint32_t* keys, std::uint32_t number, std::uint32_t* order);

  /// Converts a number to a key. Keys have the same order as numbers, and -0 equals 0. NaN is
  /// invalid.
  static std::uint32_t MakeKey(float value)
  {
    constexpr std::uint32_t signBit = 0x80000000u;
    const float unsignedZero = value + 0.0f;
    std::uint32_t bits;
    std::memcpy(&bits, &unsignedZero, sizeof bits);
    return bits & signBit ? ~bits : bits | signBit;
  }

  /// Returns the memory size in bytes.
  std::size_t GetBytes() const;

private:
  struct Item
  {
    // The key minus the minimum key.
    std::uint32_t Key;
    std::uint32_t Number;
  };
  struct Digit
  {
    int Shift;
    std::uint32_t Mask;
  };

  // Sets the number of chunks, the minimum key, and the number of bits of the difference between
  // the maximum and the minimum key.
  void Prepare(const std::uint32_t* keys, std::uint32_t number);
  // Runs one pass. source(i) returns item i, and destination(position, item) stores an item.
  template <typename Source, typename Destination>
  void Scatter(Digit digit, const Source& source, const Destination& destination);
  template <typename Work>
  void ForEachChunk(const Work& work) const;

  std::uint32_t Number = 0;
  std::uint32_t Chunks = 0;
  std::uint32_t MinimumKey = 0;
  int Bits = 0;
  std::vector<Item> Items[2];
  // For each chunk and digit value: first the number of items, then the position of the next item.
  std::vector<std::uint32_t> Counts;
};

}

#endif
