// SPDX-License-Identifier: BSD-3-Clause
#ifndef Growth_h
#define Growth_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Suites/BenchSuite.h"

#include <functional>
#include <string>
#include <vector>

/**
 * Suite `growth`: measures how time and memory grow with N, such as the number of cells.
 */
namespace growth
{
/**
 * Expected exponent p of a cost that grows as N^p, and the reason for it. Minimum and Maximum
 * differ if two terms contribute to the cost.
 */
struct Theory
{
  double Minimum;
  double Maximum;
  std::string Reason;
};

/**
 * Work on an input of a given size.
 */
struct Job
{
  /// Uses a new filter, so that no memory is retained between runs.
  BenchWork Work;
  /// Returns N. Call it after Work.
  std::function<double()> GetN;
  double InputKib = 0.0;
};

/**
 * A quantity N on which time and memory depend.
 */
struct Quantity
{
  /// Name of the quantity, and case of its rows.
  std::string Name;
  /// Arguments of Make, in ascending order.
  std::vector<int> Sizes;
  /// Expected growth of the processor time of all threads.
  Theory Time;
  Theory Memory;
  std::function<Job(int size, const BenchOptions& options)> Make;
};

/// Returns all quantities in the order of the report. \a options determine their sizes.
std::vector<Quantity> MakeQuantities(const BenchOptions& options);

/// Methods of rows: costs at a single size, the exponent of the processor time, and the exponent of
/// the memory.
extern const char* const SizeMethod;
extern const char* const TimeExponent;
extern const char* const MemoryExponent;

/// Largest acceptable deviation of a fitted exponent from the theory.
constexpr double Margin = 0.15;
/// Lower limit of memory in the fit. Smaller amounts depend on the page size of the allocator.
constexpr double MinimumKib = 64.0;

/**
 * Returns a row with the costs \a found at one size. The parameter is N. Counts: `n`, `input_kib`,
 * `processor_seconds` and, if the system reports memory, `kib`.
 */
BenchRow MakeSizeRow(const BenchRows& rows, const Quantity& quantity,
  const nlohmann::ordered_json& found, const BenchOptions& options);

/**
 * Adds rows with the exponents of time and memory, fitted to the rows of \a quantity in \a rows, if
 * there are at least two sizes. The parameter is Theory::Reason. Counts:
 * - `exponent`: the slope of a least-squares line in the log-log plot;
 * - `least` and `most`: the minimum and maximum exponents in theory;
 * - `sizes`: the number of sizes;
 * - `factor`: the largest n divided by the smallest.
 */
void AddExponentRows(const Quantity& quantity, BenchRows& rows);

/**
 * Returns the claims that all fitted exponents deviate from the theory by at most Margin.
 */
std::vector<BenchClaim> CheckExponents(const std::vector<BenchRow>& rows);
}

#endif
