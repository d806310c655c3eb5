// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/SpaceTime/Interval4dCases.h"
#include "Benchmarks/SpaceTime/Interval4dCounts.h"
#include "Benchmarks/SpaceTime/Interval4dError.h"
#include "Benchmarks/SpaceTime/Interval4dFresh.h"
#include "Benchmarks/SpaceTime/Interval4dSpeed.h"
#include "Benchmarks/SpaceTime/Interval4dThroughput.h"
#include "Benchmarks/Suites/BenchSuites.h"

#include <utility>

namespace
{
template <typename Item>
void Append(std::vector<Item>& all, std::vector<Item> more)
{
  for (Item& item : more)
  {
    all.push_back(std::move(item));
  }
}

class SuiteInterval4d : public BenchSuite
{
public:
  std::string GetName() const override { return "interval4d"; }
  std::string GetTitle() const override
  {
    return "vtkTimeVaryingIntervalVolume: run time, tables, memory, counts, error against run time";
  }

  std::vector<std::string> GetDescription() const override
  {
    return {
      "The time steps are in memory, with one point array, so that the filter alone is timed; it "
      "makes projected tetrahedra. vortex and wave are fields of vtkAnalyticFieldSource, cylinder "
      "and delta those of vtkTaperedCylinderSource and vtkDeltaWingSource, which stand in for the "
      "data of the source, C. Zhang, dissertation, Ohio State 2006, with the number of time steps; "
      "mug is real. stated_ are the counts of the source. warm: the table holds every case. "
      "threads-2: two threads against one. throughput: 4-simplices a second; the parameter is the "
      "share of points inside.",
      "cold: the first execution in a fresh process, 1 thread, against later ones in the same one "
      "(peer warm). hit_share is the share of lookups that found their case made; kind_hit_share "
      "counts those too that found a case of the same kind, that is equal up to a symmetry of the "
      "cell: only a new kind needs a convex hull. later-slabs: the same for all slabs but the "
      "first. memory: in a process of its own; peak_kib is two time steps and the largest growth "
      "of "
      "resident memory; peak_share is that divided by two time steps and the output.",
      "hexahedra, tetrahedra-5: 3-simplices of the first step, 4-simplices and projected "
      "tetrahedra of each class, for the grid as it is and with every hexahedron cut into five "
      "tetrahedra. flat 4-simplices have no volume when projected and no tetrahedra.",
      "slice, interpolate, sampled: the regions midway between every two time steps as the time "
      "step (the parameter) is halved, as slices of 4-simplices; from the mean of the values of "
      "both steps; from the field itself at that time. The reference is the region of the formula. "
      "order: the exponent of errors above four times that of sampled. slice-again: one more slice "
      "of the same 4-simplices."
    };
  }

  void Run(const BenchOptions& options, BenchRows& rows) const override
  {
    const auto runTask = [&](const std::string& task) { return this->RunChild(task, options); };
    interval4d::AddSpeedRows(options, rows);
    interval4d::AddFreshRows(options, runTask, rows);
    interval4d::AddThroughputRows(options, rows);
    interval4d::AddCountRows(options, rows);
    interval4d::AddErrorRows(options, rows);
  }

  nlohmann::ordered_json RunTask(
    const std::string& task, const BenchOptions& options) const override
  {
    const auto found = interval4d::RunFreshTask(task, options);
    return found ? *found : this->BenchSuite::RunTask(task, options);
  }

  std::vector<BenchClaim> CheckClaims(const std::vector<BenchRow>& rows) const override
  {
    std::vector<BenchClaim> claims = interval4d::CheckSpeedClaims(rows);
    Append(claims, interval4d::CheckFreshClaims(rows));
    Append(claims, interval4d::CheckCountClaims(rows));
    Append(claims, interval4d::CheckErrorClaims(rows));
    return claims;
  }

  std::vector<BenchPlot> MakePlots(const std::vector<BenchRow>& rows) const override
  {
    std::vector<BenchPlot> plots = interval4d::MakeFreshPlots(rows);
    Append(plots, interval4d::MakeThroughputPlots(rows));
    Append(plots, interval4d::MakeErrorPlots(rows));
    return plots;
  }
};
}

std::unique_ptr<BenchSuite> MakeInterval4dSuite()
{
  return std::make_unique<SuiteInterval4d>();
}
