// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FunctionClones_h
#define interlume_FunctionClones_h

/**
 * INTERLUME_FUNCTION_CLONES compiles a function for another target of x86-64 too, with all it calls
 * that can be inlined, and chooses when the program is loaded. Sanitizers cannot run the choice,
 * which comes before them.
 *
 * INTERLUME_AVX2_FUNCTION compiles a function for AVX2 alone, INTERLUME_HAS_AVX2 tells whether the
 * machine has it: for functions that tests call both with it and without. Other compilers make
 * nothing of the first and say no to the second.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__)
#define INTERLUME_AVX2_FUNCTION __attribute__((target("avx2"), flatten))
#define INTERLUME_HAS_AVX2 (__builtin_cpu_supports("avx2") != 0)
#define INTERLUME_HAS_CLONES
#else
#define INTERLUME_AVX2_FUNCTION
#define INTERLUME_HAS_AVX2 false
#endif

#if defined(INTERLUME_HAS_CLONES) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define INTERLUME_FUNCTION_CLONES(target) __attribute__((target_clones(target, "default"), flatten))
#else
#define INTERLUME_FUNCTION_CLONES(target)
#endif

#endif
