// SPDX-License-Identifier: BSD-3-Clause
#ifndef PixelBuckets_h
#define PixelBuckets_h

#include "Support/Pictures/ReferenceRay.h"         // for projections
#include "Support/Pictures/ReferenceTetrahedron.h" // for tetrahedra

#include <cstdint>
#include <vector>

namespace reference
{

/**
 * @class   PixelBuckets
 * @brief   for each pixel the tetrahedra that its line of sight may meet
 *
 * Those whose part in front of the near plane has the pixel in its projected bounding box, widened
 * by one pixel.
 */
class PixelBuckets
{
public:
  PixelBuckets(const std::vector<RayTetrahedron>& tetrahedra, const PixelRays& rays,
    const std::array<int, 2>& size);

  /// The range of ids for a pixel.
  const std::uint32_t* Begin(int pixel) const { return this->Ids.data() + this->First[pixel]; }
  const std::uint32_t* End(int pixel) const { return this->Ids.data() + this->First[pixel + 1]; }

private:
  std::vector<std::size_t> First;
  std::vector<std::uint32_t> Ids;
};

}

#endif
