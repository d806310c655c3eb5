// SPDX-License-Identifier: BSD-3-Clause
#ifndef PixelDifference_h
#define PixelDifference_h

#include <iosfwd>
#include <string>

class vtkImageData;

namespace interlume
{
/**
 * How far two pictures of 8-bit channels are apart, channel by channel and pixel by pixel: no
 * shift, no averaging, no threshold. Channel differences are in steps of 1/255.
 */
struct PixelDifference
{
  /// Whether both have the same width, height and number of channels; nothing else is set if not.
  bool SameShape = false;
  /// Largest difference of a channel, 0 to 255.
  int Max = 0;
  /// Mean difference over every channel of every pixel.
  double Mean = 0.0;
  /// Share of pixels, 0 to 1, with a channel that differs by more than PixelBounds::Step.
  double ShareAboveStep = 0.0;
};

/**
 * The bounds of a regression picture. They let through what another rasteriser rounds otherwise at
 * a few silhouettes, and nothing that an eye could find.
 */
struct PixelBounds
{
  /// Largest mean difference.
  double Mean = 0.5;
  /// Difference of a channel that counts as a changed pixel.
  int Step = 8;
  /// Largest share of changed pixels.
  double ShareAboveStep = 0.002;
};

/**
 * Compares two pictures of unsigned char scalars with 1 to 4 channels.
 */
PixelDifference ComparePixels(vtkImageData* picture, vtkImageData* baseline, int step);

/**
 * Whether \a difference is within \a bounds.
 */
bool IsWithin(const PixelDifference& difference, const PixelBounds& bounds);

std::ostream& operator<<(std::ostream& os, const PixelDifference& difference);
}

#endif
