// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionBuffer_h
#define interlume_ExtractionBuffer_h

#include "Output/OutputAllocation.h"
#include "Output/BlockPool.h"

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>

namespace interlume
{

/**
 * @class   ExtractionBuffer
 * @brief   array of trivial values without redundant initialization
 *
 * Unlike std::vector, it leaves new values uninitialized. If zeros are requested, the operating
 * system clears each page on first access, in the thread that uses the page.
 */
template <typename T>
class ExtractionBuffer
{
  static_assert(std::is_trivially_destructible<T>::value, "values are not destroyed");

public:
  void Allocate(std::size_t number)
  {
    if (void* pooled = BlockPool::Acquire(GetBytes(number)))
    {
      this->Hold(pooled, number, BlockPool::Release);
    }
    else
    {
      this->Take(std::malloc(GetBytes(number)), number);
    }
  }
  void AllocateZeros(std::size_t number)
  {
    if (void* pooled = BlockPool::Acquire(GetBytes(number)))
    {
      this->Hold(std::memset(pooled, 0, GetBytes(number)), number, BlockPool::Release);
    }
    else
    {
      this->Take(std::calloc(GetBytes(number), 1), number);
    }
  }
  void Free()
  {
    this->Values.reset();
    this->Size = 0;
  }
  /// Removes all but the first \a number values.
  void Truncate(std::size_t number) { this->Size = number; }

  std::size_t GetSize() const { return this->Size; }
  std::size_t GetBytes() const { return this->Size * sizeof(T); }
  T* GetData() { return this->Values.get(); }
  const T* GetData() const { return this->Values.get(); }
  T& operator[](std::size_t i) { return this->Values.get()[i]; }
  const T& operator[](std::size_t i) const { return this->Values.get()[i]; }

private:
  struct Deleter
  {
    void (*Free)(void*) = std::free;

    void operator()(T* values) const { this->Free(values); }
  };

  // Allocates at least one value because malloc(0) may return null.
  static std::size_t GetBytes(std::size_t number) { return (number ? number : 1) * sizeof(T); }

  void Take(void* memory, std::size_t number)
  {
    if (!memory)
    {
      throw std::bad_alloc();
    }
    OutputAllocation::PreferLargePages(memory, number * sizeof(T));
    this->Hold(memory, number, std::free);
  }

  void Hold(void* memory, std::size_t number, void (*free)(void*))
  {
    this->Values = std::unique_ptr<T, Deleter>(static_cast<T*>(memory), Deleter{ free });
    this->Size = number;
  }

  std::unique_ptr<T, Deleter> Values;
  std::size_t Size = 0;
};

}

#endif
