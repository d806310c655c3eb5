// SPDX-License-Identifier: BSD-3-Clause
#ifndef Growth_h
#define Growth_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Suites/BenchSuite.h"

#include <functional>
#include <string>
#include <vector>

/**
 * Quantities of the suite `growth`, which measures cost as a function of N.
 */
namespace growth
{
/**
 * Expected exponent of N and the reason for it. Minimum and Maximum differ if two terms contribute
 * to the cost.
 */
struct Theory
{
  double Minimum;
  double Maximum;
  std::string Reason;
};

/**
 * Work on an input of one size.
 */
struct Job
{
  /// Uses a new filter, so that no memory is retained between runs.
  BenchWork Work;
  /// Returns N. Call it after an execution of Work.
  std::function<double()> GetN;
  double InputKib = 0.0;
};

/**
 * A quantity N on which costs depend.
 */
struct Quantity
{
  /// Case of its rows.
  std::string Name;
  /// Arguments of Make, in ascending order.
  std::vector<int> Sizes;
  /// Expected growth of the processor time of all threads.
  Theory Time;
  Theory Memory;
  std::function<Job(int size, const BenchOptions& options)> Make;
};

/// Returns all quantities, with the sizes of \a options, in the order of the report.
std::vector<Quantity> MakeQuantities(const BenchOptions& options);

/// Names of the methods of rows: a single size, the exponent of processor time, the exponent of
/// memory in KiB.
extern const char* const SizeMethod;
extern const char* const TimeExponent;
extern const char* const MemoryExponent;

/// Largest acceptable deviation of a fitted exponent from the theory.
constexpr double Margin = 0.15;
/// Amounts of memory below this are due to allocator pages. The fit replaces them with this amount.
constexpr double MinimumKib = 64.0;

/**
 * Creates the row of a size. Counts: `n`, which is also the parameter, `input_kib`,
 * `processor_seconds` and, if the system reports memory, `kib`.
 */
BenchRow MakeSizeRow(const BenchRows& rows, const Quantity& quantity,
  const nlohmann::ordered_json& found, const BenchOptions& options);

/**
 * Adds the fitted exponents of \a quantity, from its rows in \a rows, if there are at least two
 * sizes. The parameter is Theory::Reason. Counts:
 * - `exponent`: the slope of a least-squares line through the logarithms;
 * - `least` and `most`: the theoretical exponents;
 * - `sizes`: the number of sizes;
 * - `factor`: the largest n divided by the smallest.
 */
void AddExponentRows(const Quantity& quantity, BenchRows& rows);

/**
 * Returns the claims that all exponents of time and memory are within Margin of the theory.
 */
std::vector<BenchClaim> CheckExponents(const std::vector<BenchRow>& rows);
}

#endif
