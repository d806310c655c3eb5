// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FragmentBlending_h
#define interlume_FragmentBlending_h

#include "Frame/TetrahedraFrame.h"
#include "Software/Fragments.h"

#include <array>

namespace interlume
{

class SurfaceFragments;

/**
 * @class   FragmentBlending
 * @brief   blends integrated segments into the pixels of a tile
 */
class FragmentBlending
{
public:
  using Pixel = std::array<float, 4>;

  ///@{
  /**
   * Composite segments behind the colors already in their pixels. A pixel contains RGB
   * premultiplied by opacity, and opacity. CompositeWithSurface also composites boundary triangles
   * in front of and behind each segment.
   */
  static void Composite(const Fragments& fragments, const TetrahedraFrame& frame, Pixel* pixels);
  static void CompositeWithSurface(const Fragments& fragments, const TetrahedraFrame& frame,
    const SurfaceFragments& surface, Pixel* pixels);
  ///@}

  /**
   * Adds each segment's weighted color, and its opacity or optical depth, to its pixel.
   */
  static void Sum(const Fragments& fragments, const TetrahedraFrame& frame, Pixel* pixels);

  /// Composites a color, premultiplied by opacity, behind a pixel.
  static void CompositeBehind(Pixel& pixel, const Pixel& color)
  {
    const float transmittance = 1.0f - pixel[3];
    for (int c = 0; c < 4; ++c)
    {
      pixel[c] += transmittance * color[c];
    }
  }

  ///@{
  /**
   * Update the maximum scalar in channel 0 of each pixel, or the maxima of the four channels: RGB
   * premultiplied by opacity, and opacity. Opacity is extinction times \a unit, clamped to 1.
   */
  static void UpdateMaximumScalar(const Fragments& fragments, Pixel* pixels);
  static void UpdateMaximumColor(
    const Fragments& fragments, const TetrahedraFields& fields, float unit, Pixel* pixels);
  ///@}

  /**
   * Converts a sum of colors weighted by optical depth to RGB premultiplied by opacity, and
   * opacity.
   */
  static Pixel Resolve(const Pixel& sum);

  /**
   * Converts the sum or maximum in a pixel to RGB premultiplied by opacity, and opacity, according
   * to the blend mode of \a frame. With PRIORITY, layers must already be converted by Resolve().
   */
  static Pixel Finish(const Pixel& sum, const TetrahedraFrame& frame);

  /**
   * Calls visit(pixel, i, run) for each segment with positive length.
   */
  template <typename Visit>
  static void ForEachSegment(const Fragments& f, const Visit& visit)
  {
    for (int run = 0; run < f.NumberOfRuns; ++run)
    {
      const Fragments::Run& r = f.Runs[run];
      for (int i = r.Begin; i < r.End; ++i)
      {
        if (f.Length[i] > 0.0f)
        {
          visit(r.Pixel + i - r.Begin, i, r);
        }
      }
    }
  }
};

}

#endif
