// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/ResidentMemory.h"
#include "Benchmarks/SpaceTime/Interval4dCases.h"

#include "SpaceTime/SpaceTimeTable.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include <limits>

namespace interval4d
{
namespace
{
const char* const FreshTask = "fresh";
const char* const LaterSlabsTask = "later-slabs";

/// Number of kinds (cases up to symmetry) and bytes of all case tables in this process.
struct TableCounts
{
  std::uint64_t Kinds = 0;
  std::uint64_t Bytes = 0;

  static TableCounts Get()
  {
    TableCounts counts;
    for (int shape = 0; shape < interlume::SpaceTimeTable::NumberOfShapes; ++shape)
    {
      const auto& table = interlume::SpaceTimeTable::Get(static_cast<vtkIsotable::Shapes>(shape));
      counts.Kinds += table.GetNumberOfSymmetryClasses();
      counts.Bytes += table.GetBytes();
    }
    return counts;
  }
};

vtkIdType Count(vtkTimeVaryingIntervalVolume* filter, const char* name)
{
  return filter->GetReport()->GetCount(name);
}

/// Returns counts of the table lookups in the last execution of \a filter. \a before is the size of
/// the tables before that execution.
nlohmann::ordered_json CountLookups(vtkTimeVaryingIntervalVolume* filter, const TableCounts& before)
{
  const TableCounts after = TableCounts::Get();
  const double lookups = filter->GetReport()->GetNumber("TableLookups");
  nlohmann::ordered_json json;
  json["simplices"] = Count(filter, "Simplices");
  json["lookups"] = Count(filter, "TableLookups");
  json["cases_made"] = Count(filter, "TableCasesComputed");
  json["kinds_made"] = after.Kinds - before.Kinds;
  json["hit_share"] = 1.0 - filter->GetReport()->GetNumber("TableCasesComputed") / lookups;
  json["kind_hit_share"] = 1.0 - static_cast<double>(after.Kinds - before.Kinds) / lookups;
  json["table_kib"] = after.Bytes / 1024;
  return json;
}

nlohmann::ordered_json CountMemory(const Case& what)
{
  ResetPeakMemory();
  const std::optional<long> before = ResidentKib();
  auto filter = what.NewFilter();
  filter->Update();
  const std::optional<long> peak = PeakResidentKib();

  const auto steps = static_cast<long>(
    what.Steps->GetStep(0)->GetActualMemorySize() + what.Steps->GetStep(1)->GetActualMemorySize());
  const auto output = static_cast<long>(filter->GetOutputDataObject(0)->GetActualMemorySize());
  nlohmann::ordered_json json;
  json["steps"] = what.Steps->GetNumberOfSteps();
  json["simplices"] = Count(filter, "Simplices");
  json["steps_kib"] = steps;
  json["output_kib"] = output;
  json["working_kib"] = Count(filter, "WorkingBytes") / 1024;
  if (before && peak)
  {
    const long growth = *peak - *before;
    json["peak_kib"] = steps + growth;
    json["peak_share"] = static_cast<double>(steps + growth) / static_cast<double>(steps + output);
  }
  return json;
}

/// Measures everything that requires a process with empty case tables.
nlohmann::ordered_json MeasureFresh(const std::string& theCase, const BenchOptions& options)
{
  const Case what = MakeCase(theCase, options);
  vtkSmartPointer<vtkTimeVaryingIntervalVolume> filter;
  const BenchWork work = WithThreads(1,
    [&]()
    {
      filter = what.NewFilter();
      filter->Update();
      return filter;
    });
  nlohmann::ordered_json json;
  json["cold"] = TimeOnce(work).Value;
  json["table"] = CountLookups(filter, TableCounts());
  json["warm"] = MeasureAlternately({ work }, options.GetRepeats()).front().Value;
  filter = nullptr;
  json["memory"] = CountMemory(what);
  return json;
}

/// Processes the first slab, then the remaining slabs, and returns the table counts of the
/// remaining slabs.
nlohmann::ordered_json MeasureLaterSlabs(const std::string& theCase, const BenchOptions& options)
{
  const Case what = MakeCase(theCase, options);
  auto filter = what.NewFilter();
  filter->SetTimeStepRange(0, 1);
  filter->Update();
  const TableCounts before = TableCounts::Get();
  filter->SetTimeStepRange(1, std::numeric_limits<int>::max());
  filter->Update();
  return CountLookups(filter, before);
}

/**
 * Adds rows for every case:
 * - method `cold`, with one thread: the first execution in a new process. The baseline `warm` is a
 *   later execution. `hit_share` is the fraction of table lookups that found their case.
 *   `kind_hit_share` is the fraction of lookups that found the case or a symmetric case, so that no
 *   convex hull had to be computed;
 * - method `later-slabs`, for cases with three or more time steps: the lookups of all slabs except
 *   the first, in a process that has processed only the first slab before;
 * - method `memory`, with filled tables: `steps_kib` is the size of two time steps, `output_kib` is
 *   the size of the output, and `working_kib` is reported by the filter. `peak_kib` is `steps_kib`
 *   plus the largest growth of the resident memory of the process. `peak_share` is `peak_kib`
 *   divided by the sum of `steps_kib` and `output_kib`. `peak_kib` and `peak_share` are absent if
 *   the system does not report resident memory.
 */
void AddFreshRows(const BenchOptions& options, BenchRows& rows)
{
  std::vector<BenchRow> laterSlabs;
  std::vector<BenchRow> memory;
  for (const std::string& name : GetCaseNames(options))
  {
    const nlohmann::ordered_json found = RunChild("interval4d", FreshTask + (" " + name), options);
    BenchRow row = rows.Make(name, "cold");
    row.SetTimes({ found.at("cold").get<double>(), 1 }, "warm",
      { found.at("warm").get<double>(), options.GetRepeats() });
    row.Counts = found.at("table");
    rows.Add(row);
    memory.push_back(rows.Make(name, "memory"));
    memory.back().Counts = found.at("memory");
    if (memory.back().Counts["steps"] > 2)
    {
      laterSlabs.push_back(rows.Make(name, "later-slabs"));
      laterSlabs.back().Counts = RunChild("interval4d", LaterSlabsTask + (" " + name), options);
    }
  }
  for (const std::vector<BenchRow>& more : { laterSlabs, memory })
  {
    for (const BenchRow& row : more)
    {
      rows.Add(row);
    }
  }
}

std::vector<BenchClaim> CheckFreshClaims(const std::vector<BenchRow>& rows)
{
  const auto cold = [](const BenchRow& row)
  { return row.Method == "cold" && row.Case == ClaimedCase ? row.Seconds : std::nullopt; };
  return { BenchClaim::AtMost("cold table, 1 thread: at most 1 s", 1.0, rows, cold),
    BenchClaim::AtLeast("at least 99 % of the lookups after the first slab find their case", 0.99,
      rows, CountOf("later-slabs", "hit_share")),
    BenchClaim::AtLeast("at least 99 % of them find their kind", 0.99, rows,
      CountOf("later-slabs", "kind_hit_share")),
    BenchClaim::AtMost("peak memory at most 1.5 times two time steps and the output", 1.5, rows,
      CountOf("memory", "peak_share")) };
}
}

BenchPart MakeFreshPart()
{
  return { AddFreshRows, nullptr, CheckFreshClaims,
    { { FreshTask, MeasureFresh }, { LaterSlabsTask, MeasureLaterSlabs } } };
}
}
