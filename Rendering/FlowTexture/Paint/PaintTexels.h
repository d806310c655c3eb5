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
 * @brief   an image as 16-bit texels: premultiplied red, green and blue, and alpha
 *
 * Sixteen bits preserve colors of low opacity. Also, software OpenGL does not interpolate 8-bit
 * texels precisely.
 */
class PaintTexels
{
public:
  /**
   * Reads the active point scalars of an image: unsigned char (0 to 255), unsigned short (0 to
   * 65535), float or double (0 to 1, clamped; NaN becomes 0), with one (gray), two (gray and
   * alpha), three or four components. \a dimensions is the maximum number of axes with more than
   * one point. Returns an error if the image cannot be used. The message has no subject, so that
   * the caller can prepend the name of the image.
   */
  Error Build(vtkImageData* image, int dimensions);

  /// Number of texels along the axes with more than one point, followed by ones.
  std::array<int, 3> Size{ { 1, 1, 1 } };
  std::vector<unsigned short> Texels;
};

}

#endif
