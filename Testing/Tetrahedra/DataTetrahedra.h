// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataTetrahedra_h
#define DataTetrahedra_h

#include "Tetrahedra/MapperImage.h" // for ImageCase

#include <array>  // for sizes
#include <string> // for names

namespace reference
{

/**
 * A file in Data/ and one of its point arrays. If Lower < Upper, the tetrahedra are the interval
 * volume from Lower to Upper. Otherwise, they fill the whole grid.
 */
struct DataTetrahedra
{
  std::string File;
  std::string Array;
  double Lower = 0.0;
  double Upper = 0.0;

  std::string GetName() const;
  /**
   * Returns the tetrahedra with a cool-to-warm color map and an opacity ramp from 0 to 1 over the
   * range of values. The opacity unit distance is 1/15 of the diagonal of the bounding box. The
   * camera is not set.
   * @throw std::runtime_error if the file cannot be read or has no such array.
   */
  ImageCase Make(const std::array<int, 2>& size) const;
};

}

#endif
