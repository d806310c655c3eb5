// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PieceImage_h
#define interlume_PieceImage_h

#include "Frame/TetrahedraFrame.h"
#include "Software/SoftwareRasterizer.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace interlume
{

class PieceExchange;

/**
 * @class   PieceImage
 * @brief   the image of a volume that is distributed over several processes
 *
 * Each process draws the sums or maxima of the blend mode along the view rays in its partition. The
 * processes exchange these values in floating point and then convert them to colors. With
 * COMPOSITE, each process composites its partition, and the results are composited in visibility
 * order, which exists if planes separate the partitions. The image is therefore the same as with a
 * single process, up to rounding in sums. All functions are collective.
 */
class PieceImage
{
public:
  /**
   * \a frame is this process's partition, or null if it is empty. \a pixels is the number of
   * viewport pixels.
   */
  PieceImage(const PieceExchange& exchange, const TetrahedraFrame* frame, std::size_t pixels,
    SoftwareRasterizer& rasterizer);

  /**
   * Returns the complete image as RGBA, premultiplied by opacity. All processes get the same image.
   * \a priorities contains the priorities of the layers, and \a order the processes from front to
   * back.
   */
  std::vector<float> Draw(TetrahedraFrame::Blends blend, const std::map<int, double>& priorities,
    const std::vector<int>& order);

  /**
   * Returns true for each pixel that this process shows. A pixel is shown by the process that has
   * the closest opaque surface there, because the volume is blended over this surface. A pixel
   * without a surface is shown by the first process. \a depths are the depths of this process's
   * surfaces, in [0, 1], and become the minimum over all processes.
   */
  static std::vector<bool> FindShownPixels(
    const PieceExchange& exchange, std::vector<float>& depths);

private:
  /// Draws the sums or maxima of \a blend in this partition. If \a tetrahedra is not null, draws
  /// only those.
  std::vector<float> DrawPiece(
    TetrahedraFrame::Blends blend, const std::vector<std::uint32_t>* tetrahedra);
  std::vector<float> DrawSum(
    TetrahedraFrame::Blends blend, const std::vector<std::uint32_t>* tetrahedra);
  std::vector<float> DrawOrdered(const std::vector<int>& order);
  std::vector<float> DrawMaximum();
  std::vector<float> DrawLayers(const std::map<int, double>& priorities);

  const PieceExchange& Exchange;
  const TetrahedraFrame* Frame;
  std::size_t Pixels;
  SoftwareRasterizer& Rasterizer;
};

}

#endif
