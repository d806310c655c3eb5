// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowSpeed.h"

#include "Benchmarks/Flow/FlowCases.h"
#include "Benchmarks/Flow/FlowMethods.h"
#include "Benchmarks/Flow/FlowReference.h"
#include "Benchmarks/Measures/BenchTiming.h"
#include "Benchmarks/Measures/ProcessorClock.h"
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
const char* const Again = "equal-error-again";
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

/// A filter that has executed before executes again on the same mesh.
BenchWork MakeAgain(vtkImplicitFlowField* filter)
{
  return [filter]()
  {
    filter->Modified();
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
    BenchRow row = this->Rows.Make(this->What.Name, method);
    row.Parameter = trial.Parameter;
    row.Seconds = trial.Seconds;
    row.Error = trial.Apart.Mean;
    row.ErrorNorm = Norm;
    row.Counts["steps"] = trial.Found.Steps;
    row.Counts["time_error"] = trial.Apart.Time;
    row.Counts["steps_per_second"] = static_cast<double>(trial.Found.Steps) / trial.Seconds;
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
    ProcessorClock clocks[4];
    const std::vector<BenchSeconds> seconds = MeasureAlternately(
      { WithThreads(1, clocks[0].Watch(MakeAdvection(this->What, DefaultTolerance))),
        clocks[1].Watch(MakeTracing(this->What, settings)),
        clocks[2].Watch(MakeAdvection(one, DefaultTolerance)),
        clocks[3].Watch(MakeTracing(one, settings)) },
      3);
    const double processor = clocks[0].Take();
    const double peerProcessor = clocks[1].Take();
    BenchRow row = this->Rows.Make(this->What.Name, EqualError);
    row.Parameter = DefaultTolerance;
    row.Error = own.Apart.Mean;
    row.ErrorNorm = Norm;
    row.Seconds = seconds[0];
    row.Peer = std::string(Peer) + "-" + settings.GetName();
    row.PeerSeconds = seconds[1];
    const auto samples = static_cast<double>(this->What.Seeds->GetNumberOfPoints());
    const double rate = StepsPerSecond(own.Found.Steps, processor, clocks[2].Take());
    const double peerRate = StepsPerSecond(other.Found.Steps, peerProcessor, clocks[3].Take());
    row.Counts["steps"] = own.Found.Steps;
    row.Counts["steps_per_second"] = rate;
    row.Counts["samples_per_second"] = samples / seconds[0];
    row.Counts["processor_seconds"] = processor;
    row.Counts["setup_seconds"] = seconds[2].Value;
    row.Counts["time_error"] = own.Apart.Time;
    row.Counts["peer_processor_seconds"] = peerProcessor;
    row.Counts["peer_setup_seconds"] = seconds[3].Value;
    row.Counts["peer_parameter"] = other.Parameter;
    row.Counts["peer_error"] = other.Apart.Mean;
    row.Counts["peer_time_error"] = other.Apart.Time;
    row.Counts["peer_steps"] = other.Found.Steps;
    row.Counts["peer_steps_per_second"] = peerRate;
    row.Counts["peer_samples_per_second"] = samples / seconds[1];
    row.Counts["steps_per_second_ratio"] = rate / peerRate;
    this->Rows.Add(row);
  }

  /// What is found of the faces of a mesh is kept.
  void AddAgain(const Trial& own, const TracerSettings& settings, const Trial& other)
  {
    const auto known = NewAdvection(this->What, vtkImplicitFlowField::AUTOMATIC, DefaultTolerance);
    known->Update();
    ProcessorClock clocks[2];
    const std::vector<BenchSeconds> seconds =
      MeasureAlternately({ WithThreads(1, clocks[0].Watch(MakeAgain(known))),
                           WithThreads(1, clocks[1].Watch(MakeTracing(this->What, settings))) },
        3);
    BenchRow row = this->Rows.Make(this->What.Name, Again);
    row.Parameter = DefaultTolerance;
    row.Error = own.Apart.Mean;
    row.ErrorNorm = Norm;
    row.Seconds = seconds[0];
    row.Peer = std::string(Peer) + "-" + settings.GetName();
    row.PeerSeconds = seconds[1];
    row.Counts["processor_seconds"] = clocks[0].Take().Value;
    row.Counts["peer_processor_seconds"] = clocks[1].Take().Value;
    row.Counts["kept_faces"] = known->GetReport().KeptFaces;
    row.Counts["peer_error"] = other.Apart.Mean;
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
}

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
    BenchClaim::AtLeast("at least 8 times as many samples a second as streamtracer at equal error, "
                        "images, 1 thread",
      8.0, rows, OfEqualError(true, ratio)),
    BenchClaim::AtLeast("at least 4 times as many samples a second as streamtracer at equal error, "
                        "unstructured grids, 1 thread",
      4.0, rows, OfEqualError(false, ratio)),
    BenchClaim::AtLeast("at least 8 times as many samples a second as streamtracer at equal error, "
                        "unstructured grids, executed again, 1 thread",
      8.0, rows,
      [](const BenchRow& row) -> std::optional<double>
      { return row.Method == Again ? row.GetRatio() : std::nullopt; }),
    BenchClaim::AtLeast("a second thread: at least 1.8 times faster", 1.8, rows,
      [](const BenchRow& row) -> std::optional<double>
      { return row.Method == "threads-2" ? row.GetRatio() : std::nullopt; }),
  };
}

std::vector<BenchPlot> MakeSpeedPlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const BenchRow& row : rows)
  {
    const bool isOwn = row.Method == Advection;
    const bool isPeer = row.Method == "RK4" || row.Method == "RK45";
    const bool isCase = std::any_of(rows.begin(), rows.end(),
      [&row](const BenchRow& other)
      { return other.Case == row.Case && other.Method == Advection; });
    if (!row.Error || !isCase || (!isOwn && !isPeer))
    {
      continue;
    }
    if (plots.empty() ||
      plots.back().Title != "Streamlines of ABC flow, " + row.Case + ", 1 thread")
    {
      plots.push_back(BenchPlot::OfErrors("flow-error-" + row.Case,
        "Streamlines of ABC flow, " + row.Case + ", 1 thread", "run time (s)",
        "mean distance from the streamline"));
      plots.back().Question = "Which tolerance for streamlines on " + row.Case + "?";
      plots.back().Conditions =
        "vtkImplicitFlowField by tolerance over the largest speed, vtkStreamTracer by its steps "
        "and tolerances; ends against streamlines of the interpolation in double precision.";
    }
    plots.back().AddPoint(isOwn ? row.Method : std::string(Peer) + " " + row.Method, !isOwn,
      *row.Seconds, *row.Error, row.GetParameterText());
    if (isOwn && row.Parameter.get<double>() == DefaultTolerance)
    {
      plots.back().SetDefault(row.Method, row.GetParameterText());
    }
  }
  return plots;
}
}
