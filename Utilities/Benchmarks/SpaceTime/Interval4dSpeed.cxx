// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/SecondThread.h"
#include "Benchmarks/SpaceTime/Interval4dCases.h"

#include "vtkTimeVaryingIntervalVolume.h"

#include "vtkUnstructuredGrid.h"

namespace interval4d
{
namespace
{
BenchWork Extraction(const Case& what)
{
  return [&what]()
  {
    auto filter = what.NewFilter();
    filter->Update();
    return vtkSmartPointer<vtkObjectBase>(filter->GetOutput());
  };
}

void AddWarmRows(const Case& what, const BenchOptions& options, BenchRows& rows)
{
  const BenchWork work = Extraction(what);
  auto filter = what.NewFilter();
  filter->Update();
  const auto steps = static_cast<int>(filter->GetReport()->GetNumber("TimeSteps"));
  const auto simplices = filter->GetReport()->GetCount("Simplices");
  for (int threads : options.GetThreadCounts())
  {
    BenchRow row = rows.Make(what.Name, "warm", ThreadsParameter(threads));
    row.Seconds = MeasureAlternately({ WithThreads(threads, work) }, options.GetRepeats()).front();
    row.Set({ { "threads", threads }, { "steps", steps }, { "cells", what.GetNumberOfCells() },
      { "lower", what.Lower }, { "upper", what.Upper }, { "simplices", simplices },
      { "tetrahedra", filter->GetOutput()->GetNumberOfCells() } });
    if (what.Stated)
    {
      row.Set({ { "stated_simplices", what.Stated->Simplices },
        { "stated_tetrahedra", what.Stated->Tetrahedra } });
    }
    rows.Add(row);
  }
  BenchRow row = rows.Make(what.Name, "threads-2");
  row.Counts["simplices"] = simplices;
  MeasureTwoThreads(work, options, row);
  rows.Add(row);
}

/**
 * Adds rows for every case, with the case table filled by an earlier run:
 * - method `warm`, with one thread and with all threads;
 * - method `threads-2`, with two threads; the baseline `threads-1` has one thread.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows)
{
  for (const std::string& name : GetCaseNames(options))
  {
    AddWarmRows(MakeCase(name, options), options, rows);
  }
}

std::vector<BenchClaim> CheckSpeedClaims(const std::vector<BenchRow>& rows)
{
  const auto warm = [&rows](const char* text, double maximum, int threads)
  {
    return BenchClaim::AtMost(text, maximum, rows,
      [threads](const BenchRow& row)
      {
        const bool concerned = row.Method == "warm" && row.Case == ClaimedCase &&
          row.Parameter == ThreadsParameter(threads);
        return concerned ? row.Seconds : std::nullopt;
      });
  };
  return { warm("warm table, 1 thread: at most 0.25 s", 0.25, 1),
    warm("warm table, 2 threads: at most 0.05 s", 0.05, 2),
    BenchClaim::AtLeast("a second thread gives at least 1.7", 1.7, rows, RatioOf("threads-2")) };
}
}

BenchPart MakeSpeedPart()
{
  return { AddSpeedRows, nullptr, CheckSpeedClaims };
}
}
