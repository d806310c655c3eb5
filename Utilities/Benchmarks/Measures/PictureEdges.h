// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureEdges_h
#define PictureEdges_h

#include "Support/Pictures/RgbaPicture.h"

/**
 * How far edges of a picture are from their places, in pixels along its rows.
 */
struct EdgeDistances
{
  int Edges = 0;
  double Mean = 0.0;
  double Largest = 0.0;
};

/**
 * Edges are steps of the red of \a expected, by at least a quarter of its largest one, between
 * pixels that \a reach pixels to both sides differ by less than a tenth of the step. What \a found
 * has more or less of red within that reach, over the step, is the distance; a picture of pixels'
 * centres is half a pixel off by itself.
 */
EdgeDistances MeasureEdges(
  const reference::RgbaPicture& found, const reference::RgbaPicture& expected, int reach);

/**
 * The difference of red in which 95 % of those pixels lie that the eight around, in \a expected,
 * differ from by less than \a flat.
 */
double MeasureFlat(
  const reference::RgbaPicture& found, const reference::RgbaPicture& expected, double flat);

#endif
