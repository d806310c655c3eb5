// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RadixOrder_h
#define interlume_RadixOrder_h

#include <cstdint>
#include <cstring>
#include <vector>

namespace interlume
{

/**
 * @class   RadixOrder
 * @brief   multithreaded radix sort of indices by 32-bit keys
 *
 * It sorts by the least significant digit first, and is stable: indices with equal keys remain
 * ascending. The result does not depend on the number of threads. Keys are sorted by their
 * difference from the minimum key, in at most three passes. Buffers of at most 20 bytes per key are
 * reused.
 */
class RadixOrder
{
public:
  /// Writes the indices 0 to \a number - 1 to \a order, in ascending order of their keys.
  void Sort(const std::uint32_t* keys, std::uint32_t number, std::uint32_t* order);

  /// Returns a key that has the same order as \a value; -0 equals 0. NaN has no key.
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

  // Sets the number of chunks, the minimum key and the number of bits of the largest difference
  // from it.
  void Prepare(const std::uint32_t* keys, std::uint32_t number);
  // Runs one pass. Source is called with an index, Destination with an index and an item.
  template <typename Source, typename Destination>
  void Scatter(Digit digit, const Source& source, const Destination& destination);
  template <typename Work>
  void ForChunks(const Work& work) const;

  std::uint32_t Number = 0;
  std::uint32_t Chunks = 0;
  std::uint32_t MinimumKey = 0;
  int Bits = 0;
  std::vector<Item> Items[2];
  // Counts for each chunk and each digit value, then the next index to write.
  std::vector<std::uint32_t> Counts;
};

}

#endif
