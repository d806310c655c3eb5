// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StripePyramid_h
#define interlume_StripePyramid_h

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   StripePyramid
 * @brief   levels of a one-dimensional texture of stripes, none the mean of another
 *
 * Level k holds NumberOfLines / 2^k periods of TexelsPerLine texels; the last one holds one. Lines
 * are centred at the ends of periods, so that each line of a level lies over one of the level
 * below. A texel is a mixture of the two colours by the share of it that the line covers.
 */
class StripePyramid
{
public:
  using Color = std::array<double, 4>;

  /// The number of lines, a power of two; others are an error of the caller.
  int NumberOfLines = 256;
  int TexelsPerLine = 16;
  /// The width of a line as a share of the period.
  double LineWidth = 0.25;
  /// The colours as red, green, blue, opacity, 0 to 1.
  Color Line{ { 0.0, 0.0, 0.0, 1.0 } };
  Color Background{ { 1.0, 1.0, 1.0, 1.0 } };

  int GetNumberOfLevels() const;
  /// Returns the length of a level in texels.
  int GetLength(int level) const { return (this->NumberOfLines >> level) * this->TexelsPerLine; }
  /// Returns the texels of a level, four bytes each.
  std::vector<unsigned char> GetTexels(int level) const;

private:
  double GetCoverage(int texel) const;
};

}

#endif
