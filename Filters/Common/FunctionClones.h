// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FunctionClones_h
#define interlume_FunctionClones_h

/**
 * Compiles a function for another target of x86-64 too, with all it calls that can be inlined, and
 * chooses when the program is loaded. Sanitizers cannot run the choice, which comes before them.
 */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define INTERLUME_FUNCTION_CLONES(target) __attribute__((target_clones(target, "default"), flatten))
#else
#define INTERLUME_FUNCTION_CLONES(target)
#endif

#endif
