// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SegmentTable_h
#define interlume_SegmentTable_h

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace interlume
{

/**
 * @class   SegmentTable
 * @brief   table of the weight of a segment's front color
 *
 * Along a segment with optical depth D, color and extinction are linear. The relative change of
 * extinction is delta = (back - front) / (back + front). The segment's color, seen from the front,
 * is alpha (m front + (1 - m) back), with alpha = 1 - exp(-D) and
 *
 *   m = (1 - Psi) / alpha,  Psi = integral over 0..1 of exp(-D ((1 - delta) s + delta s^2)) ds
 *
 * (K. Moreland, E. Angel, "A fast high accuracy volume renderer for unstructured data", 2004). m is
 * smooth and between 1/3 and 1. The error of bilinear lookups is at most 2e-4 for D below 1e7.
 */
class SegmentTable
{
public:
  /// The size of the table. Columns sample 1 + D with eight linear steps per octave, so the column
  /// follows from the bits of 1 + D as a float. Rows sample 1 - sqrt((1 - delta) / 2) uniformly,
  /// which gives finer steps of delta where the front end is transparent.
  static constexpr int STEPS_LOG2 = 3;
  static constexpr int COLUMNS = (24 << STEPS_LOG2) + 1;
  static constexpr int ROWS = 65;

  /// Returns the table, which is built on first use.
  static const SegmentTable& Get();

  /// Returns m for \a depth >= 0 and \a delta in [-1, 1].
  float GetFrontWeight(float depth, float delta) const
  {
    const float sum = 1.0f + depth;
    std::int32_t bits;
    std::memcpy(&bits, &sum, sizeof(bits));
    const float u = std::min(static_cast<float>(bits - ONE) * BITS_TO_COLUMN, COLUMNS - 1.001f);
    const float v = (1.0f - std::sqrt(std::max(0.5f - 0.5f * delta, 0.0f))) * (ROWS - 1.001f);
    const int column = static_cast<int>(u);
    const int row = static_cast<int>(v);
    const float a = u - static_cast<float>(column);
    const float b = v - static_cast<float>(row);
    const float* low = &this->Values[row * COLUMNS + column];
    const float* high = low + COLUMNS;
    const float first = low[0] + a * (low[1] - low[0]);
    const float second = high[0] + a * (high[1] - high[0]);
    return first + b * (second - first);
  }

private:
  SegmentTable();

  static constexpr std::int32_t ONE = 0x3f800000;
  static constexpr float BITS_TO_COLUMN = 1.0f / (1 << (23 - STEPS_LOG2));

  std::vector<float> Values;
};

}

#endif
