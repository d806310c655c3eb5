// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ArrayInterpolator_h
#define interlume_ArrayInterpolator_h

#include "Output/ExtractionPoint.h"

#include <cstddef>
#include <memory>

class vtkDataArray;

namespace interlume
{

/**
 * @class   ArrayInterpolator
 * @brief   interpolates a numeric array at a batch of points
 *
 * Interpolate() is thread-safe.
 */
class ArrayInterpolator
{
public:
  /// Creates an interpolator with the result type VTK_FLOAT or VTK_DOUBLE. An id i >= \a split
  /// refers to tuple i - \a split of \a second, which may be the same array. Both arrays must
  /// outlive the interpolator.
  static std::unique_ptr<ArrayInterpolator> Make(
    vtkDataArray* first, vtkDataArray* second, vtkIdType split, int outType);

  virtual ~ArrayInterpolator() = default;

  /// Writes the interpolated tuples of \a number points to \a out, an array of the result type.
  virtual void Interpolate(const ExtractionPoint* points, std::size_t number, void* out) const = 0;
};

}

#endif
