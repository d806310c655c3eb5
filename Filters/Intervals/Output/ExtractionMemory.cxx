// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ExtractionMemory.h"

#include "Output/KeptMemory.h"

#include "vtkDataArray.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace interlume
{

namespace
{
void SetKept(vtkDataArray* array, void* kept, vtkIdType values)
{
  array->SetVoidArray(kept, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction(KeptMemory::Give);
}
}

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

void ExtractionMemory::Shorten(vtkDataArray* array, vtkIdType number)
{
  const vtkIdType values = number * array->GetNumberOfComponents();
  void* const memory = array->GetVoidPointer(0);
  if (KeptMemory::IsKept(memory))
  {
    // VTK would move the values to memory of its own.
    SetKept(array, memory, values);
    return;
  }
  array->SetNumberOfValues(values);
}

void ExtractionMemory::SetNumberOfTuples(vtkDataArray* array, vtkIdType number)
{
  const vtkIdType values = number * array->GetNumberOfComponents();
  const bool isPlain = array->HasStandardMemoryLayout() && array->GetDataType() != VTK_BIT;
  void* const kept = isPlain
    ? KeptMemory::Take(static_cast<std::size_t>(values) * array->GetDataTypeSize())
    : nullptr;
  if (kept)
  {
    SetKept(array, kept, values);
    return;
  }
  array->SetNumberOfTuples(number);
  if (isPlain)
  {
    PreferLargePages(array);
  }
}

}
