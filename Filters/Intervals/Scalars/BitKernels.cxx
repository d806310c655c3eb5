// SPDX-License-Identifier: BSD-3-Clause
#include "Scalars/BitKernels.h"

#include "Common/SimdDispatch.h"

#include <bitset>

namespace interlume
{

namespace
{
using BitKernels::Word;

inline vtkIdType Count(Word word)
{
  return static_cast<vtkIdType>(std::bitset<BitRows::BitsOfWord>(word).count());
}

template <bool IsSpecial>
inline vtkIdType CountOwnedOf(const BitRows::Row* rows, vtkIdType number)
{
  vtkIdType count = 0;
  for (vtkIdType word = 0; word < BitRows::GetNumberOfWords(number); ++word)
  {
    const BitKernels::Owned owned = BitKernels::FindOwnedPoints<IsSpecial>(rows, word, number);
    count += Count(owned.Edges[0]) + Count(owned.Edges[1]) + Count(owned.Edges[2]);
    count += IsSpecial ? Count(owned.Points) : 0;
  }
  return count;
}
}

vtkIdType BitKernels::CountOwnedPoints(const BitRows::Row* rows, vtkIdType number, bool isSpecial)
{
  return SimdDispatch::Call([&]
    { return isSpecial ? CountOwnedOf<true>(rows, number) : CountOwnedOf<false>(rows, number); });
}

vtkIdType BitKernels::CountNonFinite(const BitRows::Row* rows, vtkIdType number)
{
  vtkIdType count = 0;
  for (vtkIdType word = 0; word < BitRows::GetNumberOfWords(number); ++word)
  {
    std::uint64_t any = 0;
    for (int r = 0; r < 4; ++r)
    {
      any |= LoadWordPair(rows[r].NonFinite + word);
    }
    count +=
      Count(static_cast<Word>(any | (any >> 1)) & GetValid(word * BitRows::BitsOfWord, number - 1));
  }
  return count;
}

vtkIdType BitKernels::FindCells(
  const BitRows::Row* rows, vtkIdType number, std::uint32_t* columns, std::uint8_t* keys)
{
  vtkIdType found = 0;
  for (vtkIdType word = 0; word < BitRows::GetNumberOfWords(number); ++word)
  {
    const vtkIdType first = word * BitRows::BitsOfWord;
    const std::uint64_t a = LoadWordPair(rows[0].Above + word);
    const std::uint64_t b = LoadWordPair(rows[1].Above + word);
    const std::uint64_t c = LoadWordPair(rows[2].Above + word);
    const std::uint64_t d = LoadWordPair(rows[3].Above + word);
    const std::uint64_t any = a | b | c | d;
    const std::uint64_t all = a & b & c & d;
    const auto mixed = static_cast<Word>((any | (any >> 1)) & ~(all & (all >> 1)));
    ForEach(mixed & GetValid(first, number - 1),
      [&](int i)
      {
        columns[found] = static_cast<std::uint32_t>(first + i);
        keys[found++] = static_cast<std::uint8_t>(
          ((a >> i) & 3) | (((b >> i) & 3) << 2) | (((c >> i) & 3) << 4) | (((d >> i) & 3) << 6));
      });
  }
  return found;
}

}
