// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Tetrahedra/TetrahedraParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/PowerFit.h"
#include "Benchmarks/Results/SpeedPlots.h"
#include "Benchmarks/Tetrahedra/TetrahedraMethods.h"
#include "Benchmarks/Tetrahedra/TetrahedraScene.h"

#include "vtkNew.h"
#include "vtkProjectedTetrahedraMapper.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>

namespace tetrahedra
{
namespace
{
struct SpeedCase
{
  std::string Name;
  int Cubes; ///< along an edge; five tetrahedra each
  int Repeats;
  bool IsLargest;
};

std::vector<SpeedCase> MakeSpeedCases(const BenchOptions& options)
{
  // The peer takes half a minute a frame for eight million.
  return options.Pick<std::vector<SpeedCase>>(
    { { "gyroid-0.3M", 39, 5, false }, { "gyroid-2M", 74, 3, false },
      { "gyroid-8M", 117, 1, true } },
    { { "gyroid-0.03M", 18, 3, true }, { "gyroid-0.1M", 27, 3, true },
      { "gyroid-0.3M", 39, 1, false } },
    { { "gyroid-320", 4, 1, false }, { "gyroid-1080", 6, 1, false } });
}

/// A method of the mapper, a mode, and what it took.
struct Entry
{
  const RenderPath* Path;
  const RenderMode* Mode;
  vtkSmartPointer<vtkTimeWeightedTetrahedraMapper> Mapper;
};

std::vector<Entry> MakeEntries(vtkUnstructuredGrid* grid, bool isLargest)
{
  std::vector<Entry> entries;
  for (const RenderPath& path : AllRenderPaths())
  {
    for (const RenderMode& mode : AllRenderModes())
    {
      if (mode.OfLargest || !isLargest)
      {
        entries.push_back({ &path, &mode, NewMapper(grid, path, mode) });
      }
    }
  }
  return entries;
}

void AddRows(const SpeedCase& what, const BenchOptions& options, BenchRows& rows)
{
  auto grid = MakeGrid(what.Cubes);
  Theatre theatre(options.Pick(512, 512, 64));
  const std::string device = theatre.GetStage().GetDevice();
  const std::vector<Entry> entries = MakeEntries(grid, what.IsLargest);
  vtkNew<vtkProjectedTetrahedraMapper> peer;
  peer->SetInputData(static_cast<vtkDataSet*>(grid));
  std::vector<BenchWork> works;
  works.reserve(entries.size() + 1);
  for (const Entry& entry : entries)
  {
    works.push_back(WithThreads(options.Threads, theatre.FrameOf(entry.Mapper)));
  }
  works.push_back(theatre.FrameOf(peer));
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, what.Repeats);

  std::map<const RenderPath*, double> unsorted;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    if (entries[i].Mode == &GetUnsortedMode())
    {
      unsorted[entries[i].Path] = seconds[i];
    }
  }
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const Entry& entry = entries[i];
    const vtkTetrahedraReport& report = entry.Mapper->GetReport();
    BenchRow row = rows.Make(what.Name, entry.Path->Name, entry.Mode->Name);
    row.SetTimes(seconds[i], Peer, seconds.back());
    AddReport(report, row);
    const bool isTheSame = entry.Mode->Blend == GetUnsortedMode().Blend &&
      entry.Mode->Integration == GetUnsortedMode().Integration;
    row.Set(
      { { "sort_seconds",
          report.Sorted && isTheSame ? std::max(0.0, seconds[i] - unsorted[entry.Path]) : 0.0 },
        { "pixels", theatre.GetSize()[0] * theatre.GetSize()[1] }, { "threads", options.Threads },
        { "device", device } });
    rows.Add(row);
  }
}

bool IsSpeedRow(const BenchRow& row)
{
  return row.Peer == Peer && !row.Error;
}

