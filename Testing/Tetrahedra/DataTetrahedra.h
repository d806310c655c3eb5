// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataTetrahedra_h
#define DataTetrahedra_h

#include "Tetrahedra/MapperImage.h" // for ImageCase

#include <array>  // for sizes
#include <string> // for names

namespace reference
{

/**
 * A file in Data/ with a point array. If Lower < Upper, the tetrahedra are the interval volume from
 * Lower to Upper, otherwise the full grid.
 */
struct DataTetrahedra
{
  std::string File;
  std::string Array;
  double Lower = 0.0;
  double Upper = 0.0;

  std::string GetName() const;
  /**
   * Returns the tetrahedra with colors from cool to warm over the range of values, and opacity from
   * 0 to 1 with a unit distance of a fifteenth of the data's size. The camera is not set.
   * @throw std::runtime_error if the file cannot be read or has no such array.
   */
  ImageCase Make(const std::array<int, 2>& size) const;
};

}

#endif
