// SPDX-License-Identifier: BSD-3-Clause
#include "Order/RadixSorter.h"

#include "Common/ParallelFor.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace interlume
{

namespace
{
// With 2048 digit values, all write positions and their cache lines fit in the L2 cache.
constexpr int DigitBits = 11;
constexpr std::uint32_t MinimumChunk = 16384;
constexpr std::uint32_t MaximumChunks = 32;
}

template <typename Work>
void RadixSorter::ForEachChunk(const Work& work) const
{
  const std::uint64_t number = this->Number;
  const std::uint64_t chunks = this->Chunks;
  ParallelFor(0, this->Chunks, 1,
    [&](vtkIdType chunk)
    {
      work(static_cast<std::uint32_t>(chunk), static_cast<std::uint32_t>(number * chunk / chunks),
        static_cast<std::uint32_t>(number * (chunk + 1) / chunks));
    });
}

void RadixSorter::Prepare(const std::uint32_t* keys, std::uint32_t number)
{
  this->Number = number;
  this->Chunks = std::clamp(number / MinimumChunk, 1u, MaximumChunks);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges(this->Chunks);
  this->ForEachChunk(
    [&](std::uint32_t chunk, std::uint32_t first, std::uint32_t last)
    {
      std::uint32_t minimum = ~0u;
      std::uint32_t maximum = 0;
      for (std::uint32_t i = first; i < last; ++i)
      {
        minimum = std::min(minimum, keys[i]);
        maximum = std::max(maximum, keys[i]);
      }
      ranges[chunk] = { minimum, maximum };
    });
  this->MinimumKey = ~0u;
  std::uint32_t maximum = 0;
  for (const auto& range : ranges)
  {
    this->MinimumKey = std::min(this->MinimumKey, range.first);
    maximum = std::max(maximum, range.second);
  }
  this->Bits = 0;
  for (std::uint32_t rest = number ? maximum - this->MinimumKey : 0; rest; rest >>= 1)
  {
    ++this->Bits;
  }
}

template <typename Source, typename Destination>
void RadixSorter::Scatter(Digit digit, const Source& source, const Destination& destination)
{
  const std::uint32_t values = digit.Mask + 1;
  this->Counts.resize(static_cast<std::size_t>(this->Chunks) * values);
  this->ForEachChunk(
    [&](std::uint32_t chunk, std::uint32_t first, std::uint32_t last)
    {
      std::uint32_t* counts = &this->Counts[static_cast<std::size_t>(chunk) * values];
      std::fill(counts, counts + values, 0);
      for (std::uint32_t i = first; i < last; ++i)
      {
        ++counts[(source(i).Key >> digit.Shift) & digit.Mask];
      }
    });
  std::uint32_t position = 0;
  for (std::uint32_t value = 0; value < values; ++value)
  {
    for (std::uint32_t chunk = 0; chunk < this->Chunks; ++chunk)
    {
      std::uint32_t& count = this->Counts[static_cast<std::size_t>(chunk) * values + value];
      position += std::exchange(count, position);
    }
  }
  this->ForEachChunk(
    [&](std::uint32_t chunk, std::uint32_t first, std::uint32_t last)
    {
      std::uint32_t* positions = &this->Counts[static_cast<std::size_t>(chunk) * values];
      for (std::uint32_t i = first; i < last; ++i)
      {
        const Item item = source(i);
        destination(positions[(item.Key >> digit.Shift) & digit.Mask]++, item);
      }
    });
}

void RadixSorter::Sort(const std::uint32_t* keys, std::uint32_t number, std::uint32_t* order)
{
  this->Prepare(keys, number);
  const int passes = (this->Bits + DigitBits - 1) / DigitBits;
  if (passes == 0)
  {
    std::iota(order, order + number, 0);
    return;
  }
  const int digitBits = (this->Bits + passes - 1) / passes;
  const std::uint32_t minimum = this->MinimumKey;
  const auto input = [keys, minimum](std::uint32_t i) { return Item{ keys[i] - minimum, i }; };
  const auto output = [order](std::uint32_t position, Item item) { order[position] = item.Number; };
  for (int pass = 0; pass < passes; ++pass)
  {
    const Digit digit = { pass * digitBits, (1u << digitBits) - 1 };
    const bool isFirst = pass == 0;
    const bool isLast = pass + 1 == passes;
    // Passes alternate between the two buffers.
    std::vector<Item>& to = this->Items[pass & 1];
    if (!isLast)
    {
      to.resize(number);
    }
    const Item* from = this->Items[(pass + 1) & 1].data();
    const auto read = [from](std::uint32_t i) { return from[i]; };
    const auto write = [items = to.data()](std::uint32_t position, Item item)
    { items[position] = item; };
    if (isFirst && isLast)
    {
      this->Scatter(digit, input, output);
    }
    else if (isFirst)
    {
      this->Scatter(digit, input, write);
    }
    else if (isLast)
    {
      this->Scatter(digit, read, output);
    }
    else
    {
      this->Scatter(digit, read, write);
    }
  }
}

std::size_t RadixSorter::GetBytes() const
{
  return (this->Items[0].capacity() + this->Items[1].capacity()) * sizeof(Item) +
    this->Counts.capacity() * sizeof(std::uint32_t);
}

}
