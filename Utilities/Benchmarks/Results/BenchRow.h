// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchRow_h
#define BenchRow_h

#include "Benchmarks/Measures/BenchSeconds.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

/**
 * One measurement. What does not apply stays empty and is absent from the JSON.
 */
struct BenchRow
{
  std::string Suite;
  std::string Case;
  std::string Method;
  /// A number or a short text; null for none.
  nlohmann::ordered_json Parameter;
  std::optional<double> Error;
  /// What Error is, with its unit.
  std::string ErrorNorm;
  /// Wall time: the median of its runs.
  std::optional<BenchSeconds> Seconds;
  /// What Seconds is compared with, measured alternately in the same run.
  std::string Peer;
  std::optional<BenchSeconds> PeerSeconds;
  /// Named numbers.
  nlohmann::ordered_json Counts = nlohmann::ordered_json::object();

  void SetTimes(
    const BenchSeconds& seconds, const std::string& peer, const BenchSeconds& peerSeconds);
  void SetError(const std::string& norm, double error);
  /// Sets some of the counts.
  void Set(const nlohmann::ordered_json& counts) { this->Counts.update(counts); }

  /// The parameter in words: text as it is, a real number by six digits, anything else as JSON.
  std::string GetParameterText() const;

  /// PeerSeconds / Seconds: above 1 the method is faster than the peer.
  std::optional<double> GetRatio() const;

  /// With \a hasSpans also when each run began and ended.
  nlohmann::ordered_json ToJson(bool hasSpans = false) const;
  /// Throws nlohmann::json::exception where a field is missing or of the wrong type.
  static BenchRow FromJson(const nlohmann::ordered_json& json);
};

/**
 * The rows of one suite; a row is printed as it comes, so that a long run shows where it is.
 */
class BenchRows
{
public:
  explicit BenchRows(const std::string& suite);

  /**
   * A row with the suite, case, method and parameter filled in.
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
