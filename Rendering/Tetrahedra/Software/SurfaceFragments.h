// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceFragments_h
#define interlume_SurfaceFragments_h

#include "Frame/BoundaryShading.h"
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
 * @brief   shaded boundary triangles at the ends of segments
 *
 * A segment enters its tetrahedron through one face and exits through another. If such a face is a
 * boundary triangle, its shaded color is composited in front of or behind the segment.
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
   * Computes colors, premultiplied by opacity, at both ends of all segments, with opacity 0 where
   * there is no triangle. \a left and \a bottom are the tile's position in pixels. \a opaque is the
   * depth of the opaque surface at each pixel, or null.
   */
  void Compute(const Fragments& fragments, int left, int bottom, const float* opaque);

  const Fragments::Color& GetFront(int i) const { return this->Colors[0][i]; }
  const Fragments::Color& GetBack(int i) const { return this->Colors[1][i]; }

private:
  using Value = TetrahedronSilhouette::Value;
  /// Number of channels: depth, three normal components, two texture coordinates.
  static constexpr int CHANNELS = 6;

  void SetTetrahedron(std::uint32_t tetrahedron);
  /// Finds the edge whose function is smallest at a pixel, and returns the value of this function:
  /// lambda (see TetrahedronSilhouette), clamped to [0, 1].
  double Locate(double x, double y, int& edge) const;

  /// Returns the texture coordinates of a face at the offset (dx, dy) from the thick point. \a at
  /// are the channels there. The face is the base if \a edge is negative.
  BoundaryShading::TexturePosition GetTexturePosition(
    const std::array<double, CHANNELS>& at, double dx, double dy, int edge) const;

  const TetrahedraFrame& Frame;
  const TileBins& Bins;
  std::uint32_t Tetrahedron = 0xffffffffu;
  TetrahedronSilhouette Shape;
  std::array<Value, CHANNELS> Values;
  std::array<Fragments::Color, Fragments::CAPACITY> Colors[2];
};

}

#endif
