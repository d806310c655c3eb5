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
 * The inner loops over rows of bits.
 */
namespace BitKernels
{
using Word = BitRows::Word;

/// Makes bits of as many bytes, each 0 or 1, as a word has bits.
inline Word Pack(const std::uint8_t* bytes)
{
  // Byte i of eight becomes bit i of the product's last byte; no two terms of it fall on one bit.
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

/// Returns whether \a test is true for any of \a number values. The results are gathered in bytes,
/// of which compilers make vector code whatever the type of values.
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

/// Sets the bits of \a number values for which \a test is true, and a word of zeros behind.
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

/// Returns the place of the lowest bit that is set; there is one.
inline int FindLowest(Word word)
{
#if defined(__GNUC__)
  return __builtin_ctz(word);
#elif defined(_MSC_VER)
  unsigned long place;
  _BitScanForward(&place, word);
  return static_cast<int>(place);
#else
  int place = 0;
  while (!((word >> place) & 1))
  {
    ++place;
  }
  return place;
#endif
}

/// Calls \a visit(i) for the bits that are set, from the lowest on.
template <typename Visitor>
void ForEach(Word word, Visitor&& visit)
{
  for (; word != 0; word &= word - 1)
  {
    visit(FindLowest(word));
  }
}

/// Returns a word and, above it, the next.
inline std::uint64_t GetWithNext(const Word* word)
{
  return word[0] | (static_cast<std::uint64_t>(word[1]) << BitRows::BitsOfWord);
}

/// Returns the bits of a word, at \a first of a row, that are of its first \a number points.
inline Word GetValid(vtkIdType first, vtkIdType number)
{
  const vtkIdType left = number - first;
  return left >= BitRows::BitsOfWord ? ~Word(0) : left > 0 ? (Word(1) << left) - 1 : Word(0);
}

/// The output points that the grid points of a word own: the grid points themselves, and what their
/// edges along i, j and k have.
struct Owned
{
  Word Points;
  Word Edges[3];
};

/**
 * Finds them in word \a word of a row of \a number points, of which \a rows has the bits, and those
 * of its neighbours along j and k; where there is none, its own. \a IsSpecial tells whether any
 * bits but Above may be set.
 */
template <bool IsSpecial>
inline Owned FindOwned(const BitRows::Row* rows, vtkIdType word, vtkIdType number)
{
  const std::uint64_t above = GetWithNext(rows[0].Above + word);
  Owned owned;
  owned.Points = 0;
  owned.Edges[0] =
    static_cast<Word>(above ^ (above >> 1)) & GetValid(word * BitRows::BitsOfWord, number - 1);
  owned.Edges[1] = rows[0].Above[word] ^ rows[1].Above[word];
  owned.Edges[2] = rows[0].Above[word] ^ rows[2].Above[word];
  if (IsSpecial)
  {
    // An edge is crossed between its ends, which are numbers.
    const std::uint64_t ends =
      GetWithNext(rows[0].Ties + word) | GetWithNext(rows[0].NonFinite + word);
    const auto end = static_cast<Word>(ends);
    owned.Points = rows[0].Ties[word];
    owned.Edges[0] &= static_cast<Word>(~(ends | (ends >> 1)));
    owned.Edges[1] &= ~(end | rows[1].Ties[word] | rows[1].NonFinite[word]);
    owned.Edges[2] &= ~(end | rows[2].Ties[word] | rows[2].NonFinite[word]);
  }
  return owned;
}

/// Counts what FindOwned finds in a row.
vtkIdType CountOwned(const BitRows::Row* rows, vtkIdType number, bool isSpecial);

/// Counts the cells between four rows of \a number points, in the order j, then k, of which a
/// corner is not finite.
vtkIdType CountNonFinite(const BitRows::Row* rows, vtkIdType number);

/**
 * Finds the cells between four rows that have corners on both sides: writes their columns,
 * increasing, and the keys of their cases, and returns how many there are.
 */
vtkIdType FindCells(
  const BitRows::Row* rows, vtkIdType number, std::uint32_t* columns, std::uint8_t* keys);
}

}

#endif
