// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchRow_h
#define BenchRow_h

#include "Benchmarks/Measures/BenchSeconds.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

/**
 * One measurement. Members that do not apply are empty and omitted from the JSON object.
 */
struct BenchRow
{
  std::string Suite;
  std::string Case;
  std::string Method;
  /// A number, a short string, or null.
  nlohmann::ordered_json Parameter;
  std::optional<double> Error;
  /// Definition of Error, such as "volume, relative".
  std::string ErrorNorm;
  /// Wall time: the median of all runs.
  std::optional<BenchSeconds> Seconds;
  /// Name of the baseline, which runs alternately with the method.
  std::string Baseline;
  std::optional<BenchSeconds> BaselineSeconds;
  /// Counts and other named numbers.
  nlohmann::ordered_json Counts = nlohmann::ordered_json::object();

  void SetTimes(
    const BenchSeconds& seconds, const std::string& baseline, const BenchSeconds& baselineSeconds);
  void SetError(const std::string& norm, double error);
  /// Adds counts. Existing counts with the same names are overwritten.
  void Set(const nlohmann::ordered_json& counts) { this->Counts.update(counts); }

  /// Returns the parameter as a string: strings unchanged, floating-point numbers with six
  /// significant digits, and other values as JSON.
  std::string GetParameterText() const;

  /// Returns BaselineSeconds / Seconds, which is above 1 if the method is faster than the baseline.
  std::optional<double> GetRatio() const;

  /// Converts to JSON, including the start and end of each run if \a hasSpans is set.
  nlohmann::ordered_json ToJson(bool hasSpans = false) const;
  /// Throws nlohmann::json::exception if a field is missing or of the wrong type.
  static BenchRow FromJson(const nlohmann::ordered_json& json);
};

/**
 * Rows of one suite. Each row is printed when it is added, to show the progress of long runs.
 */
class BenchRows
{
public:
  explicit BenchRows(const std::string& suite);

  /**
   * Returns a row in which only the suite, case, method and parameter are set.
   */
  BenchRow Make(const std::string& theCase, const std::string& method,
    const nlohmann::ordered_json& parameter = nullptr) const;
  void Add(BenchRow row);
  const std::vector<BenchRow>& Get() const { return this->Rows; }

private:
  std::string Suite;
  std::vector<BenchRow> Rows;
};

#endif
