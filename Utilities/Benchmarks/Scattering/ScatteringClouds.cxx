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
const char* const CloudNorm = "difference over the mean, mean over pixels";
const char* const CloudName = "cloud";
const char* const Default = "default";
const char* const Shadowed = "shadowed";

/// Returns the mean absolute difference between the color channels of two images, divided by the
/// mean channel value of \a expected.
double GetRelativeError(const reference::RgbaImage& found, const reference::RgbaImage& expected)
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

/// Estimates the relative error of \a image due to noise, from the standard errors of its pixels.
double GetNoise(const reference::TransportImage& image)
{
  // Mean absolute deviation of a normal distribution with standard deviation 1.
  const double mean = std::sqrt(2.0 / 3.14159265358979324);
  double sum = 0.0;
  double color = 0.0;
  for (std::size_t i = 0; i < image.Mean.Values.size(); ++i)
  {
    if (i % 4 != 3)
    {
      sum += mean * image.StandardError.Values[i];
      color += image.Mean.Values[i];
    }
  }
  return sum / color;
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
      shadows::MakeSliceMethod(
        stage, scene, MakeModeSetter(mode, reference::CloudAnisotropy, more)) });
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
  settings.push_back({ Shadowed, Default, shadows::MakeSliceMethod(stage, scene) });
  return settings;
}

BenchRow MakeRow(const BenchRows& rows, const std::string& method, const std::string& parameter,
  const BenchSeconds& seconds, double error)
{
  BenchRow row = rows.Make(CloudName, method, parameter);
  row.Seconds = seconds;
  row.SetError(CloudNorm, error);
  return row;
}

/**
 * Compares images of a cloud with reference::TraceScene. Methods: `single`, `forward` and `full`;
 * `shadowed`, without scattered light. The parameter is `default` or the setting that differs, such
 * as `grid 16`, `buffer 128` or `spacing 2` (twice the default spacing). Rows with default settings
 * have the count over_shadowed, their time divided by the time of `shadowed`. Method `monte-carlo`:
 * the parameter is the number of paths per pixel, and the error is the noise of the image.
 */
void AddCloudRows(const BenchOptions& options, BenchRows& rows)
{
  const reference::ShadowScene scene =
    reference::MakeCloudCase(options.Pick(96, 32, 12), options.Pick(128, 32, 8));
  reference::VolumeStage stage(scene.Size);
  double spacing = 0.0;
  {
    const shadows::MethodPointer plain = shadows::MakeSliceMethod(stage, scene);
    plain->Capture();
    spacing = plain->GetSliceMapper()->GetReport()->GetNumber("SliceSpacing");
  }
  const std::vector<Setting> settings = MakeSettings(stage, scene, spacing, options);

  reference::SceneTransportSettings traced;
  traced.Phase = reference::TransportPhase::HenyeyGreenstein(reference::CloudAnisotropy);
  traced.PathsPerPixel = static_cast<std::uint64_t>(options.Pick(1500, 200, 10));
  traced.Seed = options.Seed;
  reference::TransportImage expected;
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
    works.push_back(MakeRelightingWork(*setting.Drawn, scene.Lights.front(), options.Threads));
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  const BenchSeconds shadowed = seconds.back();
  for (std::size_t i = 0; i < settings.size(); ++i)
  {
    const Setting& setting = settings[i];
    const double error = GetRelativeError(setting.Drawn->Capture(), expected.Mean);
    BenchRow row = MakeRow(rows, setting.Mode, setting.Parameter, seconds[i], error);
    shadows::AddReport(setting.Drawn->GetSliceMapper()->GetReport(), row);
    row.Counts["reference_noise"] = noise;
    if (setting.Mode != Shadowed && setting.Parameter == Default)
    {
      row.Baseline = Shadowed;
      row.BaselineSeconds = shadowed;
      row.Counts["over_shadowed"] = seconds[i] / shadowed;
    }
    rows.Add(row);
  }
  // Noise is inversely proportional to the square root of the number of paths.
  for (std::uint64_t paths = traced.PathsPerPixel; paths > 0; paths /= 8)
  {
    const double fraction = static_cast<double>(paths) / static_cast<double>(traced.PathsPerPixel);
    rows.Add(MakeRow(rows, MonteCarlo, std::to_string(paths) + " paths",
      { traceSeconds * fraction, traceSeconds.Runs }, noise / std::sqrt(fraction)));
  }
}

/**
 * Measures the time to render a frame of the cloud while only the camera moves, so that scattered
 * light is reused. Methods: `single`, `forward` and `full`. The parameter is the number of pixels
 * along an edge. The baseline is the same image without scattered light. Counts:
 * view_over_shadowed, the time divided by the time of the baseline; solves, the number of times
 * that scattered light was computed, which is 1.
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
        shadows::MakeSliceMethod(stage, scene, MakeModeSetter(mode, reference::CloudAnisotropy)) });
    }
    settings.push_back({ Shadowed, Default, shadows::MakeSliceMethod(stage, scene) });
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
            settings[i].Drawn->GetSliceMapper()->GetReport()->GetNumber("ScatteringSolves")) } });
      rows.Add(row);
    }
  }
}

std::vector<BenchPlot> MakeCloudPlots(const std::vector<BenchRow>& rows)
{
  BenchPlot plot = BenchPlot::OfErrors("scattering-cloud",
    "cloud: error against run time, one light", "time of a frame whose light has moved (s)",
    std::string("error: ") + CloudNorm, "Which scattering mode, and how many grid cells?",
    "A cloud under one light; labels are changed settings. The reference is Monte Carlo path "
    "tracing, whose own error is also plotted.");
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
