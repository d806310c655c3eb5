// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Results/SpeedPlots.h"
#include "Benchmarks/Tetrahedra/TetrahedraMethods.h"
#include "Benchmarks/Tetrahedra/TetrahedraScene.h"

#include "vtkNew.h"
#include "vtkProjectedTetrahedraMapper.h"

#include <algorithm>
#include <string>

namespace tetrahedra
{
namespace
{
struct SpeedCase
{
  std::string Name;
  int Cubes; ///< Cubes along an edge, with five tetrahedra each.
  int Repeats;
};

std::vector<SpeedCase> MakeSpeedCases(const BenchOptions& options)
{
  // The baseline takes half a minute per frame for eight million tetrahedra.
  return options.Pick<std::vector<SpeedCase>>(
    { { "gyroid-0.3M", 39, 5 }, { "gyroid-2M", 74, 3 }, { "gyroid-8M", 117, 1 } },
    { { "gyroid-0.03M", 18, 3 }, { "gyroid-0.1M", 27, 3 }, { "gyroid-0.3M", 39, 1 } },
    { { "gyroid-320", 4, 1 }, { "gyroid-1080", 6, 1 } });
}

/// A mapper with a render path and a mode.
struct Entry
{
  const RenderPath* Path;
  const RenderMode* Mode;
  vtkSmartPointer<vtkTimeWeightedTetrahedraMapper> Mapper;
};

void AddRows(const SpeedCase& what, const BenchOptions& options, BenchRows& rows)
{
  auto grid = MakeGrid(what.Cubes);
  SharedStage stage(options.Pick(512, 512, 64));
  const std::string device = stage.GetStage().GetDevice();
  std::vector<Entry> entries;
  std::vector<BenchWork> works;
  for (const RenderPath& path : AllRenderPaths())
  {
    for (const RenderMode& mode : AllRenderModes())
    {
      entries.push_back({ &path, &mode, NewMapper(grid, path, mode) });
      works.push_back(WithThreads(options.Threads, stage.MakeRenderWork(entries.back().Mapper)));
    }
  }
  vtkNew<vtkProjectedTetrahedraMapper> baseline;
  baseline->SetInputData(static_cast<vtkDataSet*>(grid));
  works.push_back(stage.MakeRenderWork(baseline));
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, what.Repeats);
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    BenchRow row = rows.Make(what.Name, entries[i].Path->Name, entries[i].Mode->Name);
    row.SetTimes(seconds[i], Baseline, seconds.back());
    AddReport(entries[i].Mapper->GetReport(), row);
    row.Set({ { "pixels", stage.GetSize()[0] * stage.GetSize()[1] }, { "threads", options.Threads },
      { "device", device } });
    rows.Add(row);
  }
}

bool IsSpeedRow(const BenchRow& row)
{
  return row.Baseline == Baseline && !row.Error;
}

bool IsOf(const BenchRow& row, const std::string& path, const std::string& mode)
{
  return IsSpeedRow(row) && row.Method == path && row.Parameter == mode;
}

/// Returns a function for BenchClaim. For rows of a render path in its default mode with at least
/// \a minimum and fewer than \a maximum tetrahedra, it returns BenchRow::GetRatio().
std::function<std::optional<double>(const BenchRow&)> RatioOf(
  const std::string& path, double minimum, double maximum)
{
  return [=](const BenchRow& row) -> std::optional<double>
  {
    if (!IsOf(row, path, GetDefaultMode().Name))
    {
      return std::nullopt;
    }
    const double size = row.Counts["tetrahedra"].get<double>();
    return size >= minimum && size < maximum ? row.GetRatio() : std::nullopt;
  };
}

/// Returns the claim that a mode without sorting is at least as fast as the default mode.
BenchClaim IsFasterUnsorted(
  const std::string& path, const std::string& mode, const std::vector<BenchRow>& rows)
{
  return BenchClaim::AtLeast(path + ": " + mode + " is at least as fast as composite with its sort",
    1.0, rows,
    [&](const BenchRow& row) -> std::optional<double>
    {
      const auto sorted = std::find_if(rows.begin(), rows.end(),
        [&](const BenchRow& other)
        { return IsOf(other, path, GetDefaultMode().Name) && other.Case == row.Case; });
      return IsOf(row, path, mode) && sorted != rows.end()
        ? std::optional<double>(*sorted->Seconds / *row.Seconds)
        : std::nullopt;
    });
}

/**
 * Measures frame times of both render paths (methods `opengl` and `software`), with a row for each
 * render mode. The baseline is `projectedtetrahedra`.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows)
{
  for (const SpeedCase& what : MakeSpeedCases(options))
  {
    AddRows(what, options, rows);
  }
}

std::vector<BenchClaim> CheckSpeedClaims(const std::vector<BenchRow>& rows)
{
  constexpr double some = 2.5e5;
  constexpr double many = 1.9e6;
  constexpr double most = 7.5e6;
  constexpr double all = 1e12;
  const std::string than = " times faster than " + std::string(Baseline);
  std::vector<BenchClaim> claims = {
    BenchClaim::AtLeast(
      "opengl, 0.3 M tetrahedra: at least 1.2" + than, 1.2, rows, RatioOf("opengl", some, many)),
    BenchClaim::AtLeast("opengl, 2 M tetrahedra and more: at least 2" + than, 2.0, rows,
      RatioOf("opengl", many, all)),
    BenchClaim::AtLeast(
      "software, 0.3 M tetrahedra: at least 4" + than, 4.0, rows, RatioOf("software", some, many)),
    BenchClaim::AtLeast(
      "software, 2 M tetrahedra: at least 8" + than, 8.0, rows, RatioOf("software", many, most)),
    BenchClaim::AtLeast(
      "software, 8 M tetrahedra: at least 16" + than, 16.0, rows, RatioOf("software", most, all)),
  };
  for (const RenderPath& path : AllRenderPaths())
  {
    for (const char* mode : { Unsorted, OpticalDepth })
    {
      claims.push_back(IsFasterUnsorted(path.Name, mode, rows));
    }
  }
  return claims;
}

std::vector<BenchPlot> MakeSpeedPlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots = { BenchPlot::OfErrors("tetrahedra-time",
    "one frame after a small turn, 512 x 512: time against tetrahedra", "tetrahedra",
    "time of a frame (s)") };
  plots[0].HasFront = false;
  plots[0].DefaultSeries = "software";
  std::vector<BenchRow> speed;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(speed), IsSpeedRow);
  for (const BenchRow& row : speed)
  {
    const double size = row.Counts["tetrahedra"].get<double>();
    const bool isDefault = row.Parameter == GetDefaultMode().Name;
    if (isDefault || row.Parameter == Unsorted)
    {
      plots[0].AddPoint(row.Method + (isDefault ? "" : ", unsorted"), false, size, *row.Seconds);
    }
    if (isDefault && row.Method == AllRenderPaths()[0].Name)
    {
      plots[0].AddPoint(Baseline, true, size, *row.BaselineSeconds);
    }
  }
  for (const RenderPath& path : AllRenderPaths())
  {
    for (BenchPlot& plot : MakeRatioPlots("tetrahedra", path.Name, speed))
    {
      plot.Name = "tetrahedra-ratio-" + std::string(path.Name);
      plots.push_back(std::move(plot));
    }
  }
  return plots;
}
}

BenchPart MakeSpeedPart()
{
  return { AddSpeedRows, MakeSpeedPlots, CheckSpeedClaims };
}
}
