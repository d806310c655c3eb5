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
const char* const Norm = "mean distance of the ends from the streamlines";
constexpr double DefaultTolerance = 1e-6;
/// vtkStreamTracer's points are in single precision on images, which rounds places near 1 by that.
constexpr double TracerRounding = 3e-8;

/// What an answer costs, and how good it is.
struct Trial
{
  double Parameter = 0.0;
  BenchSeconds Seconds;
  Answer Found;
  Difference Apart;
};

BenchWork MakeAdvection(const Case& what, double tolerance)
{
  return [&what, tolerance]()
  {
    const auto filter = NewAdvection(what, vtkImplicitFlowField::AUTOMATIC, tolerance);
    filter->Update();
    return vtkSmartPointer<vtkObjectBase>(filter);
  };
}

/// Without what is done before the first step, as far as clocks tell the two apart.
double StepsPerSecond(vtkIdType steps, double seconds, double setup)
{
  return static_cast<double>(steps) / std::max(seconds - setup, 0.01 * seconds);
}

/// All rows of one case.
class CaseRows
{
public:
  CaseRows(const Case& what, const BenchOptions& options, BenchRows& rows)
    : What(what)
    , Options(options)
    , Rows(rows)
    , Exact(Reference::OfInterpolation(what))
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
      const auto filter = NewAdvection(this->What, vtkImplicitFlowField::AUTOMATIC, tolerance);
      Trial trial;
      trial.Parameter = tolerance;
      trial.Seconds = RunOnce(filter);
      trial.Found = ReadAdvection(this->What, filter);
      trial.Apart = this->Exact.Compare(trial.Found, this->Stride);
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
      const Trial equal = this->AddPeer(settings, std::max(2.0 * best.Apart.Mean, TracerRounding));
      settings.Parameter = equal.Parameter;
      this->AddEqual(best, settings, equal);
    }
  }

private:
  void AddTrial(const std::string& method, const Trial& trial)
  {
    BenchRow row = this->Rows.Make(this->What.Name, method, trial.Parameter);
    row.Seconds = trial.Seconds;
    row.SetError(Norm, trial.Apart.Mean);
    row.Set({ { "steps", trial.Found.Steps }, { "time_error", trial.Apart.Time },
      { "steps_per_second", static_cast<double>(trial.Found.Steps) / trial.Seconds } });
    this->Rows.Add(row);
  }

  /// Until the error is small enough, or as long as that gets anywhere.
  Trial AddPeer(TracerSettings settings, double wanted)
  {
    const bool isAdaptive = settings.Integrator == vtkStreamTracer::RUNGE_KUTTA45;
    const int most = this->Options.Pick(isAdaptive ? 10 : 8, isAdaptive ? 8 : 6, 2);
    settings.Search =
      this->What.IsLattice ? CellSearch::CLOSEST_POINT : CellSearch::STATIC_CELL_LOCATOR;
    settings.Parameter = isAdaptive ? 1e-4 : 0.5;
    Trial trial;
    for (int i = 0; i < most; ++i)
    {
      const auto tracer = NewTracer(this->What, settings);
      trial.Parameter = settings.Parameter;
      trial.Seconds = RunOnce(tracer);
      trial.Found = ReadTracer(this->What, tracer);
      trial.Apart = this->Exact.Compare(trial.Found, this->Stride);
      this->AddTrial(settings.GetName(), trial);
      if (trial.Apart.Mean <= wanted)
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
      this->What.IsLattice ? CellSearch::CLOSEST_POINT : CellSearch::STATIC_CELL_LOCATOR;
    // What is made of the field first, such as faces and locators, shows with one streamline.
    Case one = this->What;
    one.Seeds = MakeSeeds(1, 0.01, this->Options.Seed);
    if (!this->What.IsLattice)
    {
      this->AddAgain(own, settings, other);
    }
    const std::vector<BenchSeconds> seconds =
      MeasureAlternately({ WithThreads(1, MakeAdvection(this->What, DefaultTolerance)),
                           MakeTracing(this->What, settings), MakeAdvection(one, DefaultTolerance),
                           MakeTracing(one, settings) },
        3);
    BenchRow row = this->Rows.Make(this->What.Name, EqualError, DefaultTolerance);
    row.SetError(Norm, own.Apart.Mean);
    row.SetTimes(seconds[0], std::string(Peer) + "-" + settings.GetName(), seconds[1]);
    const auto samples = static_cast<double>(this->What.Seeds->GetNumberOfPoints());
    const double rate = StepsPerSecond(own.Found.Steps, seconds[0].Processor, seconds[2].Processor);
    const double peerRate =
      StepsPerSecond(other.Found.Steps, seconds[1].Processor, seconds[3].Processor);
    row.Set({ { "steps", own.Found.Steps }, { "steps_per_second", rate },
      { "samples_per_second", samples / seconds[0] }, { "processor_seconds", seconds[0].Processor },
      { "setup_seconds", seconds[2].Value }, { "time_error", own.Apart.Time },
      { "peer_processor_seconds", seconds[1].Processor },
      { "peer_setup_seconds", seconds[3].Value }, { "peer_parameter", other.Parameter },
      { "peer_error", other.Apart.Mean }, { "peer_time_error", other.Apart.Time },
      { "peer_steps", other.Found.Steps }, { "peer_steps_per_second", peerRate },
      { "peer_samples_per_second", samples / seconds[1] },
      { "steps_per_second_ratio", rate / peerRate } });
    this->Rows.Add(row);
  }

  /// What is found of the faces of a mesh is kept.
  void AddAgain(const Trial& own, const TracerSettings& settings, const Trial& other)
  {
    const auto known = NewAdvection(this->What, vtkImplicitFlowField::AUTOMATIC, DefaultTolerance);
    known->Update();
    const std::vector<BenchSeconds> seconds = MeasureAlternately(
      { WithThreads(1, Again(known)), WithThreads(1, MakeTracing(this->What, settings)) }, 3);
    BenchRow row = this->Rows.Make(this->What.Name, EqualAgain, DefaultTolerance);
    row.SetError(Norm, own.Apart.Mean);
    row.SetTimes(seconds[0], std::string(Peer) + "-" + settings.GetName(), seconds[1]);
    row.Set({ { "processor_seconds", seconds[0].Processor },
      { "peer_processor_seconds", seconds[1].Processor },
      { "kept_faces", GetCount(known->GetReport(), "ReusedFaceMatches") },
      { "peer_error", other.Apart.Mean } });
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
  MeasureSecondThread(MakeAdvection(what, DefaultTolerance), options, row);
  rows.Add(row);
}

/// The number of rows of equal error on images, or on other grids.
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
 * Streamlines of ABC flow to a box, by one thread. Methods:
 * - `advection`, and the peer's `RK4` and `RK45`: error against run time, the parameter being
 *   MaximumError over the largest speed, the step in cells, and MaximumError;
 * - `equal-error`: the default of the advection against the peers `streamtracer-RK4` and
 *   `streamtracer-RK45` at the first of their settings, halved or divided by ten each time, of an
 *   error no more than twice that of the advection;
 * - `threads-2`: two threads against one.
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
        "mean distance from the streamline", "Which tolerance for streamlines on " + row.Case + "?",
        "vtkImplicitFlowField by tolerance over the largest speed, vtkStreamTracer by its steps "
        "and tolerances; ends against streamlines of the interpolation in double precision."));
    plot.AddRow(row, !isOwn, isOwn ? row.Method : std::string(Peer) + " " + row.Method);
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
