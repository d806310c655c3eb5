// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionBuffer_h
#define interlume_ExtractionBuffer_h

#include "Output/ExtractionMemory.h"
#include "Output/KeptMemory.h"

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
 * @brief   an array of plain values that is not filled twice
 *
 * Unlike std::vector it leaves new values as they are, or has them zeroed by the system page by
 * page as they are first used, and so by the thread that uses them.
 */
template <typename T>
class ExtractionBuffer
{
  static_assert(std::is_trivially_destructible<T>::value, "values are not destroyed");

public:
  void Allocate(std::size_t number)
  {
    if (void* kept = KeptMemory::Take(GetBytes(number)))
    {
      this->Hold(kept, number, KeptMemory::Give);
    }
    else
    {
      this->Take(std::malloc(GetBytes(number)), number);
    }
  }
  void AllocateZeros(std::size_t number)
  {
    if (void* kept = KeptMemory::Take(GetBytes(number)))
    {
      this->Hold(std::memset(kept, 0, GetBytes(number)), number, KeptMemory::Give);
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
  /// Forgets all but the first \a number values.
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

  // There is room for at least one value, since an allocation of none may give null.
  static std::size_t GetBytes(std::size_t number) { return (number ? number : 1) * sizeof(T); }

  void Take(void* memory, std::size_t number)
  {
    if (!memory)
    {
      throw std::bad_alloc();
    }
    ExtractionMemory::PreferLargePages(memory, number * sizeof(T));
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
