#include "vtkExtractionMemory.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

void vtkExtractionMemory::PreferLargePages(void* memory, std::size_t bytes)
{
#if defined(__linux__)
  // Whole pages only: what lies beside the block is not ours.
  constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
  const std::uintptr_t begin = (reinterpret_cast<std::uintptr_t>(memory) + page - 1) & ~(page - 1);
  const std::uintptr_t end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(page - 1);
  if (begin < end)
  {
    // A kernel without large pages refuses, and small ones do.
    static_cast<void>(madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE));
  }
#else
  static_cast<void>(memory);
  static_cast<void>(bytes);
#endif
}
