// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FragmentClones_h
#define interlume_FragmentClones_h

#include "Common/FunctionClones.h"

/// Compiles a function for AVX2 and FMA too.
#if defined(__GNUC__) && __GNUC__ >= 12
#define INTERLUME_CLONES INTERLUME_FUNCTION_CLONES("arch=x86-64-v3")
#else
#define INTERLUME_CLONES INTERLUME_FUNCTION_CLONES("avx2")
#endif

#endif
