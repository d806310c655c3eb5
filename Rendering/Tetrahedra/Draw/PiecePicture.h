// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PiecePicture_h
#define interlume_PiecePicture_h

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
 * @class   PiecePicture
 * @brief   the picture of a volume whose pieces are drawn by several processes
 *
 * Each process draws what the blend mode sums up along the lines of sight of its own piece, or
 * keeps the largest of; that is exchanged in floats, and then becomes colours. Pieces that planes
 * part have an order, and what each process composites of its own is laid over each other in it. So
 * the picture is that of one process but for the order of sums. Everything here is collective.
 */
class PiecePicture
{
public:
  /**
   * \a frame is the own piece, null where there is none. \a pixels is the number of the viewport.
   */
  PiecePicture(const PieceExchange& exchange, const TetrahedraFrame* frame, std::size_t pixels,
    SoftwareRasterizer& rasterizer);

  /**
   * Returns the whole picture as RGBA, colour multiplied by opacity, the same in all processes.
   * \a priorities are those of layers, \a order is that of the processes from the nearest on.
   */
  std::vector<float> Draw(TetrahedraFrame::Blends blend, const std::map<int, double>& priorities,
    const std::vector<int>& order);

  /**
   * Tells for each pixel whether the own process shows it: the one with the nearest opaque surface,
   * which shows it over that; without surfaces the first. \a depths are those of the own surfaces,
   * 0 to 1, and become the nearest of all.
   */
  static std::vector<bool> FindShown(const PieceExchange& exchange, std::vector<float>& depths);

private:
  /// Draws what a blend mode sums up of the own piece, or of those of its tetrahedra.
  std::vector<float> DrawPiece(
    TetrahedraFrame::Blends blend, const std::vector<std::uint32_t>* tetrahedra);
  std::vector<float> DrawSum(
    TetrahedraFrame::Blends blend, const std::vector<std::uint32_t>* tetrahedra);
  std::vector<float> DrawOrdered(const std::vector<int>& order);
  std::vector<float> DrawLargest();
  std::vector<float> DrawLayers(const std::map<int, double>& priorities);

  const PieceExchange& Exchange;
  const TetrahedraFrame* Frame;
  std::size_t Pixels;
  SoftwareRasterizer& Rasterizer;
};

}

#endif
