// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BitRows_h
#define interlume_BitRows_h

#include "Output/ExtractionBuffer.h"

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   BitRows
 * @brief   classification of the points of a structured grid against one isovalue, as bits
 *
 * Each row starts at a word boundary and ends with a word of zeros, so that a word and its
 * successor can be read together.
 */
class BitRows
{
public:
  using Word = std::uint32_t;
  static constexpr int BitsOfWord = 32;

  /// Bits of one row.
  struct Row
  {
    /// Set if the value is not below the isovalue, or is not finite.
    Word* Above;
    /// Set if the value equals the isovalue.
    Word* Ties;
    /// Set if the value is NaN or infinite.
    Word* NonFinite;
  };

  /// Records whether any Ties or NonFinite bits are set in one or more rows.
  struct Kinds
  {
    bool Ties = false;
    bool NonFinite = false;

    bool IsAny() const { return this->Ties || this->NonFinite; }
    void Add(const Kinds& other)
    {
      this->Ties |= other.Ties;
      this->NonFinite |= other.NonFinite;
    }
  };

  static vtkIdType GetNumberOfWords(vtkIdType points)
  {
    return (points + BitsOfWord - 1) / BitsOfWord;
  }

  /// Allocates \a rows rows of \a points points. Ties and NonFinite bits are 0 and use no memory
  /// until they are set.
  void Allocate(vtkIdType rows, vtkIdType points)
  {
    this->Stride = GetNumberOfWords(points) + 1;
    const auto words = static_cast<std::size_t>(rows * this->Stride);
    this->Above.Allocate(words);
    this->Ties.AllocateZeros(words);
    this->NonFinite.AllocateZeros(words);
    this->KindsOfRows.assign(rows, Kinds());
  }

  Row GetRow(vtkIdType row)
  {
    const vtkIdType first = row * this->Stride;
    return { this->Above.GetData() + first, this->Ties.GetData() + first,
      this->NonFinite.GetData() + first };
  }
  Kinds& GetKinds(vtkIdType row) { return this->KindsOfRows[row]; }

  std::size_t GetBytes() const
  {
    std::size_t bytes = this->Above.GetBytes() + this->KindsOfRows.size() * sizeof(Kinds);
    for (const Kinds& kinds : this->KindsOfRows)
    {
      bytes += this->Stride * sizeof(Word) * ((kinds.Ties ? 1 : 0) + (kinds.NonFinite ? 1 : 0));
    }
    return bytes;
  }

private:
  vtkIdType Stride = 0;
  ExtractionBuffer<Word> Above;
  ExtractionBuffer<Word> Ties;
  ExtractionBuffer<Word> NonFinite;
  std::vector<Kinds> KindsOfRows;
};

}

#endif
