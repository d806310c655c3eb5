// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SoftwareRasterizer_h
#define interlume_SoftwareRasterizer_h

#include "Frame/TetrahedraFrame.h"
#include "Software/TileBins.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace interlume
{

/**
 * @class   SoftwareRasterizer
 * @brief   draws tetrahedra on the CPU
 *
 * The picture is cut into tiles, each drawn by one thread from front to back: the silhouettes give
 * segments (Fragments), these are integrated many at a time, and then blended one by one. The
 * result does not depend on the number of threads.
 */
class SoftwareRasterizer
{
public:
  /// Draws an image; returns false if \a isAborted returned true.
  bool Draw(const TetrahedraFrame& frame, const std::function<bool()>& isAborted);

  /// Returns RGBA row by row from below, colour multiplied by opacity, or sums where the frame asks
  /// for them; not for SELECTION.
  const std::vector<float>& GetColors() const { return this->Colors; }
  /// Return the tetrahedron plus 1 of each pixel, 0 where there is none, and its depth, for
  /// SELECTION.
  const std::vector<std::uint32_t>& GetTetrahedra() const { return this->Tetrahedra; }
  const std::vector<float>& GetDepths() const { return this->Depths; }

  vtkIdType GetNumberDrawn() const { return this->Bins.GetNumberDrawn(); }
  std::size_t GetBytes() const;

private:
  TileBins Bins;
  std::vector<float> Colors;
  std::vector<std::uint32_t> Tetrahedra;
  std::vector<float> Depths;
};

}

#endif
