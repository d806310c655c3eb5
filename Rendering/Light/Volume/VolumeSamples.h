// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeSamples_h
#define interlume_VolumeSamples_h

#include "Common/Error.h"

#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataArray;

namespace interlume
{

/**
 * @class   VolumeSamples
 * @brief   the values of an image in the layout of a 3D texture
 *
 * Values are `Offset + Scale * texel`. Texels of 8-bit and 16-bit integers map the range of the
 * type to 0 to 1, so that each value has an exact texel. Texels of other types are between -2 and
 * 2: an offset is subtracted, and the difference is divided by a power of two. Texels and their
 * squares do not overflow. The offset is near the middle of the range if that is far from zero, and
 * 0 otherwise, so that doubles far from zero retain their digits in single precision. Floats are
 * represented exactly.
 */
class VolumeSamples
{
public:
  enum Formats
  {
    /// One byte per component, read as 0 to 1.
    UNORM8,
    /// Two bytes per component, read as 0 to 1.
    UNORM16,
    FLOAT32
  };

  /**
   * Converts \a array with \a size values along x, y, z, in parallel. If \a widens is true, 8-bit
   * values are stored in 16 bits, for software renderers that interpolate bytes with 8-bit
   * precision. The texels do not depend on the number of threads. Returns an error, and leaves no
   * samples, if there are too few values, 0 or more than 4 components, or too little memory.
   */
  Error Build(vtkDataArray* array, const std::array<int, 3>& size, bool widens);

  std::array<int, 3> Size{ { 0, 0, 0 } };
  int Components = 0;
  Formats Format = FLOAT32;
  /// Offset and scale of each component. The scale is never 0.
  std::array<double, 4> Offset{ { 0.0, 0.0, 0.0, 0.0 } };
  std::array<double, 4> Scale{ { 1.0, 1.0, 1.0, 1.0 } };
  /// Smallest and largest finite value of each component. Includes values in voxels that are
  /// transparent because of another component. Both are 0 if no value is finite.
  std::array<std::array<double, 2>, 4> Range{};
  /// Texels, with the components of a voxel together, x fastest.
  std::vector<unsigned char> Texels;
  /// Mask of finite voxels. Empty if all values are finite. Otherwise 65535 for a finite voxel and
  /// 0 for others, whose texels are 0. The interpolated texel divided by the interpolated mask is
  /// then the mean of the finite values.
  std::vector<unsigned short> Mask;
  /// Number of voxels with NaN or infinity in any component.
  vtkIdType NonFinite = 0;
};

}

#endif
