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
 * A value is `Offset + Scale * texel`. For 8-bit and 16-bit integers, texels map the range of the
 * type to [0, 1], so that each value is represented exactly. For other types, Scale is a power of
 * two, and texels are between -2 and 2, so that their squares do not overflow. Offset is then the
 * middle of the range if that is far from zero, and 0 otherwise, so that doubles far from zero
 * retain their precision. Floats are represented exactly.
 */
class VolumeSamples
{
public:
  enum Formats
  {
    /// One byte per component, read by shaders as a value in [0, 1].
    UNORM8,
    /// Two bytes per component, read by shaders as a value in [0, 1].
    UNORM16,
    FLOAT32
  };

  /**
   * Converts \a array, with \a size voxels along x, y and z, in parallel. If \a widens is true,
   * 8-bit values are stored in 16 bits, for software renderers that interpolate bytes with only
   * 8-bit precision. The texels do not depend on the number of threads. Returns an error, and
   * leaves no samples, if there are too few values, 0 or more than 4 components, or too little
   * memory.
   */
  Error Build(vtkDataArray* array, const std::array<int, 3>& size, bool widens);

  /// Computes, for each voxel and axis, the difference of the texels after and before the voxel, in
  /// parallel. At the first and last voxel of an axis, the voxel itself replaces the missing one.
  /// The samples must have one component and no mask, and a format other than UNORM8.
  std::vector<float> FindDifferences() const;

  std::array<int, 3> Size{ { 0, 0, 0 } };
  int Components = 0;
  Formats Format = FLOAT32;
  /// Offset and scale of each component. The scale is never 0.
  std::array<double, 4> Offset{ { 0.0, 0.0, 0.0, 0.0 } };
  std::array<double, 4> Scale{ { 1.0, 1.0, 1.0, 1.0 } };
  /// Smallest and largest finite value of each component. Includes values in voxels that are
  /// transparent because another component is not finite. Both are 0 if no value is finite.
  std::array<std::array<double, 2>, 4> Range{};
  /// Texels, x fastest. The components of a voxel are adjacent.
  std::vector<unsigned char> Texels;
  /// Mask of finite voxels, or empty if all values are finite. It is 65535 for finite voxels and 0
  /// for other voxels, whose texels are also 0. The interpolated texel divided by the interpolated
  /// mask is then the interpolation of the finite values alone.
  std::vector<unsigned short> Mask;
  /// Number of voxels with NaN or infinity in any component.
  vtkIdType NonFinite = 0;
};

}

#endif
