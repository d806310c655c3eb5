// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FragmentRow_h
#define interlume_FragmentRow_h

#include "Software/Fragments.h"

namespace interlume
{

/**
 * @class   FragmentRow
 * @brief   segments of one tetrahedron in one row of pixels
 *
 * See TetrahedronSilhouette: each value is affine on the base side but for a bend at the crease,
 * and lambda, the least of the shares, takes it to the other side.
 */
struct FragmentRow
{
  /// The number of channels: depth, scalar, extent in time, four of a colour.
  static constexpr int CHANNELS = 7;

  float Thickness;
  /// The slants: for each pixel the length of a line of sight for 1 of difference of depth in
  /// parallel, and for 1 along the axis in perspective; GROUP more may be read.
  const float* Slants;
  /// The values at the first pixel, and their change from pixel to pixel.
  float Shares[4];
  float ShareSlopes[4];
  float Crease;
  float CreaseSlope;
  float Values[CHANNELS];
  float Slopes[CHANNELS];
  float Bends[CHANNELS];
  float Differences[CHANNELS];
  /// The arrays that the channels are written to.
  float* Base[CHANNELS];
  float* Other[CHANNELS];

  /**
   * Writes lengths and the first \a channels of \a size segments after the last; the caller counts
   * them.
   */
  void Write(Fragments& fragments, int channels, int size) const;

  /**
   * Writes four channels of colours in the same way, from \a channel on.
   */
  void WriteColors(Fragments& fragments, int channel, int base, int size) const;
};

}

#endif
