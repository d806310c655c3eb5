// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Ranks/RankRows.h"

#include "Benchmarks/Results/BenchMachine.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace ranks
{
namespace
{
const char* const Weak = "weak scaling";
const char* const Strong = "memory";

double GetMean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Returns \a count from the single-process row with the same case and method as \a like, or 0 if
/// there is no such row.
double GetOfOne(const std::vector<BenchRow>& rows, const BenchRow& like, const char* count)
{
  const auto found = std::find_if(rows.begin(), rows.end(),
    [&](const BenchRow& row)
    { return row.Case == like.Case && row.Method == like.Method && row.Parameter == 1; });
  return found == rows.end() ? 0.0 : found->Counts.value(count, 0.0);
}

void SetRatio(BenchRow& row, const char* name, double value, double over)
{
  if (value > 0.0 && over > 0.0)
  {
    row.Counts[name] = value / over;
  }
}
}

BenchRow MakeWeakRow(const BenchRows& rows, const std::string& theCase, const Times& times)
{
  BenchRow row = rows.Make(theCase, Weak, times.ProcessorSeconds.size());
  row.Seconds = { times.Seconds, times.Runs };
  row.Set({ { "processor_seconds", GetMean(times.ProcessorSeconds) },
    { "most_processor_seconds",
      *std::max_element(times.ProcessorSeconds.begin(), times.ProcessorSeconds.end()) },
    { "work", GetMean(times.Work) } });
  return row;
}

BenchRow MakeMemoryRow(
  const BenchRows& rows, const std::string& theCase, int ranks, const std::vector<double>& kib)
{
  BenchRow row = rows.Make(theCase, Strong, ranks);
  if (!kib.empty())
  {
    row.Counts["kib"] = *std::max_element(kib.begin(), kib.end());
  }
  return row;
}

BenchResults Join(const std::vector<BenchResults>& runs)
{
  BenchResults all = runs.front();
  all.Rows.clear();
  std::vector<nlohmann::ordered_json> conditions;
  double took = 0.0;
  for (const BenchResults& run : runs)
  {
    const std::vector<BenchRow> rows = run.RowsOf(Suite);
    all.Rows.insert(all.Rows.end(), rows.begin(), rows.end());
    conditions.push_back(run.Conditions);
    took += run.Suites.at(Suite).at("took").get<double>();
  }
  all.Conditions = JoinConditions(conditions);
  all.Suites[Suite]["took"] = took;
  for (BenchRow& row : all.Rows)
  {
    if (row.Method == Weak)
    {
      SetRatio(row, "efficiency", GetOfOne(all.Rows, row, "processor_seconds"),
        row.Counts.at("processor_seconds"));
    }
    else
    {
      SetRatio(row, "share", row.Counts.value("kib", 0.0), GetOfOne(all.Rows, row, "kib"));
    }
  }
  std::stable_sort(all.Rows.begin(), all.Rows.end(),
    [](const BenchRow& a, const BenchRow& b)
    { return std::tie(a.Method, a.Case) < std::tie(b.Method, b.Case); });
  return all;
}
}
