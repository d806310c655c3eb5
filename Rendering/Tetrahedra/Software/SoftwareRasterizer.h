// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SoftwareRasterizer_h
#define interlume_SoftwareRasterizer_h

#include "Frame/TetrahedraFrame.h"
#include "Software/SeenTetrahedra.h"
#include "Software/TileBins.h"

#include <functional>
#include <optional>
#include <vector>

namespace interlume
{

/**
 * @class   SoftwareRasterizer
 * @brief   draws tetrahedra on the CPU
 *
 * The image is divided into tiles. Each tile is drawn by one thread, from front to back:
 * silhouettes are rasterized into view ray segments (Fragments), which are integrated with SIMD
 * instructions and then blended sequentially. The result does not depend on the number of threads.
 *
 * If only the depths of opaque surfaces changed since the last image, only the tiles with changes
 * are drawn, for example while cells below the mouse pointer are highlighted.
 */
class SoftwareRasterizer
{
public:
  using AbortCheck = std::function<bool(double fraction)>;

  /// Draws an image. Returns false if \a isAborted returned true. It is called between stages and
  /// between groups of tiles, in the calling thread, with the completed fraction of the image.
  bool Draw(const TetrahedraFrame& frame, const AbortCheck& isAborted = nullptr);

  /// Returns RGBA values, row by row from the bottom: premultiplied by opacity, or sums or maxima
  /// if TetrahedraFrame::IsSum is true. Not for IsSelection.
  const std::vector<float>& GetColors() const { return this->Colors; }
  /// Returns the tetrahedron seen at each pixel, for IsSelection, and releases the memory.
  std::vector<SeenTetrahedra::Seen> ReleaseSeen() { return std::move(this->Seen); }

  /// Returns true if the last image used no part of the image before it.
  bool WasComplete() const { return this->Complete; }
  vtkIdType GetNumberOfDrawnTetrahedra() const { return this->Bins.GetNumberOfDrawnTetrahedra(); }
  std::size_t GetBytes() const;

private:
  /// Fills Bins for the frame, if necessary. Returns false if aborted.
  bool UpdateBins(const TetrahedraFrame& frame, const AbortCheck& isAborted);
  /// Returns the tiles to draw.
  std::vector<int> FindTiles(const TetrahedraFrame& frame) const;
  /// Returns true if the depths of opaque surfaces in a tile are not those of Colors.
  bool HasChanged(const TetrahedraFrame& frame, int tile) const;
  bool DrawTiles(
    const TetrahedraFrame& frame, const std::vector<int>& tiles, const AbortCheck& isAborted);
  void DrawGroup(const TetrahedraFrame& frame, const int* begin, const int* end);

  TileBins Bins;
  /// The frame of Bins; empty if they cannot be used again.
  std::optional<TetrahedraFrame> Frame;
  std::vector<float> Colors;
  /// If true, Colors is the image of Frame, with the depths of opaque surfaces in Opaque.
  bool HasColors = false;
  std::vector<float> Opaque;
  bool Complete = false;
  std::vector<SeenTetrahedra::Seen> Seen;
};

}

#endif
