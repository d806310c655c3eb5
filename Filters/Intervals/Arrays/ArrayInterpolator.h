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
 * @brief   interpolates an array of numbers at a few points at a time
 *
 * Any number of threads may use one.
 */
class ArrayInterpolator
{
public:
  /// Creates an interpolator for results of type VTK_FLOAT or VTK_DOUBLE. Ids from \a split on are
  /// tuples of \a second, which may be the first array too. Both must outlive the result.
  static std::unique_ptr<ArrayInterpolator> Make(
    vtkDataArray* first, vtkDataArray* second, vtkIdType split, int outType);

  virtual ~ArrayInterpolator() = default;

  /// Writes the tuples of \a number points to \a out, an array of the results' type.
  virtual void Interpolate(const ExtractionPoint* points, std::size_t number, void* out) const = 0;
};

}

#endif
