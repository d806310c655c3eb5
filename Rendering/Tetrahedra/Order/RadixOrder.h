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
 * @brief   threaded radix sort of numbers by keys of 32 bits
 *
 * It sorts by the least significant digit first, and is stable: equal keys stay in ascending order
 * of their numbers, so the result does not depend on the number of threads. Only the bits in which
 * keys differ are visited, in at most three passes. Working memory, 20 bytes a key at most, is kept
 * from call to call.
 */
class RadixOrder
{
public:
  /// Writes the numbers 0 to \a number - 1 to \a order, in ascending order of their keys.
  void Sort(const std::uint32_t* keys, std::uint32_t number, std::uint32_t* order);

  /// Returns the key that sorts as a float does; -0 equals 0. NaN has no key.
  static std::uint32_t MakeKey(float value)
  {
    constexpr std::uint32_t signBit = 0x80000000u;
    const float unsignedZero = value + 0.0f;
    std::uint32_t bits;
    std::memcpy(&bits, &unsignedZero, sizeof bits);
    return bits & signBit ? ~bits : bits | signBit;
  }

  /// Returns the bytes held.
  std::size_t GetBytes() const;

private:
  struct Item
  {
    // The key, counted from the least key of all.
    std::uint32_t Key;
    std::uint32_t Number;
  };
  struct Digit
  {
    int Shift;
    std::uint32_t Mask;
  };

  // Sets the number of chunks, the least key and the bits in which keys differ.
  void Prepare(const std::uint32_t* keys, std::uint32_t number);
  // Makes one pass; Source is callable with a position, Destination with a position and an item.
  template <typename Source, typename Destination>
  void Scatter(Digit digit, const Source& source, const Destination& destination);
  template <typename Work>
  void ForChunks(const Work& work) const;

  std::uint32_t Number = 0;
  std::uint32_t Chunks = 0;
  std::uint32_t LeastKey = 0;
  int Bits = 0;
  std::vector<Item> Items[2];
  // The counts for each chunk and each value of a digit: how many, then where the next goes.
  std::vector<std::uint32_t> Counts;
};

}

#endif
