// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceFragments_h
#define interlume_SurfaceFragments_h

#include "Frame/TetrahedraFrame.h"
#include "Software/Fragments.h"
#include "Software/TileBins.h"
#include "View/TetrahedronSilhouette.h"

#include <array>
#include <vector>

namespace interlume
{

/**
 * @class   SurfaceFragments
 * @brief   boundary triangles where segments pass them
 *
 * A segment enters its tetrahedron through one face and leaves it through another. Where such a
 * face is a boundary triangle, its shaded colour is laid before or behind the segment.
 */
class SurfaceFragments
{
public:
  explicit SurfaceFragments(const TetrahedraFrame& frame, const TileBins& bins)
    : Frame(frame)
    , Bins(bins)
  {
  }

  /**
   * Computes colours, times opacity, at both ends of all segments; opacity 0 where there is no
   * triangle. \a left and \a bottom are the place of the tile; \a opaque is the depth of each of
   * its pixels, or null.
   */
  void Compute(const Fragments& fragments, int left, int bottom, const float* opaque);

  const Fragments::Color& GetFront(int i) const { return this->Colors[0][i]; }
  const Fragments::Color& GetBack(int i) const { return this->Colors[1][i]; }

private:
  using Value = TetrahedronSilhouette::Value;
  /// The number of channels: depth, three of the normal, two texture coordinates.
  static constexpr int CHANNELS = 6;

  void SetTetrahedron(std::uint32_t tetrahedron);
  /// Finds the edge next to which a pixel lies; returns lambda there.
  double Locate(double x, double y, int& edge) const;

  const TetrahedraFrame& Frame;
  const TileBins& Bins;
  std::uint32_t Tetrahedron = 0xffffffffu;
  TetrahedronSilhouette Shape;
  std::array<Value, CHANNELS> Values;
  std::array<Fragments::Color, Fragments::CAPACITY> Colors[2];
};

}

#endif
