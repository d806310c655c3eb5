// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchClaim_h
#define BenchClaim_h

#include "Benchmarks/Results/BenchRow.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/**
 * A target for a number in every case of a suite, and the measured numbers.
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

  /// Returns true if the target is met in every case.
  bool IsMet() const;

  /// Returns an object with the fields `text`, `met` and `cases`. Each case has the fields `case`,
  /// `number` and `met`.
  nlohmann::ordered_json ToJson() const;

  /**
   * Returns the claim that \a number of every row is at least, or at most, \a bound. Rows for which
   * \a number is empty are excluded. The names of cases include the method, parameter and baseline
   * if rows differ in them.
   */
  static BenchClaim AtLeast(const std::string& text, double bound,
    const std::vector<BenchRow>& rows,
    const std::function<std::optional<double>(const BenchRow&)>& number);
  static BenchClaim AtMost(const std::string& text, double bound, const std::vector<BenchRow>& rows,
    const std::function<std::optional<double>(const BenchRow&)>& number);
};

/**
 * Returns a function for AtLeast() and AtMost() that returns the ratio of a row with this method,
 * this baseline and one thread, and std::nullopt for other rows.
 */
std::function<std::optional<double>(const BenchRow&)> RatioWithOneThread(
  const std::string& method, const std::string& baseline);

/**
 * Returns a function for AtLeast() and AtMost() that returns the ratio of a row with this method,
 * and std::nullopt for other rows.
 */
std::function<std::optional<double>(const BenchRow&)> RatioOf(const std::string& method);

/**
 * Returns a function for AtLeast() and AtMost() that returns a count of a row with this method, and
 * std::nullopt for other rows or if the count is missing.
 */
std::function<std::optional<double>(const BenchRow&)> CountOf(
  const std::string& method, const std::string& count);

#endif
