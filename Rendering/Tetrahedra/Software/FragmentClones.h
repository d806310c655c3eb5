// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FragmentClones_h
#define interlume_FragmentClones_h

namespace interlume
{

/**
 * Compiles a function for AVX2 and FMA too, with all it calls that can be inlined, and chooses when
 * the program is loaded. Sanitizers cannot run the choice, which comes before them.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if __GNUC__ >= 12
#define INTERLUME_CLONES __attribute__((target_clones("arch=x86-64-v3", "default"), flatten))
#else
#define INTERLUME_CLONES __attribute__((target_clones("avx2", "default"), flatten))
#endif
#else
#define INTERLUME_CLONES
#endif

}

#endif
