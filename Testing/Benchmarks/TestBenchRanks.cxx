// SPDX-License-Identifier: BSD-3-Clause
// Tests combined results of runs with several numbers of processes, on synthetic rows.
#include "Benchmarks/Ranks/RankRows.h"
#include "Support/Checks/ReferenceCheck.h"

#include <string>
#include <vector>

namespace
{
/// Returns the results of a run whose processes have the given run times and memory sizes.
BenchResults MakeRun(const std::vector<double>& seconds, const std::vector<double>& kib)
{
  const int number = static_cast<int>(seconds.size());
  BenchResults run;
  run.Conditions = { { "date", "2026-01-0" + std::to_string(number) },
    { "command", "mpiexec -n " + std::to_string(number) } };
  run.Suites[ranks::Suite]["took"] = 5.0;
  BenchRows rows(ranks::Suite);
  const ranks::Times times{ 9.0, 3, seconds, std::vector<double>(seconds.size(), 40.0) };
  rows.Add(ranks::MakeWeakRow(rows, "flow", times));
  rows.Add(ranks::MakeMemoryRow(rows, "flow", number, kib));
  run.Rows = rows.Get();
  return run;
}

double Get(const BenchResults& results, const std::string& method, int ranks, const char* count)
{
  for (const BenchRow& row : results.Rows)
  {
    if (row.Method == method && row.Parameter == ranks)
    {
      return row.Counts.value(count, -1.0);
    }
  }
  return -2.0;
}
}

int main()
{
  reference::Check check;
  const std::vector<BenchResults> runs = { MakeRun({ 3.0 }, { 800.0 }),
    MakeRun({ 4.0, 8.0 }, { 300.0, 600.0 }) };
  const BenchResults joined = ranks::Join(runs);
  constexpr double tolerance = 1e-12;
  check.Near(Get(joined, "weak scaling", 1, "efficiency"), 1.0, tolerance, "efficiency of one");
  check.Near(Get(joined, "weak scaling", 2, "efficiency"), 0.5, tolerance, "efficiency of two");
  check.Near(Get(joined, "weak scaling", 2, "most_processor_seconds"), 8.0, tolerance,
    "time of the slowest process");
  check.Near(Get(joined, "weak scaling", 2, "work"), 40.0, tolerance, "work");
  check.Near(Get(joined, "memory", 2, "share"), 0.75, tolerance, "fraction of the largest process");
  check.That(joined.Conditions.at("parts").size() == 2, "conditions of both runs");
  check.Near(joined.Suites.at(ranks::Suite).at("took").get<double>(), 10.0, tolerance, "took");

  const BenchResults unknown = ranks::Join({ MakeRun({ 3.0 }, {}) });
  check.Near(Get(unknown, "memory", 1, "kib"), -1.0, 0.0, "unknown memory is omitted");
  check.Near(Get(unknown, "memory", 1, "share"), -1.0, 0.0, "its fraction is omitted");
  return check.Result();
}
