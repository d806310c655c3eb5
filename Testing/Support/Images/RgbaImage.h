// SPDX-License-Identifier: BSD-3-Clause
#ifndef RgbaImage_h
#define RgbaImage_h

#include <iosfwd>
#include <vector>

namespace reference
{

/**
 * A floating-point image with premultiplied red, green and blue, and alpha. The bottom row is
 * first.
 */
struct RgbaImage
{
  int Width = 0;
  int Height = 0;
  std::vector<double> Values;

  RgbaImage() = default;
  /// Creates a transparent black image.
  RgbaImage(int width, int height);

  double* At(int i, int j) { return &this->Values[4 * this->Index(i, j)]; }
  const double* At(int i, int j) const { return &this->Values[4 * this->Index(i, j)]; }

private:
  std::size_t Index(int i, int j) const
  {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(this->Width) +
      static_cast<std::size_t>(i);
  }
};

/**
 * Difference between two images over all channels of all pixels.
 */
struct ImageError
{
  /// Largest difference, or infinity if a channel is NaN or the sizes differ.
  double Max = 0.0;
  double Mean = 0.0;
  /// Fraction (0 to 1) of pixels with a channel that differs by more than 1e-3.
  double FractionAbove = 0.0;
  /// Pixel coordinates and channel of the largest difference.
  int I = 0;
  int J = 0;
  int Channel = 0;
};

ImageError CompareImages(const RgbaImage& found, const RgbaImage& expected);

/// Prints the difference in one line.
std::ostream& operator<<(std::ostream& os, const ImageError& error);

double LargestAlpha(const RgbaImage& image);

}

#endif
