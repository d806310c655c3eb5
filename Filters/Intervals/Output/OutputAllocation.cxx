// SPDX-License-Identifier: BSD-3-Clause
#include "Output/OutputAllocation.h"

#include "Output/BlockPool.h"

#include "vtkDataArray.h"

#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace interlume
{

namespace
{
void SetPooledMemory(vtkDataArray* array, void* pooled, vtkIdType values)
{
  array->SetVoidArray(pooled, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
  array->SetArrayFreeFunction(BlockPool::Release);
}
}

void OutputAllocation::PreferLargePages(void* memory, std::size_t bytes)
{
#if defined(__linux__)
  // Restrict the request to the large pages that are entirely inside the block.
  constexpr std::uintptr_t page = std::uintptr_t(1) << 21;
  const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t before = (page - address % page) % page;
  const std::uintptr_t after = (address + bytes) % page;
  if (before + after < bytes)
  {
    // Ignore failure: kernels without large pages reject the request.
    static_cast<void>(
      madvise(static_cast<char*>(memory) + before, bytes - before - after, MADV_HUGEPAGE));
  }
#else
  static_cast<void>(memory);
  static_cast<void>(bytes);
#endif
}

void OutputAllocation::PreferLargePages(vtkDataArray* array)
{
  PreferLargePages(array->GetVoidPointer(0),
    static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
}

void OutputAllocation::Shorten(vtkDataArray* array, vtkIdType number)
{
  const vtkIdType values = number * array->GetNumberOfComponents();
  void* const memory = array->GetVoidPointer(0);
  if (BlockPool::IsPooled(memory))
  {
    // SetNumberOfValues() would move the values to newly allocated memory.
    SetPooledMemory(array, memory, values);
    return;
  }
  array->SetNumberOfValues(values);
}

void OutputAllocation::SetNumberOfTuples(vtkDataArray* array, vtkIdType number)
{
  const vtkIdType values = number * array->GetNumberOfComponents();
  const bool isPlain = array->HasStandardMemoryLayout() && array->GetDataType() != VTK_BIT;
  void* const pooled = isPlain
    ? BlockPool::Acquire(static_cast<std::size_t>(values) * array->GetDataTypeSize())
    : nullptr;
  if (pooled)
  {
    SetPooledMemory(array, pooled, values);
    return;
  }
  array->SetNumberOfTuples(number);
  if (isPlain)
  {
    PreferLargePages(array);
  }
}

}
