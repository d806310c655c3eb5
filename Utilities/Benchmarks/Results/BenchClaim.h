// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchClaim_h
#define BenchClaim_h

#include "Benchmarks/Results/BenchRow.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/**
 * A bound that a measured number should satisfy in every case of a suite, and the numbers.
 */
struct BenchClaim
{
  struct Measured
  {
    std::string Case;
    double Number;
    bool Met;
  };

  /// Text that states the bound, such as "at least 3 times faster than clip2, 1 thread".
  std::string Text;
  std::vector<Measured> Cases;

  /// Returns true if the bound is satisfied in every case.
  bool IsMet() const;

  /// Returns a JSON object with the fields `text`, `met` and `cases`. Each case has the fields
  /// `case`, `number` and `met`.
  nlohmann::ordered_json ToJson() const;

  /**
   * Returns the claim that \a number(row) is at least, or at most, \a bound for every row. Rows for
   * which it is empty are excluded. The names of cases include the method, parameter and baseline
   * if rows of the same case differ in them.
   */
  static BenchClaim AtLeast(const std::string& text, double bound,
    const std::vector<BenchRow>& rows,
    const std::function<std::optional<double>(const BenchRow&)>& number);
  static BenchClaim AtMost(const std::string& text, double bound, const std::vector<BenchRow>& rows,
    const std::function<std::optional<double>(const BenchRow&)>& number);
};

/**
 * Returns a function for AtLeast() and AtMost(). It returns the ratio of a row with this method,
 * this baseline and one thread, and std::nullopt for other rows.
 */
std::function<std::optional<double>(const BenchRow&)> RatioWithOneThread(
  const std::string& method, const std::string& baseline);

/**
 * Returns a function for AtLeast() and AtMost(). It returns the ratio of a row with this method,
 * and std::nullopt for other rows.
 */
std::function<std::optional<double>(const BenchRow&)> RatioOf(const std::string& method);

/**
 * Returns a function for AtLeast() and AtMost(). It returns the given count of a row with this
 * method, and std::nullopt for other rows or if the count is missing.
 */
std::function<std::optional<double>(const BenchRow&)> CountOf(
  const std::string& method, const std::string& count);

#endif
