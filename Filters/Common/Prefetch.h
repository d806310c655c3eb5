// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_Prefetch_h
#define interlume_Prefetch_h

namespace interlume
{

/**
 * @class   Prefetch
 * @brief   asks for memory that is read soon; nothing with compilers that have no word for it
 */
struct Prefetch
{
  static void Read([[maybe_unused]] const void* address)
  {
#if defined(__GNUC__)
    __builtin_prefetch(address);
    // Without this statement GCC takes functions that only prefetch for ones that do nothing.
    __asm__ volatile("");
#endif
  }
};

}

#endif
