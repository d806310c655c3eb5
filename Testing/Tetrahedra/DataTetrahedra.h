// SPDX-License-Identifier: BSD-3-Clause
#ifndef DataTetrahedra_h
#define DataTetrahedra_h

#include "Tetrahedra/MapperPicture.h" // for what is drawn

#include <array>  // for sizes
#include <string> // for names

namespace reference
{

/**
 * A file of Data/ and a point array of it, whole where lower >= upper and else from lower to upper.
 */
struct DataTetrahedra
{
  std::string File;
  std::string Array;
  double Lower = 0.0;
  double Upper = 0.0;

  std::string GetName() const;
  /**
   * Its tetrahedra, coloured as a newcomer sees them: cool to warm over the values drawn, opacity
   * from 0 to 1 in a fifteenth of their size. No camera.
   * @throw std::runtime_error for a file that can't be read or has no such array.
   */
  PictureCase Make(const std::array<int, 2>& size) const;
};

}

#endif
