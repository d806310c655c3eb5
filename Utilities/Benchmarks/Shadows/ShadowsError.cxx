// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Shadows/GpuShadows.h"
#include "Benchmarks/Shadows/ShadowsMethods.h"
#include "Benchmarks/Shadows/ShadowsScene.h"
#include "Support/Images/ReferenceShadowImage.h"

#include "vtkCamera.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace shadows
{
namespace
{
const char* const MarcherNorm = "channel difference, mean";
const char* const Spacing = "spacing";
const char* const Buffer = "buffer";
const char* const EqualError = "equal-error";
const char* const Scattering = ", scattering";
const char* const Shaded = ", shaded";
/// The baseline is measured only with larger sample distances than this, in voxels.
constexpr double FinestSamples = 0.25;
constexpr int Repeats = 3;

std::vector<Case> MakeErrorCases(const BenchOptions& options)
{
  const int points = options.Pick(128, 32, 12);
  const int step = options.Pick(2, 8, 16);
  return WithPixels(
    { MakeSphere(points), MakeRings(points), MakeBonsai(step, step) }, options.Pick(256, 64, 16));
}

/// Returns the default slice spacing for \a scene, in world units.
double GetDefaultSpacing(reference::VolumeStage& stage, const reference::ShadowScene& scene)
{
  const MethodPointer method = MakeSliceMethod(stage, scene);
  method->Capture();
  return method->GetSliceMapper()->GetReport()->GetNumber("SliceSpacing");
}

std::vector<Setting> MakeSettings(reference::VolumeStage& stage,
  const reference::ShadowScene& scene, double spacing, bool hasBaseline,
  const BenchOptions& options)
{
  const auto distances = options.Pick<std::vector<double>>(
    { 0.25, 0.5, 1.0, 2.0, 4.0 }, { 0.5, 1.0, 2.0 }, { 1.0, 2.0 });
  const auto sizes =
    options.Pick<std::vector<int>>({ 64, 128, 256, 512, 1024 }, { 32, 128 }, { 16, 32 });
  std::vector<Setting> settings;
  settings.reserve(2 * distances.size() + sizes.size());
  for (const double factor : distances)
  {
    settings.push_back({ Spacing, factor,
      MakeSliceMethod(stage, scene,
        [=](vtkShadowedSliceMapper* mapper) { mapper->SetSliceSpacing(factor * spacing); }) });
  }
  for (const int size : sizes)
  {
    settings.push_back({ Buffer, static_cast<double>(size),
      MakeSliceMethod(
        stage, scene, [=](vtkShadowedSliceMapper* mapper) { mapper->SetLightBufferSize(size); }) });
  }
  for (const double distance : distances)
  {
    if (hasBaseline && HasGpuShadows() && distance > FinestSamples)
    {
      settings.push_back(
        { GpuShadowsBaseline, distance, MakeShadowRayMethod(stage, scene, distance) });
    }
  }
  return settings;
}

void AddRow(const Setting& setting, const std::string& name, const reference::RgbaImage& expected,
  BenchRows& rows)
{
  BenchRow row = rows.Make(name, setting.Name, setting.Parameter);
  row.Seconds = setting.Seconds;
  if (vtkShadowedSliceMapper* slices = setting.Drawn->GetSliceMapper())
  {
    AddReport(slices->GetReport(), row);
  }
  const reference::ImageError error = reference::CompareImages(setting.Drawn->Capture(), expected);
  row.SetError(MarcherNorm, error.Mean);
  row.Counts["largest_error"] = error.Max;
  rows.Add(row);
}

void AddSceneRows(reference::VolumeStage& stage, const std::string& name,
  const reference::ShadowScene& scene, bool hasBaseline, const BenchOptions& options,
  BenchRows& rows)
{
  const double spacing = GetDefaultSpacing(stage, scene);
  std::vector<Setting> settings = MakeSettings(stage, scene, spacing, hasBaseline, options);
  MeasureFrames(settings, options.Threads, Repeats);
  const reference::RgbaImage expected = reference::MakeShadowImage(scene);
  for (const Setting& setting : settings)
  {
    AddRow(setting, name, expected, rows);
  }
}

/// A point of a plot of error against time.
struct Point
{
  BenchSeconds Seconds = {};
  double Error;
};

/// Returns the points of \a method in the case \a name, sorted by descending error.
std::vector<Point> GetPoints(
  const std::vector<BenchRow>& rows, const std::string& name, const std::string& method)
{
  std::vector<Point> points;
  for (const BenchRow& row : rows)
  {
    if (row.Case == name && row.Method == method && *row.Error > 0.0)
    {
      points.push_back({ *row.Seconds, *row.Error });
    }
  }
  std::sort(
    points.begin(), points.end(), [](const Point& a, const Point& b) { return a.Error > b.Error; });
  return points;
}

/// Returns the time at the given error, interpolated between the points on logarithmic axes. For
/// errors outside the range of the points, returns the time of the first or last point.
BenchSeconds GetSecondsAt(double error, const std::vector<Point>& points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[i].Error <= error)
    {
      if (i == 0)
      {
        return points[0].Seconds;
      }
      const Point& before = points[i - 1];
      const double fraction =
        std::log(before.Error / error) / std::log(before.Error / points[i].Error);
      return { before.Seconds * std::pow(points[i].Seconds / before.Seconds, fraction),
        before.Seconds.Runs };
    }
  }
  return points.back().Seconds;
}

