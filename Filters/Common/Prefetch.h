// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Prefetch_h
#define interlume_Prefetch_h

namespace interlume
{

/**
 * @class   Prefetch
 * @brief   prefetches memory that will be read soon, if the compiler supports it
 */
struct Prefetch
{
  static void Read([[maybe_unused]] const void* address)
  {
#if defined(__GNUC__)
    __builtin_prefetch(address);
    // Without this statement, GCC removes calls to functions that only prefetch.
    __asm__ volatile("");
#endif
  }
};

}

#endif
