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
 * @brief   puts integrated segments into the pixels of a tile, one after the other
 */
class FragmentBlending
{
public:
  using Pixel = std::array<float, 4>;

  ///@{
  /**
   * Lay segments behind what is there: colour times opacity, and opacity. The second function lays
   * boundary triangles before and behind each segment.
   */
  static void Composite(const Fragments& fragments, const TetrahedraFrame& frame, Pixel* pixels);
  static void CompositeWithSurface(const Fragments& fragments, const TetrahedraFrame& frame,
    const SurfaceFragments& surface, Pixel* pixels);
  ///@}

  /**
   * Adds up weighted colour, and opacity or optical depth.
   */
  static void Sum(const Fragments& fragments, const TetrahedraFrame& frame, Pixel* pixels);

  /// Lays a color, multiplied by its opacity, behind a pixel.
  static void LayBehind(Pixel& pixel, const Pixel& color)
  {
    const float through = 1.0f - pixel[3];
    for (int c = 0; c < 4; ++c)
    {
      pixel[c] += through * color[c];
    }
  }

  ///@{
  /**
   * Keep the largest scalar, as the first of a pixel, or each channel's largest colour times
   * opacity, opacity being extinction times \a unit and at most 1.
   */
  static void LargestScalar(const Fragments& fragments, Pixel* pixels);
  static void LargestColor(
    const Fragments& fragments, const TetrahedraFields& fields, float unit, Pixel* pixels);
  ///@}

  /**
   * Returns colour times opacity of what was summed up as optical depth.
   */
  static Pixel Resolve(const Pixel& sum);

  /**
   * Returns colour times opacity of what the blend mode of \a frame has put into a pixel; layers
   * are resolved one by one before.
   */
  static Pixel Finish(const Pixel& sum, const TetrahedraFrame& frame);

  /**
   * Calls visit(pixel, i, run) for every segment that has a length.
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
