// SPDX-License-Identifier: BSD-3-Clause
#ifndef CostSection_h
#define CostSection_h

#include "Benchmarks/Results/BenchResults.h"

#include <string>

namespace html
{
/**
 * What scenes pay, of the rows that interlume-bench-costs wrote: what is left of features that are
 * off and what they add; folded, the same by scene, the classes that scenes execute, and all rows.
 * Nothing without rows of scenes.
 */
std::string CostsOf(const BenchResults& results);
}

#endif
