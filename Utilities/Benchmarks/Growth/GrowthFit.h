// SPDX-License-Identifier: BSD-3-Clause
#ifndef GrowthFit_h
#define GrowthFit_h

#include "Benchmarks/Growth/GrowthQuantity.h"
#include "Benchmarks/Results/BenchClaim.h"
#include "Benchmarks/Results/BenchPlot.h"
#include "Benchmarks/Results/BenchRow.h"

#include <string>
#include <vector>

namespace growth
{
///@{
/**
 * The methods of the rows of an exponent: of the processor time of all threads, and of KiB.
 */
extern const char* const TimeExponent;
extern const char* const MemoryExponent;
///@}

/// How far a fitted exponent may be from theory's.
constexpr double Margin = 0.15;
/// Memory below this is the pages of the allocator, and is fitted as this.
constexpr double LeastKib = 64.0;
/// A time over something else below this share of the whole is noise, and is fitted as this share.
constexpr double LeastShare = 0.01;

/**
 * Adds the fitted exponents of \a quantity, from its rows among \a rows, where there are two sizes:
 * the reason of theory's is the parameter; counts `exponent`, the slope of a line through the
 * logarithms by least squares; `least` and `most`, theory's; `sizes`, how many were fitted; and
 * `factor`, the largest n over the smallest.
 */
void AddExponentRows(const Quantity& quantity, BenchRows& rows);

/**
 * The claims that every exponent, of time and memory, is within Margin of theory's.
 */
std::vector<BenchClaim> CheckExponents(const std::vector<BenchRow>& rows);

/**
 * A plot for each quantity: time and memory against n, with lines of theory's exponents.
 */
std::vector<BenchPlot> MakeGrowthPlots(
  const std::vector<Quantity>& quantities, const std::vector<BenchRow>& rows);
}

#endif