void AddExponentRow(const std::string& method, const std::string& parameter,
  const std::vector<BenchRow>& rows, bool ofPeer, BenchRows& result)
{
  std::vector<double> sizes;
  std::vector<double> seconds;
  for (const BenchRow& row : rows)
  {
    if (IsSpeedRow(row) && row.Method == method && row.Parameter == parameter)
    {
      sizes.push_back(row.Counts["tetrahedra"].get<double>());
      seconds.push_back(ofPeer ? *row.PeerSeconds : *row.Seconds);
    }
  }
  if (sizes.size() < 2)
  {
    return;
  }
  BenchRow row = result.Make("gyroid", ofPeer ? Peer : method);
  if (!ofPeer)
  {
    row.Parameter = parameter;
  }
  row.Set({ { "exponent", FitExponent(sizes, seconds) }, { "cases", sizes.size() } });
  result.Add(row);
}

std::optional<double> TimeOf(
  const std::vector<BenchRow>& rows, const BenchRow& like, const char* mode)
{
  const auto found = std::find_if(rows.begin(), rows.end(),
    [&](const BenchRow& row)
    {
      return IsSpeedRow(row) && row.Case == like.Case && row.Method == like.Method &&
        row.Parameter == mode;
    });
  return found == rows.end() ? std::nullopt : found->Seconds;
}

using RatioFunction = std::function<std::optional<double>(const BenchRow&)>;

/// The ratio of a row, where that is of a case of so many tetrahedra.
std::optional<double> RatioWithin(const BenchRow& row, double fewest, double most)
{
  const double size = row.Counts["tetrahedra"].get<double>();
  return size >= fewest && size < most ? row.GetRatio() : std::nullopt;
}

/// The ratio of the default mode of a path, in cases of so many tetrahedra.
RatioFunction RatioOf(const std::string& path, double fewest, double most)
{
  return [=](const BenchRow& row) -> std::optional<double>
  {
    const bool concerned =
      IsSpeedRow(row) && row.Method == path && row.Parameter == GetDefaultMode().Name;
    return concerned ? RatioWithin(row, fewest, most) : std::nullopt;
  };
}

/// Likewise with the sort by centroids, which is the default's where it has no row of its own.
RatioFunction RatioSortedByCentroids(
  const std::string& path, const std::vector<BenchRow>& rows, double fewest, double most)
{
  return [=, &rows](const BenchRow& row) -> std::optional<double>
  {
    if (!IsSpeedRow(row) || row.Method != path)
    {
      return std::nullopt;
    }
    const bool isDefault = row.Parameter == GetDefaultMode().Name &&
      row.Counts["sort_mode"] == vtkTimeWeightedTetrahedraMapper::CENTROID_SORT &&
      !TimeOf(rows, row, GetCentroidMode().Name);
    const bool concerned = isDefault || row.Parameter == GetCentroidMode().Name;
    return concerned ? RatioWithin(row, fewest, most) : std::nullopt;
  };
}

/// What is wanted of each render path by itself.
void AddClaims(
  const std::string& path, const std::vector<BenchRow>& rows, std::vector<BenchClaim>& claims)
{
  for (const std::string mode : { GetUnsortedMode().Name, "optical depth" })
  {
    std::string text = path;
    text.append(": ").append(mode).append(" is at least as fast as composite with its sort");
    claims.push_back(BenchClaim::AtLeast(text, 1.0, rows,
      [&](const BenchRow& row) -> std::optional<double>
      {
        const bool concerned = IsSpeedRow(row) && row.Method == path && row.Parameter == mode;
        const auto sorted = TimeOf(rows, row, GetDefaultMode().Name);
        return concerned && sorted ? std::optional<double>(*sorted / *row.Seconds) : std::nullopt;
      }));
  }
  claims.push_back(BenchClaim::AtMost(
    path + ": time grows as tetrahedra to the power of at most 1.1", 1.1, rows,
    [&](const BenchRow& row) -> std::optional<double>
    {
      const bool concerned = row.Counts.contains("exponent") && row.Method == path &&
        row.Parameter == GetDefaultMode().Name;
      return concerned ? std::optional<double>(row.Counts["exponent"].get<double>()) : std::nullopt;
    }));
}

