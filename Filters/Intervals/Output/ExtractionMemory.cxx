// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ExtractionMemory.h"

#include "vtkDataArray.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace interlume
{

void ExtractionMemory::PreferLargePages(void* memory, std::size_t bytes)
{
#if defined(__linux__)
  // Only whole pages count: memory beside the block belongs to others.
  constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
  const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t before = (page - address % page) % page;
  const std::uintptr_t after = (address + bytes) % page;
  if (before + after < bytes)
  {
    // A kernel without large pages refuses, and so do kernels with small ones.
    static_cast<void>(
      madvise(static_cast<char*>(memory) + before, bytes - before - after, MADV_HUGEPAGE));
  }
#else
  static_cast<void>(memory);
  static_cast<void>(bytes);
#endif
}

void ExtractionMemory::PreferLargePages(vtkDataArray* array)
{
  PreferLargePages(array->GetVoidPointer(0),
    static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
}

}
