// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OutputAllocation_h
#define interlume_OutputAllocation_h

#include "vtkType.h"

#include <cstddef>

class vtkDataArray;

namespace interlume
{

/**
 * @class   OutputAllocation
 * @brief   memory allocation for output arrays
 *
 * With default allocation, a large extraction would spend most of its time in page faults, one per
 * 4 KiB of output. Large pages and pooled blocks reduce the number of page faults.
 */
class OutputAllocation
{
public:
  /// Requests large pages within [memory, memory + bytes) if the system supports them. Call this
  /// before the first access. Has no effect on small blocks.
  static void PreferLargePages(void* memory, std::size_t bytes);
  /// Requests large pages for the values of an array whose size is already set.
  static void PreferLargePages(vtkDataArray* array);
  /// Allocates \a number tuples in an empty array, in a pooled block if possible and in large pages
  /// otherwise.
  static void SetNumberOfTuples(vtkDataArray* array, vtkIdType number);
  /// Reduces an array allocated by SetNumberOfTuples() to its first \a number tuples.
  static void Shorten(vtkDataArray* array, vtkIdType number);
};

}

#endif
