// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchClaim_h
#define BenchClaim_h

#include "Benchmarks/Results/BenchRow.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

/**
 * Something a suite wants to be true of a number in every case, and what was measured.
 */
struct BenchClaim
{
  struct Measured
  {
    std::string Case;
    double Number;
    bool Met;
  };

  /// With the bound, such as "at least 3 times faster than clip2, 1 thread".
  std::string Text;
  std::vector<Measured> Cases;

  /// Whether it is so in every case.
  bool IsMet() const;

  /// text, met and cases, each with case, number and met.
  nlohmann::ordered_json ToJson() const;

  /**
   * The claim that \a number of every row is at least, or at most, \a bound; rows of which \a
   * number is nothing are not concerned. Rows of one case are told apart by method,
   * parameter and peer.
   */
  static BenchClaim AtLeast(const std::string& text, double bound,
    const std::vector<BenchRow>& rows,
    const std::function<std::optional<double>(const BenchRow&)>& number);
  static BenchClaim AtMost(const std::string& text, double bound, const std::vector<BenchRow>& rows,
    const std::function<std::optional<double>(const BenchRow&)>& number);
};

/**
 * A function for the above: the ratio of the rows of that method and peer with one thread.
 */
std::function<std::optional<double>(const BenchRow&)> RatioWithOneThread(
  const std::string& method, const std::string& peer);

/**
 * Likewise: the ratio of all rows of that method.
 */
std::function<std::optional<double>(const BenchRow&)> RatioOf(const std::string& method);

/**
 * Likewise: a count of the rows of that method that have it.
 */
std::function<std::optional<double>(const BenchRow&)> CountOf(
  const std::string& method, const std::string& count);

#endif
