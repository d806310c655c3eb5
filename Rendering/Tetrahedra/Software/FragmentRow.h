// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FragmentRow_h
#define interlume_FragmentRow_h

#include "Software/Fragments.h"

namespace interlume
{

/**
 * @class   FragmentRow
 * @brief   the segments of a tetrahedron in a row of pixels
 *
 * See TetrahedronSilhouette: a value on the base side is affine, except for a bend at the crease.
 * The value on the other side is this value plus lambda (the minimum of the edge functions) times
 * the difference between both sides at the thick point.
 */
struct FragmentRow
{
  /// Number of channels: depth, scalar, extent in time, and four color components.
  static constexpr int CHANNELS = 7;

  float Thickness;
  /// For each pixel, the length of a view ray segment per unit of depth in parallel projection, or
  /// per unit along the view axis in perspective. Fragments::GROUP elements past the end of the row
  /// must be readable.
  const float* Slants;
  /// Values at the first pixel of the row, and their slopes per pixel.
  float EdgeValues[4];
  float EdgeSlopes[4];
  float Crease;
  float CreaseSlope;
  float Values[CHANNELS];
  float Slopes[CHANNELS];
  float Bends[CHANNELS];
  float Differences[CHANNELS];
  /// Output arrays of the channels, for the base side and for the other side.
  float* Base[CHANNELS];
  float* Other[CHANNELS];

  /**
   * Appends the lengths and the first \a channels channels of \a size segments to \a fragments. The
   * caller updates Size and Runs.
   */
  void Write(Fragments& fragments, int channels, int size) const;

  /**
   * Writes four color channels, starting with \a channel. Call it after Write(), because it uses
   * the lengths. \a base is the end (0 front, 1 back) on the base side.
   */
  void WriteColors(Fragments& fragments, int channel, int base, int size) const;
};

}

#endif
