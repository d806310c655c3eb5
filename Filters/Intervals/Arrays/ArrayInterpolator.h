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
 * The values have the bytes that ExtractionArrays gives. Any number of threads may use one.
 */
class ArrayInterpolator
{
public:
  /// Makes that of \a in, which must outlive it, for results of type VTK_FLOAT or VTK_DOUBLE.
  static std::unique_ptr<ArrayInterpolator> Make(vtkDataArray* in, int outType);

  virtual ~ArrayInterpolator() = default;

  /// Writes the tuples of \a number points to \a out, an array of the results' type.
  virtual void Interpolate(const ExtractionPoint* points, std::size_t number, void* out) const = 0;
};

}

#endif
