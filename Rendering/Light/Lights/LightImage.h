// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LightImage_h
#define interlume_LightImage_h

#include "Common/Error.h"
#include "Common/Vectors.h"

#include "vtkType.h" // for vtkIdType

#include <string>
#include <vector>

class vtkImageData;

namespace interlume
{

/**
 * @class   LightImage
 * @brief   reads the colors of a light's image
 *
 * The image is two-dimensional (one sample along z). Its point scalars are integers, from 0 to the
 * largest value of their type, or floating point (0 to 1), with 1 (gray), 2 (gray, opacity), 3
 * (RGB) or 4 (RGB, opacity) components. The colors returned are RGB, multiplied by the opacity.
 * Values outside the range are clamped; NaN becomes 0.
 */
class LightImage
{
public:
  explicit LightImage(vtkImageData* image)
    : Image(image)
  {
  }

  /// Returns an error if the image cannot be read. The message calls the image \a name.
  Error GetError(const std::string& name) const;

  /// Returns the color of a sample.
  glm::dvec3 GetSample(vtkIdType index) const;

  /// Returns the colors of all samples, x fastest.
  std::vector<float> GetTexels() const;

  /// Returns the color at image coordinates (u, v), each from 0 to 1: interpolated bilinearly, or
  /// the color of the nearest sample. Positions beyond the outermost samples are clamped to them.
  glm::dvec3 GetColor(double u, double v, bool isInterpolated) const;

private:
  vtkImageData* Image;
};

}

#endif
