// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BitKernels_h
#define interlume_BitKernels_h

#include "Scalars/BitRows.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#if defined(_MSC_VER)
#include <intrin.h>
#endif

namespace interlume
{

/**
 * Inner loops over rows of bits.
 */
namespace BitKernels
{
using Word = BitRows::Word;

/// Packs bytes, each 0 or 1, into the bits of a word.
inline Word Pack(const std::uint8_t* bytes)
{
  // Byte i of eight becomes bit i of the product's highest byte. No two terms of the product
  // overlap.
#if defined(VTK_WORDS_BIGENDIAN)
  constexpr std::uint64_t factor = 0x8040201008040201;
#else
  constexpr std::uint64_t factor = 0x0102040810204080;
#endif
  Word word = 0;
  for (int part = 0; part < BitRows::BitsOfWord / 8; ++part)
  {
    std::uint64_t eight;
    std::memcpy(&eight, bytes + 8 * part, sizeof(eight));
    word |= static_cast<Word>((eight * factor) >> 56) << (8 * part);
  }
  return word;
}

/// Returns whether \a test is true for any of \a number values. The results are combined in bytes,
/// which compilers vectorize for any value type.
template <typename T, typename Test>
bool HasAny(const T* values, vtkIdType number, Test&& test)
{
  constexpr int size = BitRows::BitsOfWord;
  std::uint8_t bytes[size] = {};
  vtkIdType first = 0;
  for (; first + size <= number; first += size)
  {
    for (int i = 0; i < size; ++i)
    {
      bytes[i] = static_cast<std::uint8_t>(bytes[i] | std::uint8_t(test(values[first + i])));
    }
  }
  for (; first < number; ++first)
  {
    bytes[0] = static_cast<std::uint8_t>(bytes[0] | std::uint8_t(test(values[first])));
  }
  return std::any_of(bytes, bytes + size, [](std::uint8_t byte) { return byte != 0; });
}

/// Sets the bits of the values for which \a test is true, and appends a word of zeros.
template <typename T, typename Test>
void Fill(const T* values, vtkIdType number, Word* words, Test&& test)
{
  constexpr int size = BitRows::BitsOfWord;
  std::uint8_t bytes[size] = {};
  vtkIdType first = 0;
  for (; first + size <= number; first += size)
  {
    for (int i = 0; i < size; ++i)
    {
      bytes[i] = test(values[first + i]);
    }
    *words++ = Pack(bytes);
  }
  if (first < number)
  {
    std::memset(bytes, 0, sizeof(bytes));
    for (int i = 0; first + i < number; ++i)
    {
      bytes[i] = test(values[first + i]);
    }
    *words++ = Pack(bytes);
  }
  *words = 0;
}

/// Returns the index of the lowest set bit of a nonzero word.
inline int FindLowestBit(Word word)
{
#if defined(__GNUC__)
  return __builtin_ctz(word);
#elif defined(_MSC_VER)
  unsigned long index;
  _BitScanForward(&index, word);
  return static_cast<int>(index);
#else
  int index = 0;
  while (!((word >> index) & 1))
  {
    ++index;
  }
  return index;
#endif
}

/// Calls \a visit(i) for the set bits in increasing order.
template <typename Visitor>
void ForEach(Word word, Visitor&& visit)
{
  for (; word != 0; word &= word - 1)
  {
    visit(FindLowestBit(word));
  }
}

/// Returns a word and its successor as 64 bits, with the successor in the upper half.
inline std::uint64_t LoadWordPair(const Word* word)
{
  return word[0] | (static_cast<std::uint64_t>(word[1]) << BitRows::BitsOfWord);
}

/// Returns a mask for the word that starts at point \a first of a row. It contains the bits that
/// belong to the first \a number points of the row.
inline Word GetValid(vtkIdType first, vtkIdType number)
{
  const vtkIdType left = number - first;
  return left >= BitRows::BitsOfWord ? ~Word(0) : left > 0 ? (Word(1) << left) - 1 : Word(0);
}

/// Output points owned by the grid points of a word: the grid points themselves and the points on
/// their edges along i, j and k.
struct Owned
{
  Word Points;
  Word Edges[3];
};

/**
 * Finds the output points owned by the grid points of a word. \a word is its index in a row of
 * \a number points. \a rows contains the row and its neighbors along j and k; a missing neighbor is
 * replaced with the row itself. If \a IsSpecial is false, Ties and NonFinite bits must be 0.
 */
template <bool IsSpecial>
inline Owned FindOwnedPoints(const BitRows::Row* rows, vtkIdType word, vtkIdType number)
{
  const std::uint64_t above = LoadWordPair(rows[0].Above + word);
  Owned owned;
  owned.Points = 0;
  owned.Edges[0] =
    static_cast<Word>(above ^ (above >> 1)) & GetValid(word * BitRows::BitsOfWord, number - 1);
  owned.Edges[1] = rows[0].Above[word] ^ rows[1].Above[word];
  owned.Edges[2] = rows[0].Above[word] ^ rows[2].Above[word];
  if (IsSpecial)
  {
    // An edge point lies strictly between the ends, which must be finite.
    const std::uint64_t ends =
      LoadWordPair(rows[0].Ties + word) | LoadWordPair(rows[0].NonFinite + word);
    const auto end = static_cast<Word>(ends);
    owned.Points = rows[0].Ties[word];
    owned.Edges[0] &= static_cast<Word>(~(ends | (ends >> 1)));
    owned.Edges[1] &= ~(end | rows[1].Ties[word] | rows[1].NonFinite[word]);
    owned.Edges[2] &= ~(end | rows[2].Ties[word] | rows[2].NonFinite[word]);
  }
  return owned;
}

/// Counts the points that FindOwnedPoints() finds in all words of a row.
vtkIdType CountOwnedPoints(const BitRows::Row* rows, vtkIdType number, bool isSpecial);

/// Counts the cells between four rows of \a number points that have a corner with a NaN or infinite
/// value.
vtkIdType CountNonFinite(const BitRows::Row* rows, vtkIdType number);

/**
 * Finds the cells between four rows that have corners on both sides of the isovalue. The rows are
 * (j, k), (j + 1, k), (j, k + 1) and (j + 1, k + 1). Writes the columns of the cells, in increasing
 * order, and their case keys. Returns the number of cells.
 */
vtkIdType FindCells(
  const BitRows::Row* rows, vtkIdType number, std::uint32_t* columns, std::uint8_t* keys);
}

}

#endif
