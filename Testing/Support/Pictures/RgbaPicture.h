// SPDX-License-Identifier: BSD-3-Clause
#ifndef RgbaPicture_h
#define RgbaPicture_h

#include <iosfwd>
#include <vector>

namespace reference
{

/**
 * A picture in floating point: red, green, blue, each times alpha, and alpha, pixel after pixel,
 * rows from the bottom to the top.
 */
struct RgbaPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<double> Values;

  RgbaPicture() = default;
  /// Black and transparent.
  RgbaPicture(int width, int height);

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
 * How far two pictures of one size are apart, over every channel of every pixel.
 */
struct PictureError
{
  /// The largest difference; infinite where a channel is no number or the sizes differ.
  double Max = 0.0;
  double Mean = 0.0;
  /// Share of the pixels, 0 to 1, with a channel more than 1e-3 apart.
  double ShareAbove = 0.0;
  /// Where the largest difference is: pixel and channel.
  int I = 0;
  int J = 0;
  int Channel = 0;
};

PictureError ComparePictures(const RgbaPicture& found, const RgbaPicture& expected);

/// The numbers above in one line.
std::ostream& operator<<(std::ostream& os, const PictureError& error);

/// The largest alpha of a picture.
double LargestAlpha(const RgbaPicture& picture);

}

#endif
