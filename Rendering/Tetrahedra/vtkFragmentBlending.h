#ifndef vtkFragmentBlending_h
#define vtkFragmentBlending_h

#include "vtkFragments.h"
#include "vtkTetrahedraPicture.h"

#include <array>

class vtkSurfaceFragments;

/**
 * @class   vtkFragmentBlending
 * @brief   puts integrated segments into the pixels of a tile, one after the other
 */
class vtkFragmentBlending
{
public:
  using Pixel = std::array<float, 4>;

  ///@{
  /**
   * Behind what is there: colour times opacity, and opacity. The second lays boundary triangles
   * before and behind each segment.
   */
  static void Composite(
    const vtkFragments& fragments, const vtkTetrahedraPicture& picture, Pixel* pixels);
  static void CompositeWithSurface(const vtkFragments& fragments,
    const vtkTetrahedraPicture& picture, const vtkSurfaceFragments& surface, Pixel* pixels);
  ///@}

  /**
   * Sums of weighted colour, and of opacity or optical depth.
   */
  static void Sum(
    const vtkFragments& fragments, const vtkTetrahedraPicture& picture, Pixel* pixels);

  ///@{
  /**
   * The largest scalar, as the first of a pixel, or each channel's largest colour times opacity,
   * opacity being extinction times \a unit and at most 1.
   */
  static void LargestScalar(const vtkFragments& fragments, Pixel* pixels);
  static void LargestColor(
    const vtkFragments& fragments, const vtkTetrahedraFields& fields, float unit, Pixel* pixels);
  ///@}

  /**
   * Colour times opacity of what was summed up as optical depth.
   */
  static Pixel Resolve(const Pixel& sum);

  /**
   * Calls visit(pixel, i, run) for every segment that has a length.
   */
  template <typename Visit>
  static void ForEachSegment(const vtkFragments& f, const Visit& visit)
  {
    for (int run = 0; run < f.NumberOfRuns; ++run)
    {
      const vtkFragments::Run& r = f.Runs[run];
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

#endif
