// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Costs/CostRows.h"

#include "Benchmarks/Measures/BenchTiming.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace costs
{
namespace
{
/// The counts that are 0 of a feature that is off.
const std::vector<std::string> Counters = { "passes", "buffers", "bytes", "words", "arrays",
  "own" };

/// The rows that a summary is made of.
using Group = std::vector<BenchRow>;

bool IsOfFeature(const BenchRow& row)
{
  return !row.Parameter.is_null() && row.Case != AllScenes;
}

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

/// The number with the largest magnitude.
double GetLargest(const std::vector<double>& numbers)
{
  return numbers.empty() ? 0.0
                         : *std::max_element(numbers.begin(), numbers.end(),
                             [](double a, double b) { return std::abs(a) < std::abs(b); });
}

/// What is left of features that are off.
void SetLeft(BenchRow& row, const Group& group)
{
  for (const std::string& name : Counters)
  {
    row.Counts[name] = GetLargest(GetCounts(group, name));
  }
  const std::vector<double> within = GetCounts(group, "within_noise");
  if (within.empty())
  {
    return;
  }
  row.Set({ { "ms", Median(GetCounts(group, "ms")) },
    { "ms_largest", GetLargest(GetCounts(group, "ms")) },
    { "noise_ms", Median(GetCounts(group, "noise_ms")) }, { "timed", within.size() },
    { "within_noise", std::count(within.begin(), within.end(), 1.0) } });
}

BenchRow OfFeature(BenchRow row, const Group& group)
{
  row.Case = AllScenes;
  row.Seconds.reset();
  row.Counts = { { "scenes", group.size() } };
  SetLeft(row, group);
  for (const std::string& name : Counters)
  {
    row.Counts["on_" + name] = Median(GetCounts(group, "on_" + name));
  }
  if (row.Counts.contains("ms"))
  {
    row.Counts["on_ms"] = Median(GetCounts(group, "on_ms"));
  }
  return row;
}

BenchRow OfScene(BenchRow row, const Group& group)
{
  row.Method = AllFeatures;
  row.Parameter = nullptr;
  row.Seconds.reset();
  row.Counts = { { "features", group.size() } };
  SetLeft(row, group);
  return row;
}

/// \a all: its rows, also those of scenes that say that they do not execute it.
BenchRow OfClass(BenchRow row, const Group& all, std::size_t scenes)
{
  Group group;
  std::copy_if(all.begin(), all.end(), std::back_inserter(group),
    [](const BenchRow& one) { return one.Counts.value("executions", 0) > 0; });
  row.Case = AllScenes;
  std::vector<double> seconds;
  for (const BenchRow& one : group)
  {
    seconds.push_back(*one.Seconds);
  }
  row.Seconds.reset();
  if (!seconds.empty())
  {
    row.Seconds = MedianOf(seconds);
  }
  row.Counts = { { "scenes", group.size() }, { "others", scenes - group.size() } };
  for (const char* name : { "executions", "arrays", "bytes" })
  {
    row.Counts[name] = Median(GetCounts(group, name));
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
    if (!IsOfFeature(row))
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

double GetMostLeft(const BenchRow& row)
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
const char* const AllFeatures = "all features";

std::vector<BenchRow> Summarise(const std::vector<BenchRow>& rows)
{
  std::set<std::string> scenes;
  std::map<std::pair<std::string, std::string>, Group> features;
  std::map<std::string, Group> classes;
  std::vector<Group> ofScenes;
  for (const BenchRow& row : rows)
  {
    if (scenes.insert(row.Case).second)
    {
      ofScenes.emplace_back();
    }
    if (IsOfFeature(row))
    {
      features[{ row.Method, row.GetParameterText() }].push_back(row);
      ofScenes.back().push_back(row);
    }
    else
    {
      classes[row.Method].push_back(row);
    }
  }
  std::vector<BenchRow> summaries;
  for (const auto& feature : features)
  {
    summaries.push_back(OfFeature(feature.second.front(), feature.second));
  }
  for (const auto& one : classes)
  {
    summaries.push_back(OfClass(one.second.front(), one.second, scenes.size()));
  }
  for (const Group& group : ofScenes)
  {
    if (!group.empty())
    {
      summaries.push_back(OfScene(group.front(), group));
    }
  }
  return summaries;
}

std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows)
{
  const auto ms = [](const BenchRow& row) { return GetLargest(GetCounts({ row }, "ms")); };
  const auto isWithin = [](const BenchRow& row)
  { return row.Counts.value("within_noise", 1) != 0; };
  return { MakeClaim("a feature that is off has no pass, buffer, byte, word of a shader or array",
             rows, &GetMostLeft, [](const BenchRow& row) { return GetMostLeft(row) == 0.0; }),
    MakeClaim("a feature that is off takes no time, ms, but for noise", rows, ms, isWithin) };
}
}
