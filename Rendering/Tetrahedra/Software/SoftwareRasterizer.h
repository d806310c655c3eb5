// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SoftwareRasterizer_h
#define interlume_SoftwareRasterizer_h

#include "Frame/TetrahedraFrame.h"
#include "Software/SeenTetrahedra.h"
#include "Software/TileBins.h"

#include <functional>
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
 */
class SoftwareRasterizer
{
public:
  /// Draws an image. Returns false if \a isAborted returned true. It is called between groups of
  /// tiles, in the calling thread, with the completed fraction of the image.
  bool Draw(
    const TetrahedraFrame& frame, const std::function<bool(double fraction)>& isAborted = nullptr);

  /// Returns RGBA values, row by row from the bottom: premultiplied by opacity, or sums or maxima
  /// if TetrahedraFrame::IsSum is true. Empty with IsSelection.
  const std::vector<float>& GetColors() const { return this->Colors; }
  /// Returns the tetrahedron seen at each pixel. Empty except with IsSelection.
  const std::vector<SeenTetrahedra::Seen>& GetSeen() const { return this->Seen; }

  vtkIdType GetNumberOfDrawnTetrahedra() const { return this->Bins.GetNumberOfDrawnTetrahedra(); }
  std::size_t GetBytes() const;

private:
  void DrawTiles(const TetrahedraFrame& frame, vtkIdType begin, vtkIdType end);

  TileBins Bins;
  std::vector<float> Colors;
  std::vector<SeenTetrahedra::Seen> Seen;
};

}

#endif
