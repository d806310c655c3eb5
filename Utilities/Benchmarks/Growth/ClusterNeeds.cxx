// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/ClusterNeeds.h"

#include "Benchmarks/Growth/ExtractionGrowth.h"
#include "Benchmarks/Growth/GrowthFit.h"
#include "Benchmarks/Growth/GrowthMeasure.h"
#include "Benchmarks/Growth/TimeGrowth.h"

#include <algorithm>
#include <cmath>

namespace growth
{
namespace
{
constexpr double AllCells = 1024.0 * 1024.0 * 1024.0;
constexpr double AllSteps = 100.0;
constexpr double AllSlabs = AllSteps - 1.0;

/// The largest size of a quantity, and how cost goes on from there.
class Law
{
public:
  static std::optional<Law> Find(const std::string& name, const std::vector<BenchRow>& rows)
  {
    Law law;
    int found = 0;
    for (const BenchRow& row : rows)
    {
      if (row.Case != name)
      {
        continue;
      }
      if (row.Method == SizeMethod && row.Counts.contains("kib") &&
        row.Counts["n"].get<double>() > law.N)
      {
        law.N = row.Counts["n"];
        law.Seconds = row.Counts["processor_seconds"];
        law.Kib = row.Counts["kib"];
      }
      if (row.Method == TimeExponent)
      {
        law.TimePower = row.Counts["exponent"];
        ++found;
      }
      if (row.Method == MemoryExponent)
      {
        law.MemoryPower = row.Counts["exponent"];
        ++found;
      }
    }
    return found == 2 && law.N > 0.0 ? std::optional<Law>(law) : std::nullopt;
  }

  double SecondsOf(double n) const
  {
    return this->Seconds * std::pow(n / this->N, this->TimePower);
  }
  double KibOf(double n) const { return this->Kib * std::pow(n / this->N, this->MemoryPower); }

  double TimePower = 0.0;
  double MemoryPower = 0.0;

private:
  double N = 0.0;
  double Seconds = 0.0;
  double Kib = 0.0;
};

double GetKibOfStep(double cells)
{
  return cells * sizeof(float) / 1024.0;
}

void AddRow(const std::string& method, int ranks, double seconds, double inputKib, double kib,
  BenchRows& rows)
{
  BenchRow row = rows.Make("1024^3 cells, 100 time steps", "computed: " + method);
  row.Parameter = ranks;
  row.Counts["ranks"] = ranks;
  row.Counts["computed_seconds"] = seconds;
  row.Counts["kib_a_rank"] = inputKib + kib;
  row.Counts["input_kib_a_rank"] = inputKib;
  rows.Add(row);
}
}

std::optional<RankNeed> ComputeVolumeOfStep(double cells, const std::vector<BenchRow>& rows)
{
  const auto law = Law::Find(Cells, rows);
  return law ? std::optional<RankNeed>(
                 RankNeed{ law->SecondsOf(cells), GetKibOfStep(cells), law->KibOf(cells) })
             : std::nullopt;
}

std::vector<std::string> DescribeClusterNeeds()
{
  return {
    "computed: what 1024^3 cells of one float each at 100 time steps would need on ranks of one "
    "thread each, such as those of pvserver. It is computed, not measured: with c = 1024^3 / ranks "
    "cells a rank, the largest size n of a quantity, its processor seconds S and KiB M there and "
    "its fitted "
    "exponents p and q of time and memory, and 4 c / 1024 KiB for a time step. Interval volume of "
    "each step: 100 S (c / n)^p seconds and one step + M (c / n)^q KiB, of the quantity cells. In "
    "time, slab by slab: 99 S (c / n)^p and two steps + M (c / n)^q, of cells in time. In time, "
    "all at once: S (c / n)^p 99^p' and two steps + M (c / n)^q 99^q', p' and q' the exponents of "
    "time steps. Where N dominates in the end and p and q are still below 1, c > n needs more than "
    "this. Data that is read, ghost layers, and ranks that wait for others are not in it; "
    "interlume-bench-ranks measures what ranks take.",
    "Slab by slab: memory of an output that holds all slabs grows with the number of time steps. "
    "vtkTimeSlabWriter holds two steps and one slab and writes each to a file of its own, by one "
    "process; on ranks, vtkTimeVaryingIntervalVolume does so with TimeStepRange set to one slab "
    "after the other."
  };
}

void AddClusterRows(BenchRows& rows)
{
  const std::vector<BenchRow> measured = rows.Get();
  const auto inTime = Law::Find(CellsInTime, measured);
  const auto steps = Law::Find(Steps, measured);
  if (!ComputeVolumeOfStep(AllCells, measured) || !inTime || !steps)
  {
    return;
  }
  for (const int ranks : { 1, 64, 256 })
  {
    const double share = AllCells / ranks;
    const double step = GetKibOfStep(share);
    const double slab = inTime->SecondsOf(share);
    const RankNeed volume = *ComputeVolumeOfStep(share, measured);
    AddRow("interval volume of each step", ranks, AllSteps * volume.Seconds, volume.InputKib,
      volume.Kib, rows);
    AddRow("in time, slab by slab", ranks, AllSlabs * slab, 2.0 * step, inTime->KibOf(share), rows);
    AddRow("in time, all at once", ranks, slab * std::pow(AllSlabs, steps->TimePower), 2.0 * step,
      inTime->KibOf(share) * std::pow(AllSlabs, steps->MemoryPower), rows);
  }
}
}