void AddEqualErrorRow(const std::string& name, BenchRows& rows)
{
  const std::vector<BenchRow>& all = rows.Get();
  const auto ours = std::find_if(all.begin(), all.end(),
    [&](const BenchRow& row)
    { return row.Case == name && row.Method == Spacing && row.Parameter == 1.0; });
  const std::vector<Point> baselines = GetPoints(all, name, GpuShadowsBaseline);
  if (ours == all.end() || baselines.empty())
  {
    return;
  }
  BenchRow row = rows.Make(name, EqualError);
  row.SetError(MarcherNorm, *ours->Error);
  row.SetTimes(*ours->Seconds, GpuShadowsBaseline, GetSecondsAt(*ours->Error, baselines));
  row.Counts["at_least"] = baselines.back().Error > *ours->Error ? 1 : 0;
  rows.Add(row);
}

/**
 * Compares images under one light with those of a ray marcher that traces shadow rays in double
 * precision. Cases are `<scene>, scattering` (see MakeScattering) and `<scene>, shaded` (without
 * gpu-shadows, which has a different shading model). Methods:
 * - `spacing`: the parameter is the slice spacing relative to the default;
 * - `buffer`: the parameter is the size of the light buffer;
 * - `gpu-shadows`: the parameter is the sample distance in voxels.
 *
 * Rows of method `equal-error` have the time and error of the default settings. Their peer_seconds
 * is the time of gpu-shadows at the same error, interpolated between its points in the log-log
 * plot. If gpu-shadows does not reach this error, peer_seconds is the time at its smallest error,
 * and the count at_least is 1.
 */
void AddErrorRows(const BenchOptions& options, BenchRows& rows)
{
  const std::vector<Case> cases = MakeErrorCases(options);
  reference::VolumeStage stage(cases.front().Scene.Size);
  for (const Case& what : cases)
  {
    const std::string scattering = what.Name + Scattering;
    AddSceneRows(stage, scattering, MakeScatteringCase(what).Scene, true, options, rows);
    AddEqualErrorRow(scattering, rows);
    AddSceneRows(stage, what.Name + Shaded, what.Scene, false, options, rows);
  }
}

std::vector<BenchClaim> CheckErrorClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtLeast(
    std::string("at equal error at least 5 times faster than ") + GpuShadowsBaseline, 5.0, rows,
    RatioOf(EqualError)) };
}

std::vector<BenchPlot> MakeErrorPlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const BenchRow& row : rows)
  {
    if (!row.Error || row.Method == EqualError)
    {
      continue;
    }
    BenchPlot& plot = FindOrAdd(plots,
      BenchPlot::OfErrors("shadows-error-" + row.Case.substr(0, row.Case.find('-')) +
          (row.Case.find(Scattering) == std::string::npos ? "-shaded" : "-scattering"),
        row.Case + ": error against run time, one light", "time of a frame (s)",
        std::string("error: ") + MarcherNorm,
        "Which slice spacing and light buffer size are required (" + row.Case + ")?",
        "Labels are the slice spacing relative to the default, columns of the light buffer, or, "
        "with VTK 9.2 and later, the sample distance of the baseline in voxels. The reference is a "
        "ray marcher in double precision."));
    plot.AddRow(row, row.Method == GpuShadowsBaseline);
    if (row.Method == Spacing && row.Parameter == 1.0)
    {
      plot.SetDefault(row.Method, row.GetParameterText());
    }
  }
  return plots;
}
}

BenchPart MakeErrorPart()
{
  return { AddErrorRows, MakeErrorPlots, CheckErrorClaims };
}
}
