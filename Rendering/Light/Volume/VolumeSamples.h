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
 * @brief   the values of an image as a texture of three dimensions has them
 *
 * Values are `Offset + Scale * texel`. Texels of integers of 8 and 16 bits are 0 to 1 over all that
 * their type can have, so that each has one exactly. Texels of other types are within -2 to 2: the
 * value less an offset that is near the middle of the range where that is far from zero, and 0
 * elsewhere, so that doubles far from zero keep their digits in single precision; over a power of
 * two, so that neither they nor their squares overflow. Floats are kept exactly.
 */
class VolumeSamples
{
public:
  enum Formats
  {
    /// One byte, 0 to 1.
    UNORM8,
    /// Two bytes, 0 to 1.
    UNORM16,
    FLOAT32
  };

  /**
   * Takes the values of \a array, \a size of them along x, y, z. Values of 8 bits are kept in 16 if
   * \a widens, for software renderers that interpolate bytes in bytes. Returns an error if there
   * are no or too few values, none or more than four components, or no memory; there are no samples
   * then. Threads share the work; the texels are the same for any number of threads.
   */
  Error Build(vtkDataArray* array, const std::array<int, 3>& size, bool widens);

  std::array<int, 3> Size{ { 0, 0, 0 } };
  int Components = 0;
  Formats Format = FLOAT32;
  /// The offset and the scale of each component. The scale is never 0.
  std::array<double, 4> Offset{ { 0.0, 0.0, 0.0, 0.0 } };
  std::array<double, 4> Scale{ { 1.0, 1.0, 1.0, 1.0 } };
  /// The smallest and largest finite value of each component, with the values of voxels that
  /// another component makes transparent; 0 and 0 where none is finite.
  std::array<std::array<double, 2>, 4> Range{};
  /// The texels, with the components of a voxel together, x fastest.
  std::vector<unsigned char> Texels;
  /// The mask of finite voxels: empty where all values are finite, else 65535 for each voxel that
  /// is and 0 for others, whose texels are 0, so that interpolated texel over interpolated mask is
  /// the mean of finite ones.
  std::vector<unsigned short> Mask;
  /// The number of voxels with NaN or infinity in a component.
  vtkIdType NonFinite = 0;
};

}

#endif
