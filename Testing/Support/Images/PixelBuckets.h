// SPDX-License-Identifier: BSD-3-Clause
#ifndef PixelBuckets_h
#define PixelBuckets_h

#include "Support/Images/ReferenceRay.h"         // for projections
#include "Support/Images/ReferenceTetrahedron.h" // for tetrahedra

#include <cstdint>
#include <vector>

namespace reference
{

/**
 * @class   PixelBuckets
 * @brief   tetrahedra that may intersect the view ray of each pixel
 *
 * A tetrahedron is listed for a pixel if the projected bounding box of its part beyond the near
 * plane, enlarged by one pixel, contains the pixel.
 */
class PixelBuckets
{
public:
  PixelBuckets(const std::vector<RayTetrahedron>& tetrahedra, const PixelRays& rays,
    const std::array<int, 2>& size);

  /// Return the range of tetrahedron ids for a pixel.
  const std::uint32_t* Begin(int pixel) const { return this->Ids.data() + this->First[pixel]; }
  const std::uint32_t* End(int pixel) const { return this->Ids.data() + this->First[pixel + 1]; }

private:
  std::vector<std::size_t> First;
  std::vector<std::uint32_t> Ids;
};

}

#endif
