// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StripePyramid_h
#define interlume_StripePyramid_h

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   StripePyramid
 * @brief   mipmap levels of a one-dimensional stripe texture, not averaged from finer levels
 *
 * Level k has NumberOfLines / 2^k periods of TexelsPerLine texels; the last level has one period.
 * One line of each level is centered at Offset, so each line of a level lies over a line of the
 * next finer level. A texel blends the two colors by the fraction that the line covers.
 */
class StripePyramid
{
public:
  using Color = std::array<double, 4>;

  /// Number of lines; must be a power of two.
  int NumberOfLines = 256;
  int TexelsPerLine = 16;
  /// Width of a line as a fraction of the period.
  double LineWidth = 0.25;
  /// Texture coordinate of one line.
  double Offset = 0.0;
  /// Colors as red, green, blue and opacity, 0 to 1.
  Color Line{ { 0.0, 0.0, 0.0, 1.0 } };
  Color Background{ { 1.0, 1.0, 1.0, 1.0 } };

  int GetNumberOfLevels() const;
  /// Returns the length of a level in texels.
  int GetLength(int level) const { return (this->NumberOfLines >> level) * this->TexelsPerLine; }
  /// Returns the RGBA texels of a level.
  std::vector<unsigned char> GetTexels(int level) const;

private:
  /// Returns the length of the parts of lines between 0 and \a position, in periods.
  double GetCoveredLength(double position) const;
};

}

#endif
