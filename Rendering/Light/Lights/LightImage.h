// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightImage_h
#define interlume_LightImage_h

#include "Common/Error.h"
#include "Common/Vectors.h"

#include "vtkType.h" // for ids

#include <string>
#include <vector>

class vtkImageData;

namespace interlume
{

/**
 * @class   LightImage
 * @brief   reads the colours of a light's image
 *
 * The image is two-dimensional (one sample along z), unsigned char 0 to 255 or floating point 0 to
 * 1, of 1 (grey), 2 (grey, opacity), 3 (RGB) or 4 (RGB, opacity) components in its point scalars.
 * A colour is red, green and blue, each times opacity. Values outside 0 to 1 are clamped, NaN is 0.
 */
class LightImage
{
public:
  explicit LightImage(vtkImageData* image)
    : Image(image)
  {
  }

  /// Returns an error if the image cannot be read. The message calls it \a name.
  Error GetError(const std::string& name) const;

  /// Returns the colour of a sample.
  glm::dvec3 GetSample(vtkIdType index) const;

  /// Returns the colours of all samples, x fastest.
  std::vector<float> GetTexels() const;

  /// Returns the colour at (u,v) of the image, each 0 to 1: bilinear between samples, or the
  /// nearest one's. The samples at the image's edge continue beyond it.
  glm::dvec3 GetColor(double u, double v, bool isInterpolated) const;

private:
  vtkImageData* Image;
};

}

#endif
