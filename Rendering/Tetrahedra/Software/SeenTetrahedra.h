// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SeenTetrahedra_h
#define interlume_SeenTetrahedra_h

#include "Frame/TetrahedraFrame.h"
#include "Software/Fragments.h"

#include <cstdint>
#include <vector>

namespace interlume
{

class SurfaceFragments;

/**
 * @class   SeenTetrahedra
 * @brief   finds the tetrahedron that is seen at each pixel of a tile, for selection
 *
 * From the camera to the tetrahedron seen, the opacity along the view ray grows to half of the
 * pixel's opacity. Half of what the pixel shows is therefore in front of this position, and half
 * behind it. Boundary triangles add their opacity to the tetrahedron that contains them. Segments
 * that overlap are ordered by their closer end, and layers by priority. For maximum intensity, the
 * tetrahedron with the largest value is seen. No tetrahedron is seen at a pixel without opacity.
 */
class SeenTetrahedra
{
public:
  /// A tetrahedron seen at a pixel.
  struct Seen
  {
    /// 1 plus the index of the tetrahedron, or 0 if there is none.
    std::uint32_t Tetrahedron = 0;
    /// Depth of the closer end of the tetrahedron's segment (see TetrahedraView).
    float Depth = 0.0f;
  };

  SeenTetrahedra(const TetrahedraFrame& frame, int pixels);

  void Clear();
  /// Adds integrated segments, with their optical depth in Total. \a surface may be null.
  void Add(const Fragments& fragments, const SurfaceFragments* surface);
  /// Adds segments for maximum intensity, given scalars or extinctions at both ends.
  void AddMaximum(const Fragments& fragments, const Fragments::Values* values);
  /// Starts a layer behind all segments that were added.
  void BeginLayer() { ++this->Layer; }
  /// Finds the tetrahedra seen in the segments that were added.
  void Find();

  const Seen& Get(int pixel) const { return this->Pixels[pixel]; }

private:
  struct Segment
  {
    std::uint32_t Layer;
    std::uint32_t Tetrahedron;
    float Depth;
    float OpticalDepth;

    bool operator<(const Segment& other) const;
  };

  /// Returns true if the opacity at a largest value is positive.
  bool IsVisible(float maximum) const;
  /// Reorders segments, and returns the segment that is seen.
  static const Segment& FindMedian(Segment* begin, Segment* end);

  const TetrahedraFrame& Frame;
  std::uint32_t Layer = 0;
  std::vector<Segment> Segments;
  /// Pixel of each segment.
  std::vector<std::uint16_t> PixelOfSegment;
  /// The segments, sorted by pixel.
  std::vector<Segment> Sorted;
  std::vector<Seen> Pixels;
  /// Largest value at each pixel, for maximum intensity.
  std::vector<float> Maxima;
};

}

#endif
