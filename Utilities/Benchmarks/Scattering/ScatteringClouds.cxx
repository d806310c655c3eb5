// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Scattering/ScatteringModes.h"
#include "Support/Transport/CloudCase.h"
#include "Support/Transport/SceneTransport.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace scattering
{
namespace
{
const char* const Norm = "difference over the mean, mean over pixels";
const char* const CloudName = "cloud";
const char* const Default = "default";
const char* const Shadowed = "shadowed";

/// The mean over pixels of the difference of colours, over the mean colour of the reference.
double GetRelativeError(const reference::RgbaPicture& found, const reference::RgbaPicture& expected)
{
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < expected.Values.size(); ++i)
  {
    if (i % 4 != 3)
    {
      difference += std::abs(found.Values[i] - expected.Values[i]);
      sum += expected.Values[i];
    }
  }
  return difference / sum;
}

/// The error of noise of known standard deviations, as the above.
double GetNoise(const reference::TransportPicture& picture)
{
  // Of a normal distribution the mean distance from the middle, in standard deviations.
  const double mean = std::sqrt(2.0 / 3.14159265358979324);
  double sum = 0.0;
  double colour = 0.0;
  for (std::size_t i = 0; i < picture.Mean.Values.size(); ++i)
  {
    if (i % 4 != 3)
    {
      sum += mean * picture.StandardError.Values[i];
      colour += picture.Mean.Values[i];
    }
  }
  return sum / colour;
}

struct Setting
{
  std::string Mode;
  std::string Parameter;
  shadows::MethodPointer Drawn;
};

std::vector<Setting> MakeSettings(reference::VolumeStage& stage,
  const reference::ShadowScene& scene, double spacing, const BenchOptions& options)
{
  std::vector<Setting> settings;
  const auto add = [&](const std::string& mode, const std::string& parameter, const Change& more)
  {
    settings.push_back({ mode, parameter,
      shadows::MakeSlices(stage, scene, InMode(mode, reference::CloudAnisotropy, more)) });
  };
  for (const std::string& mode : GetModes())
  {
    add(mode, Default, nullptr);
    for (const int size : options.Pick<std::vector<int>>({ 64, 128, 256 }, { 64 }, { 16 }))
    {
      add(mode, "buffer " + std::to_string(size),
        [=](vtkShadowedSliceMapper* mapper) { mapper->SetLightBufferSize(size); });
    }
    for (const int factor : options.Pick<std::vector<int>>({ 2, 4 }, { 2 }, { 2 }))
    {
      add(mode, "spacing " + std::to_string(factor),
        [=](vtkShadowedSliceMapper* mapper) { mapper->SetSliceSpacing(factor * spacing); });
    }
    if (mode != Single)
    {
      for (const int size : options.Pick<std::vector<int>>({ 8, 16, 32, 64 }, { 8, 16 }, { 8 }))
      {
        add(mode, "grid " + std::to_string(size),
          [=](vtkShadowedSliceMapper* mapper) { mapper->SetScatteringGridSize(size); });
      }
    }
  }
  settings.push_back({ Shadowed, Default, shadows::MakeSlices(stage, scene) });
  return settings;
}

BenchRow MakeRow(const BenchRows& rows, const std::string& method, const std::string& parameter,
  const BenchSeconds& seconds, double error)
{
  BenchRow row = rows.Make(CloudName, method, parameter);
  row.Seconds = seconds;
  row.SetError(Norm, error);
  return row;
}

/**
 * Pictures of a cloud against those of reference::TraceScene. Methods `single`, `forward` and
 * `full`; the parameter is `default`, or what is not: `grid 16`, `buffer 128`, `spacing 2`, in
 * default spacings. Counts of the default of full: over_shadowed, its time over that of the same
 * picture without scattered light. `monte-carlo`: the parameter is the number of paths of a pixel,
 * the error that of its noise.
 */
void AddCloudRows(const BenchOptions& options, BenchRows& rows)
{
  const reference::ShadowScene scene =
    reference::MakeCloudCase(options.Pick(96, 32, 12), options.Pick(128, 32, 8));
  reference::VolumeStage stage(scene.Size);
  double spacing = 0.0;
  {
    const shadows::MethodPointer plain = shadows::MakeSlices(stage, scene);
    plain->Capture();
    spacing = plain->GetSlices()->GetReport()->GetNumber("SliceSpacing");
  }
  const std::vector<Setting> settings = MakeSettings(stage, scene, spacing, options);

  reference::SceneTransportSettings traced;
  traced.Phase = reference::TransportPhase::HenyeyGreenstein(reference::CloudAnisotropy);
  traced.PathsPerPixel = static_cast<std::uint64_t>(options.Pick(1500, 200, 10));
  traced.Seed = options.Seed;
  reference::TransportPicture expected;
  const auto trace = WithThreads(options.Threads,
    [&]()
    {
      expected = reference::TraceScene(scene, traced);
      return vtkSmartPointer<vtkObjectBase>();
    });
  const BenchSeconds traceSeconds = TimeOnce(trace);
  const double noise = GetNoise(expected);

  std::vector<BenchWork> works;
  for (const Setting& setting : settings)
  {
    works.push_back(GetLitFrame(*setting.Drawn, scene.Lights.front(), options.Threads));
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  const BenchSeconds shadowed = seconds.back();
  for (std::size_t i = 0; i < settings.size(); ++i)
  {
    const Setting& setting = settings[i];
    const double error = GetRelativeError(setting.Drawn->Capture(), expected.Mean);
    BenchRow row = MakeRow(rows, setting.Mode, setting.Parameter, seconds[i], error);
    shadows::AddReport(setting.Drawn->GetSlices()->GetReport(), row);
    row.Counts["reference_noise"] = noise;
    if (setting.Mode != Shadowed && setting.Parameter == Default)
    {
      row.Peer = Shadowed;
      row.PeerSeconds = shadowed;
      row.Counts["over_shadowed"] = seconds[i] / shadowed;
    }
    rows.Add(row);
  }
  // The noise falls with the square root of the number of paths.
  for (std::uint64_t paths = traced.PathsPerPixel; paths > 0; paths /= 8)
  {
    const double share = static_cast<double>(paths) / static_cast<double>(traced.PathsPerPixel);
    rows.Add(MakeRow(rows, MonteCarlo, std::to_string(paths) + " paths",
      { traceSeconds * share, traceSeconds.Runs }, noise / std::sqrt(share)));
  }
}

/**
 * Pictures of the cloud where only the view turns, so that scattered light is kept. Methods
 * `single`, `forward`, `full`; the parameter is the number of columns and rows of the picture, the
 * peer the same picture without scattered light. Counts: view_over_shadowed, the times' ratio;
 * solves, how often scattered light was found, once.
 */
void AddViewRows(const BenchOptions& options, BenchRows& rows)
{
  for (const int pixels : options.Pick<std::vector<int>>({ 128, 512 }, { 128 }, { 8 }))
  {
    const reference::ShadowScene scene = reference::MakeCloudCase(options.Pick(96, 32, 12), pixels);
    reference::VolumeStage stage(scene.Size);
    std::vector<Setting> settings;
    std::vector<BenchWork> works;
    for (const std::string& mode : GetModes())
    {
      settings.push_back({ mode, Default,
        shadows::MakeSlices(stage, scene, InMode(mode, reference::CloudAnisotropy)) });
    }
    settings.push_back({ Shadowed, Default, shadows::MakeSlices(stage, scene) });
    for (const Setting& setting : settings)
    {
      setting.Drawn->Capture();
      works.push_back(setting.Drawn->GetFrame(options.Threads));
    }
    const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
    for (std::size_t i = 0; i + 1 < settings.size(); ++i)
    {
      BenchRow row = rows.Make("cloud, the view turns", settings[i].Mode, pixels);
      row.SetTimes(seconds[i], Shadowed, seconds.back());
      row.Set({ { "view_over_shadowed", seconds[i] / seconds.back() },
        { "solves",
          static_cast<vtkIdType>(
            settings[i].Drawn->GetSlices()->GetReport()->GetNumber("ScatteringSolves")) } });
      rows.Add(row);
    }
  }
}

std::vector<BenchPlot> MakeCloudPlots(const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfErrors("scattering-cloud",
    "cloud: error against run time, one light", "time of a frame whose light has moved (s)",
    std::string("error: ") + Norm, "Which method for scattered light, in how many cells?",
    "A cloud under one light, cells along the longest edge at each point, against paths of light "
    "by Monte Carlo, whose own error is on the plot too.");
  for (const BenchRow& row : rows)
  {
    if (row.Case == CloudName)
    {
      plot.AddRow(row, row.Method == MonteCarlo || row.Method == Shadowed);
    }
  }
  plot.SetDefault(Full, Default);
  return { plot };
}
}

BenchPart MakeCloudPart()
{
  const auto check = [](const std::vector<BenchRow>& rows) -> std::vector<BenchClaim>
  {
    return { BenchClaim::AtMost("full at most 2 times the time of shadows alone", 2.0, rows,
               CountOf(Full, "over_shadowed")),
      BenchClaim::AtMost(
        "full at most 1.25 times the time of shadows alone while only the view turns", 1.25, rows,
        CountOf(Full, "view_over_shadowed")) };
  };
  return { [](const BenchOptions& options, BenchRows& rows)
    {
      AddCloudRows(options, rows);
      AddViewRows(options, rows);
    },
    MakeCloudPlots, check };
}
}
