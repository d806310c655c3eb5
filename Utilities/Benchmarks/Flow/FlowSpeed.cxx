// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Flow/FlowCases.h"
#include "Benchmarks/Flow/FlowMethods.h"
#include "Benchmarks/Flow/FlowReference.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/SecondThread.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace flow
{
namespace
{
const char* const Advection = "advection";
const char* const EqualError = "equal-error";
const char* const EqualAgain = "equal-error-again";
constexpr double DefaultTolerance = 1e-6;
/// Rounding error of vtkStreamTracer's points at coordinates near 1. On images, the points have
/// single precision.
constexpr double TracerRounding = 3e-8;

/// The parameter, times, endpoints and error of one run.
struct Trial
{
  double Parameter = 0.0;
  BenchSeconds Seconds;
  MethodResult Found;
  Difference Deviation;
};

BenchWork MakeAdvection(const Case& what, double tolerance)
{
  return [&what, tolerance]()
  {
    const auto filter = NewFlowField(what, vtkImplicitFlowField::AUTOMATIC, tolerance);
    filter->Update();
    return vtkSmartPointer<vtkObjectBase>(filter);
  };
}

/// Returns the steps per second, excluding the setup time. In short runs, the measured setup time
/// may exceed the total.
double StepsPerSecond(vtkIdType steps, double seconds, double setup)
{
  return static_cast<double>(steps) / std::max(seconds - setup, 0.01 * seconds);
}

/// Adds all rows of one case.
class CaseRows
{
public:
  CaseRows(const Case& what, const BenchOptions& options, BenchRows& rows)
    : What(what)
    , Options(options)
    , Rows(rows)
    , Exact(Reference::FromInterpolatedField(what))
    , Stride(std::max<vtkIdType>(1, what.Seeds->GetNumberOfPoints() / options.Pick(200, 20, 4)))
  {
  }

  void Add()
  {
    Trial best;
    for (const double tolerance :
      this->Options.Pick<std::vector<double>>({ 1e-2, 1e-4, DefaultTolerance, 1e-8, 1e-10 },
        { 1e-2, DefaultTolerance, 1e-10 }, { DefaultTolerance, 1e-9 }))
    {
      const auto filter = NewFlowField(this->What, vtkImplicitFlowField::AUTOMATIC, tolerance);
      Trial trial;
      trial.Parameter = tolerance;
      trial.Seconds = TimeWithOneThread(filter);
      trial.Found = GetFlowFieldResult(this->What, filter);
      trial.Deviation = this->Exact.Compare(trial.Found, this->Stride);
      this->AddTrial(Advection, trial);
      if (tolerance == DefaultTolerance)
      {
        best = trial;
      }
    }
    for (const int integrator : { vtkStreamTracer::RUNGE_KUTTA4, vtkStreamTracer::RUNGE_KUTTA45 })
    {
      TracerSettings settings;
      settings.Integrator = integrator;
      const Trial equal =
        this->AddBaseline(settings, std::max(2.0 * best.Deviation.Mean, TracerRounding));
      settings.Parameter = equal.Parameter;
      this->AddEqual(best, settings, equal);
    }
  }

private:
  void AddTrial(const std::string& method, const Trial& trial)
  {
    BenchRow row = this->Rows.Make(this->What.Name, method, trial.Parameter);
    row.Seconds = trial.Seconds;
    row.SetError(Norm, trial.Deviation.Mean);
    row.Set({ { "steps", trial.Found.Steps }, { "time_error", trial.Deviation.Time },
      { "steps_per_second", static_cast<double>(trial.Found.Steps) / trial.Seconds } });
    this->Rows.Add(row);
  }

  /// Runs the tracer with finer and finer settings until its error is at most \a target or the
  /// maximum number of runs is reached.
  Trial AddBaseline(TracerSettings settings, double target)
  {
    const bool isAdaptive = settings.Integrator == vtkStreamTracer::RUNGE_KUTTA45;
    const int maximumRuns = this->Options.Pick(isAdaptive ? 10 : 8, isAdaptive ? 8 : 6, 2);
    settings.Search =
      this->What.IsBoxGrid ? CellSearch::CLOSEST_POINT : CellSearch::STATIC_CELL_LOCATOR;
    settings.Parameter = isAdaptive ? 1e-4 : 0.5;
    Trial trial;
    for (int i = 0; i < maximumRuns; ++i)
    {
      const auto tracer = NewTracer(this->What, settings);
      trial.Parameter = settings.Parameter;
      trial.Seconds = TimeWithOneThread(tracer);
      trial.Found = GetTracerResult(this->What, tracer);
      trial.Deviation = this->Exact.Compare(trial.Found, this->Stride);
      this->AddTrial(settings.GetName(), trial);
      if (trial.Deviation.Mean <= target)
      {
        break;
      }
      settings.Parameter *= isAdaptive ? 0.1 : 0.5;
    }
    return trial;
  }

  void AddEqual(const Trial& own, TracerSettings settings, const Trial& other)
  {
    settings.Search =
      this->What.IsBoxGrid ? CellSearch::CLOSEST_POINT : CellSearch::STATIC_CELL_LOCATOR;
    // A run with one streamline shows the time for preprocessing, such as matching faces and
    // building locators.
    Case one = this->What;
    one.Seeds = MakeSeeds(1, 0.01, this->Options.Seed);
    if (!this->What.IsBoxGrid)
    {
      this->AddAgain(own, settings, other);
    }
    const std::vector<BenchSeconds> seconds =
      MeasureAlternately({ WithThreads(1, MakeAdvection(this->What, DefaultTolerance)),
                           MakeTracerWork(this->What, settings),
                           MakeAdvection(one, DefaultTolerance), MakeTracerWork(one, settings) },
        3);
    BenchRow row = this->Rows.Make(this->What.Name, EqualError, DefaultTolerance);
    row.SetError(Norm, own.Deviation.Mean);
    row.SetTimes(seconds[0], std::string(Baseline) + "-" + settings.GetName(), seconds[1]);
    const auto samples = static_cast<double>(this->What.Seeds->GetNumberOfPoints());
    const double rate = StepsPerSecond(own.Found.Steps, seconds[0].Processor, seconds[2].Processor);
    const double baselineRate =
      StepsPerSecond(other.Found.Steps, seconds[1].Processor, seconds[3].Processor);
    row.Set({ { "steps", own.Found.Steps }, { "steps_per_second", rate },
      { "samples_per_second", samples / seconds[0] }, { "processor_seconds", seconds[0].Processor },
      { "setup_seconds", seconds[2].Value }, { "time_error", own.Deviation.Time },
      { "peer_processor_seconds", seconds[1].Processor },
      { "peer_setup_seconds", seconds[3].Value }, { "peer_parameter", other.Parameter },
      { "peer_error", other.Deviation.Mean }, { "peer_time_error", other.Deviation.Time },
      { "peer_steps", other.Found.Steps }, { "peer_steps_per_second", baselineRate },
      { "peer_samples_per_second", samples / seconds[1] },
      { "steps_per_second_ratio", rate / baselineRate } });
    this->Rows.Add(row);
  }

  /// Adds a row for a second execution, which reuses the face matches of the mesh.
  void AddAgain(const Trial& own, const TracerSettings& settings, const Trial& other)
  {
    const auto filter = NewFlowField(this->What, vtkImplicitFlowField::AUTOMATIC, DefaultTolerance);
    filter->Update();
    const std::vector<BenchSeconds> seconds =
      MeasureAlternately({ WithThreads(1, MakeRerunWork(filter)),
                           WithThreads(1, MakeTracerWork(this->What, settings)) },
        3);
    BenchRow row = this->Rows.Make(this->What.Name, EqualAgain, DefaultTolerance);
    row.SetError(Norm, own.Deviation.Mean);
    row.SetTimes(seconds[0], std::string(Baseline) + "-" + settings.GetName(), seconds[1]);
    row.Set({ { "processor_seconds", seconds[0].Processor },
      { "peer_processor_seconds", seconds[1].Processor },
      { "kept_faces", filter->GetReport()->GetCount("ReusedFaceMatches") },
      { "peer_error", other.Deviation.Mean } });
    this->Rows.Add(row);
  }

  const Case& What;
  const BenchOptions& Options;
  BenchRows& Rows;
  const Reference Exact;
  const vtkIdType Stride;
};

void AddSecondThread(Case what, const BenchOptions& options, BenchRows& rows)
{
  what.Seeds = MakeSeeds(options.Pick(20000, 2000, 50), 0.9, options.Seed);
  BenchRow row = rows.Make(what.Name, "threads-2");
  MeasureTwoThreads(MakeAdvection(what, DefaultTolerance), options, row);
  rows.Add(row);
}

/// Returns a function that evaluates \a number for rows of method `equal-error`, either on images
/// or on other grids.
template <typename Number>
std::function<std::optional<double>(const BenchRow&)> OfEqualError(bool isImage, Number number)
{
  return [isImage, number](const BenchRow& row) -> std::optional<double>
  {
    if (row.Method != EqualError || (row.Case.rfind("image", 0) == 0) != isImage)
    {
      return std::nullopt;
    }
    return number(row);
  };
}

/**
 * Measures streamlines of ABC flow from seeds to a box, with one thread unless stated otherwise.
 * Methods:
 * - `advection`, and `RK4` and `RK45` of the baseline: error against run time. The parameters are
 *   MaximumError divided by the maximum speed for `advection`, the step in cells for `RK4`, and
 *   MaximumError for `RK45`;
 * - `equal-error`: the default settings of `advection`. The baselines `streamtracer-RK4` and
 *   `streamtracer-RK45` use the first of their settings whose error is at most twice as large. From
 *   one setting to the next, the step is halved or MaximumError is divided by ten;
 * - `threads-2`: two threads relative to one.
 */
void AddSpeedRows(const BenchOptions& options, BenchRows& rows)
{
  const std::vector<Case> cases = MakeSpeedCases(options);
  for (const Case& what : cases)
  {
    CaseRows(what, options, rows).Add();
  }
  AddSecondThread(cases.front(), options, rows);
}

std::vector<BenchClaim> CheckSpeedClaims(const std::vector<BenchRow>& rows)
{
  const auto ratio = [](const BenchRow& row) { return *row.GetRatio(); };
  return {
    BenchClaim::AtLeast(
      "at least 8 times as many samples a second as streamtracer at equal error, images, 1 thread",
      8.0, rows, OfEqualError(true, ratio)),
    BenchClaim::AtLeast("at least 4 times as many samples a second as streamtracer at equal error, "
                        "unstructured grids, 1 thread",
      4.0, rows, OfEqualError(false, ratio)),
    BenchClaim::AtLeast("at least 8 times as many samples a second as streamtracer at equal error, "
                        "unstructured grids, executed again, 1 thread",
      8.0, rows, RatioOf(EqualAgain)),
    BenchClaim::AtLeast(
      "a second thread: at least 1.8 times faster", 1.8, rows, RatioOf("threads-2")),
  };
}

std::vector<BenchPlot> MakeSpeedPlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const BenchRow& row : rows)
  {
    const bool isOwn = row.Method == Advection;
    if (!isOwn && row.Method != "RK4" && row.Method != "RK45")
    {
      continue;
    }
    BenchPlot& plot = FindOrAdd(plots,
      BenchPlot::OfErrors("flow-error-" + row.Case,
        "Streamlines of ABC flow, " + row.Case + ", 1 thread", "run time (s)",
        "mean distance from the streamline",
        "Which tolerance is required for streamlines on " + row.Case + "?",
        "vtkImplicitFlowField: labels are tolerances divided by the maximum speed. "
        "vtkStreamTracer: labels are steps or tolerances. The reference is streamlines of the "
        "interpolated field in double precision."));
    plot.AddRow(row, !isOwn, isOwn ? row.Method : std::string(Baseline) + " " + row.Method);
    if (isOwn && row.Parameter.get<double>() == DefaultTolerance)
    {
      plot.SetDefault(row.Method, row.GetParameterText());
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
