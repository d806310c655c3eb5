// SPDX-License-Identifier: BSD-3-Clause
#ifndef PixelDifference_h
#define PixelDifference_h

#include <iosfwd>
#include <string>

class vtkImageData;

namespace interlume
{
/**
 * Difference of two images with 8-bit channels. Each pixel is compared with the pixel at the same
 * position, without averaging or threshold. Channel differences are in units of 1/255.
 */
struct PixelDifference
{
  /// Whether both images have the same width, height and number of channels. If not, no other
  /// member is set.
  bool SameShape = false;
  /// Largest difference of a channel, 0 to 255.
  int Max = 0;
  /// Mean difference over every channel of every pixel.
  double Mean = 0.0;
  /// Fraction of pixels, 0 to 1, with a channel that differs by more than PixelBounds::Step.
  double FractionAboveStep = 0.0;
};

/**
 * Tolerances for the comparison with a regression image. They allow for different rounding by
 * another rasterizer along a few silhouettes, but not for visible differences.
 */
struct PixelBounds
{
  /// Largest mean difference.
  double Mean = 0.5;
  /// A pixel counts as changed if any channel differs by more than this value.
  int Step = 8;
  /// Largest allowed fraction of changed pixels.
  double FractionAboveStep = 0.002;
};

/**
 * Compares two images of unsigned char scalars with 1 to 4 channels.
 */
PixelDifference ComparePixels(vtkImageData* image, vtkImageData* baseline, int step);

bool IsWithin(const PixelDifference& difference, const PixelBounds& bounds);

std::ostream& operator<<(std::ostream& os, const PixelDifference& difference);
}

#endif
