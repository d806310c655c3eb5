// SPDX-License-Identifier: BSD-3-Clause
#ifndef Growth_h
#define Growth_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Suites/BenchSuite.h"

#include <functional>
#include <string>
#include <vector>

/**
 * What the suite `growth` measures: cost against N.
 */
namespace growth
{
/**
 * The exponent of N that is expected, from Least to Most if two terms share the cost, and why.
 */
struct Theory
{
  double Least;
  double Most;
  std::string Reason;
};

/**
 * The work of one size, with its input made.
 */
struct Job
{
  /// By a filter made anew, so that no memory is retained from run to run.
  BenchWork Work;
  /// N, known after an execution at the latest.
  std::function<double()> GetN;
  double InputKib = 0.0;
};

/**
 * Something that cost grows with.
 */
struct Quantity
{
  /// The case of its rows.
  std::string Name;
  /// What Make is called with, from the smallest.
  std::vector<int> Sizes;
  /// Of the processor time of all threads.
  Theory Time;
  Theory Memory;
  std::function<Job(int size, const BenchOptions& options)> Make;
};

/// Every quantity, with the sizes of \a options, in the order of the report.
std::vector<Quantity> MakeQuantities(const BenchOptions& options);

/// The methods of rows: of one size, and of the exponents of processor time and of KiB.
extern const char* const SizeMethod;
extern const char* const TimeExponent;
extern const char* const MemoryExponent;

/// How far a fitted exponent may be from theory's.
constexpr double Margin = 0.15;
/// Memory below this is the pages of the allocator, and is fitted as this.
constexpr double LeastKib = 64.0;

/**
 * The row of a size: `n`, which is its parameter, `input_kib`, `seconds`, `processor_seconds` and,
 * if the system reports memory, `kib`.
 */
BenchRow MakeSizeRow(const BenchRows& rows, const Quantity& quantity,
  const nlohmann::ordered_json& found, const BenchOptions& options);

/**
 * Adds the fitted exponents of \a quantity, from its rows among \a rows, if there are two sizes:
 * the reason of theory's is the parameter; counts `exponent`, the slope of a line through the
 * logarithms by least squares; `least` and `most`, theory's; `sizes`, how many were fitted; and
 * `factor`, the largest n over the smallest.
 */
void AddExponentRows(const Quantity& quantity, BenchRows& rows);

/**
 * The claims that every exponent, of time and memory, is within Margin of theory's.
 */
std::vector<BenchClaim> CheckExponents(const std::vector<BenchRow>& rows);
}

#endif
