// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PaintTexels_h
#define interlume_PaintTexels_h

#include "Common/Error.h"

#include <array>
#include <vector>

class vtkImageData;

namespace interlume
{

/**
 * @class   PaintTexels
 * @brief   an image as texels of 16 bits: red, green, blue, each times alpha, and alpha
 *
 * Sixteen bits keep the colours of paint that is nearly transparent, and software OpenGL does not
 * interpolate them in bytes.
 */
class PaintTexels
{
public:
  /**
   * Reads the active point scalars of an image of unsigned char (0 to 255), unsigned short (0 to
   * 65535), float or double (0 to 1, clamped; no number is 0), of one (grey), two (grey and alpha),
   * three or four components. \a dimensions is the largest number of axes with more than one point.
   * Returns an error if the image cannot be used; its message continues a sentence that begins with
   * the image's name.
   */
  Error Build(vtkImageData* image, int dimensions);

  /// The texels along the image's axes; those along axes of one point are left out, ones follow.
  std::array<int, 3> Size{ { 1, 1, 1 } };
  std::vector<unsigned short> Texels;
};

}

#endif
