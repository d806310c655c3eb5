// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SimdDispatch_h
#define interlume_SimdDispatch_h

#include <utility>

#if defined(__GNUC__) && defined(__x86_64__)
#define INTERLUME_TARGET(names) [[gnu::target(names), gnu::flatten]]
#define INTERLUME_HAS_TARGET(name) (__builtin_cpu_supports(name) != 0)
#else
#define INTERLUME_TARGET(names)
#define INTERLUME_HAS_TARGET(name) false
#endif

namespace interlume
{

/**
 * @class   SimdDispatch
 * @brief   calls a function compiled for the instruction sets of the current processor
 *
 * GCC and Clang inline the function into one caller per instruction set. On other compilers and
 * architectures there is one caller. Use it for whole loops. A function that the compiler does not
 * inline still uses the baseline instruction set.
 */
class SimdDispatch
{
public:
  /// Calls \a work with \a arguments, compiled for AVX2 if the processor supports it. Products and
  /// sums are not fused, so that results are the same on all processors.
  template <typename Work, typename... Arguments>
  static decltype(auto) Call(Work&& work, Arguments&&... arguments)
  {
    return HasAvx2 ? CallForAvx2(work, std::forward<Arguments>(arguments)...)
                   : CallForAny(work, std::forward<Arguments>(arguments)...);
  }

  /// Same as Call(), but with fused multiply-add, which rounds differently.
  template <typename Work, typename... Arguments>
  static decltype(auto) CallFused(Work&& work, Arguments&&... arguments)
  {
    return HasAvx2 && HasFma ? CallForFma(work, std::forward<Arguments>(arguments)...)
                             : CallForAny(work, std::forward<Arguments>(arguments)...);
  }

  /// Sets whether AVX2 is used if the processor supports it, so that tests can run both versions.
  static void UseAvx2(bool isUsed) { HasAvx2 = isUsed && INTERLUME_HAS_TARGET("avx2"); }

private:
  template <typename Work, typename... Arguments>
  [[gnu::flatten]] static decltype(auto) CallForAny(Work& work, Arguments&&... arguments)
  {
    return work(std::forward<Arguments>(arguments)...);
  }
  template <typename Work, typename... Arguments>
  INTERLUME_TARGET("avx2")
  static decltype(auto) CallForAvx2(Work& work, Arguments&&... arguments)
  {
    return work(std::forward<Arguments>(arguments)...);
  }
  template <typename Work, typename... Arguments>
  INTERLUME_TARGET("avx2,fma,bmi,bmi2,lzcnt")
  static decltype(auto) CallForFma(Work& work, Arguments&&... arguments)
  {
    return work(std::forward<Arguments>(arguments)...);
  }

  inline static bool HasAvx2 = INTERLUME_HAS_TARGET("avx2");
  inline static const bool HasFma = INTERLUME_HAS_TARGET("fma") && INTERLUME_HAS_TARGET("bmi2");
};

}

#endif
