// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Costs/CostRows.h"

#include "Benchmarks/Measures/BenchTiming.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace costs
{
namespace
{
/// Counts that must be 0 for a feature that is off.
const std::vector<std::string> Counters = { "passes", "buffers", "bytes", "words", "arrays",
  "own" };

/// Rows of one feature in several scenes.
using Group = std::vector<BenchRow>;

std::vector<double> GetCounts(const Group& group, const std::string& name)
{
  std::vector<double> counts;
  for (const BenchRow& row : group)
  {
    if (row.Counts.contains(name))
    {
      counts.push_back(row.Counts[name].get<double>());
    }
  }
  return counts;
}

/// Returns the number with the largest magnitude.
double GetLargest(const std::vector<double>& numbers)
{
  return numbers.empty() ? 0.0
                         : *std::max_element(numbers.begin(), numbers.end(),
                             [](double a, double b) { return std::abs(a) < std::abs(b); });
}

BenchRow OfFeature(BenchRow row, const Group& group)
{
  row.Case = AllScenes;
  row.Seconds.reset();
  row.Counts = { { "scenes", group.size() } };
  for (const std::string& name : Counters)
  {
    row.Counts[name] = GetLargest(GetCounts(group, name));
  }
  const std::vector<double> within = GetCounts(group, "within_noise");
  if (!within.empty())
  {
    row.Set({ { "ms", Median(GetCounts(group, "ms")) },
      { "ms_largest", GetLargest(GetCounts(group, "ms")) },
      { "noise_ms", Median(GetCounts(group, "noise_ms")) }, { "timed", within.size() },
      { "within_noise", std::count(within.begin(), within.end(), 1.0) } });
  }
  for (const std::string& name : Counters)
  {
    row.Counts["on_" + name] = Median(GetCounts(group, "on_" + name));
  }
  if (!within.empty())
  {
    row.Counts["on_ms"] = Median(GetCounts(group, "on_ms"));
  }
  return row;
}

BenchClaim MakeClaim(const std::string& text, const std::vector<BenchRow>& rows,
  const std::function<double(const BenchRow&)>& number,
  const std::function<bool(const BenchRow&)>& isMet)
{
  BenchClaim claim;
  claim.Text = text;
  int met = 0;
  for (const BenchRow& row : rows)
  {
    if (row.Case == AllScenes)
    {
      continue;
    }
    if (isMet(row))
    {
      ++met;
    }
    else
    {
      claim.Cases.push_back(
        { row.Case + ": " + row.Method + " " + row.GetParameterText(), number(row), false });
    }
  }
  claim.Cases.push_back({ "features that scenes do not use", static_cast<double>(met), true });
  return claim;
}

double GetLargestRemainder(const BenchRow& row)
{
  std::vector<double> left;
  for (const std::string& name : Counters)
  {
    left.push_back(GetLargest(GetCounts({ row }, name)));
  }
  return GetLargest(left);
}
}

const char* const Suite = "scene-costs";
const char* const AllScenes = "all scenes";

std::vector<BenchRow> Summarize(const std::vector<BenchRow>& rows)
{
  std::map<std::pair<std::string, std::string>, Group> features;
  for (const BenchRow& row : rows)
  {
    features[{ row.Method, row.GetParameterText() }].push_back(row);
  }
  std::vector<BenchRow> summaries;
  for (const auto& feature : features)
  {
    summaries.push_back(OfFeature(feature.second.front(), feature.second));
  }
  return summaries;
}

std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows)
{
  const auto ms = [](const BenchRow& row) { return GetLargest(GetCounts({ row }, "ms")); };
  const auto isWithin = [](const BenchRow& row)
  { return row.Counts.value("within_noise", 1) != 0; };
  return { MakeClaim("a feature that is off has no pass, buffer, byte, word of a shader or array",
             rows, &GetLargestRemainder,
             [](const BenchRow& row) { return GetLargestRemainder(row) == 0.0; }),
    MakeClaim("a feature that is off takes no time, ms, but for noise", rows, ms, isWithin) };
}
}
