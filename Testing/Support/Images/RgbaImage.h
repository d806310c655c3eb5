// SPDX-License-Identifier: BSD-3-Clause
#ifndef RgbaImage_h
#define RgbaImage_h

#include <iosfwd>
#include <vector>

namespace reference
{

/**
 * A floating-point image: premultiplied red, green and blue, and alpha, with rows from the bottom
 * to the top.
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
 * Difference of two images over every channel of every pixel.
 */
struct ImageError
{
  /// Largest difference, or infinity if a channel is NaN or the sizes differ.
  double Max = 0.0;
  double Mean = 0.0;
  /// Fraction of the pixels, 0 to 1, with a channel that differs by more than 1e-3.
  double FractionAbove = 0.0;
  /// Pixel and channel of the largest difference.
  int I = 0;
  int J = 0;
  int Channel = 0;
};

ImageError CompareImages(const RgbaImage& found, const RgbaImage& expected);

/// Prints the difference in one line.
std::ostream& operator<<(std::ostream& os, const ImageError& error);

/// Returns the largest alpha of an image.
double LargestAlpha(const RgbaImage& image);

}

#endif