/**
 * Methods `opengl` and `software`, the render paths, against the peer `projectedtetrahedra`: a row
 * for each blend, sort and integration mode, and rows with the exponent of time against tetrahedra.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows)
{
  for (const SpeedCase& what : MakeSpeedCases(options))
  {
    AddRows(what, options, rows);
  }
  const std::vector<BenchRow> measured = rows.Get();
  for (const RenderPath& path : AllRenderPaths())
  {
    for (const RenderMode& mode : AllRenderModes())
    {
      AddExponentRow(path.Name, mode.Name, measured, false, rows);
    }
  }
  AddExponentRow(AllRenderPaths()[0].Name, GetDefaultMode().Name, measured, true, rows);
}

std::vector<BenchClaim> CheckSpeedClaims(const std::vector<BenchRow>& rows)
{
  constexpr double some = 2.5e5;
  constexpr double many = 1.9e6;
  constexpr double most = 7.5e6;
  constexpr double all = 1e12;
  const std::string than = " times faster than " + std::string(Peer);
  std::vector<BenchClaim> claims = {
    BenchClaim::AtLeast(
      "opengl, 0.3 M tetrahedra: at least 1.2" + than, 1.2, rows, RatioOf("opengl", some, many)),
    BenchClaim::AtLeast("opengl, 2 M tetrahedra and more: at least 2" + than, 2.0, rows,
      RatioOf("opengl", many, all)),
    BenchClaim::AtLeast("software, centroid sort, 0.3 M tetrahedra: at least 4" + than, 4.0, rows,
      RatioSortedByCentroids("software", rows, some, many)),
    BenchClaim::AtLeast("software, centroid sort, 2 M tetrahedra: at least 8" + than, 8.0, rows,
      RatioSortedByCentroids("software", rows, many, most)),
    BenchClaim::AtLeast("software, centroid sort, 8 M tetrahedra: at least 16" + than, 16.0, rows,
      RatioSortedByCentroids("software", rows, most, all)),
  };
  for (const RenderPath& path : AllRenderPaths())
  {
    AddClaims(path.Name, rows, claims);
  }
  return claims;
}

std::vector<BenchPlot> MakeSpeedPlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchRow> speed;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(speed), IsSpeedRow);
  std::vector<BenchPlot> plots;
  BenchPlot times = BenchPlot::OfErrors("tetrahedra-time",
    "one frame after a small turn, 512 x 512: time against tetrahedra", "tetrahedra",
    "time of a frame (s)");
  times.HasFront = false;
  times.DefaultSeries = "software";
  for (const BenchRow& row : speed)
  {
    const double size = row.Counts["tetrahedra"].get<double>();
    const bool isDefault = row.Parameter == GetDefaultMode().Name;
    if (isDefault || row.Parameter == GetUnsortedMode().Name)
    {
      times.AddPoint(row.Method + (isDefault ? "" : ", unsorted"), false, size, *row.Seconds);
    }
    if (isDefault && row.Method == AllRenderPaths()[0].Name)
    {
      times.AddPoint(Peer, true, size, *row.PeerSeconds);
    }
  }
  plots.push_back(times);
  // Bars need a value for every case, and the largest has not every mode.
  std::set<std::string> ofAll;
  for (const RenderMode& mode : AllRenderModes())
  {
    if (mode.OfLargest)
    {
      ofAll.insert(mode.Name);
    }
  }
  std::vector<BenchRow> complete;
  std::copy_if(speed.begin(), speed.end(), std::back_inserter(complete),
    [&ofAll](const BenchRow& row) { return ofAll.count(row.Parameter.get<std::string>()) > 0; });
  for (const RenderPath& path : AllRenderPaths())
  {
    for (BenchPlot& plot : MakeRatioPlots("tetrahedra", path.Name, complete))
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
