// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionMemory_h
#define interlume_ExtractionMemory_h

#include "vtkType.h"

#include <cstddef>

class vtkDataArray;

namespace interlume
{

/**
 * @class   ExtractionMemory
 * @brief   where values that are about to be written lie; it changes nothing but the time
 *
 * Most of the time of a large extraction would go into page faults, one for each 4 KiB of output.
 */
class ExtractionMemory
{
public:
  /// Asks for large pages within [memory, memory + bytes), where the system has them; to be called
  /// before the first access. It has no effect on small blocks, nor on the values.
  static void PreferLargePages(void* memory, std::size_t bytes);
  /// Asks for large pages for the values of an array, once it has its size.
  static void PreferLargePages(vtkDataArray* array);
  /// Gives an array without values its size, in kept memory or in large pages.
  static void SetNumberOfTuples(vtkDataArray* array, vtkIdType number);
  /// Leaves the first \a number tuples of such an array.
  static void Shorten(vtkDataArray* array, vtkIdType number);
};

}

#endif
