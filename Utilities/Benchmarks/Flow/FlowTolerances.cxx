// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Suites/BenchParts.h"

#include "Benchmarks/Flow/FlowFields.h"
#include "Benchmarks/Flow/FlowMethods.h"
#include "Benchmarks/Measures/BenchTiming.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace flow
{
namespace
{
const char* const Automatic = "automatic";
constexpr double ClaimedTolerance = 1e-6;

const std::vector<std::pair<int, const char*>> Integrators = { { vtkImplicitFlowField::AUTOMATIC,
                                                                 Automatic },
  { vtkImplicitFlowField::DORMAND_PRINCE, "dormand-prince" },
  { vtkImplicitFlowField::RUNGE_KUTTA_4, "runge-kutta-4" },
  { vtkImplicitFlowField::ROSENBROCK, "rosenbrock" } };

/// vtkImplicitFlowField with one integrator and one tolerance.
struct OwnTrial
{
  vtkSmartPointer<vtkImplicitFlowField> Filter;
  BenchRow Row;
};

/// vtkStreamTracer with one integrator and one step or tolerance.
struct BaselineTrial
{
  TracerSettings Settings;
  BenchRow Row;
};

/// Measures median times of all trials and baselines, run alternately after one untimed run each.
/// Stiff cases take seconds, so each trial is run only once, and there are no baselines.
void Measure(const FieldCase& field, const BenchOptions& options, std::vector<OwnTrial>& trials,
  std::vector<BaselineTrial>& baselines)
{
  std::vector<BenchWork> works;
  for (OwnTrial& trial : trials)
  {
    trial.Row.Seconds = TimeWithOneThread(trial.Filter);
    works.push_back(WithThreads(1, MakeRerunWork(trial.Filter)));
  }
  if (field.IsStiff)
  {
    return;
  }
  for (const BaselineTrial& trial : baselines)
  {
    works.push_back(WithThreads(1, MakeTracerWork(field.What, trial.Settings)));
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  for (std::size_t i = 0; i < trials.size(); ++i)
  {
    trials[i].Row.Seconds = seconds[i];
  }
  for (std::size_t i = 0; i < baselines.size(); ++i)
  {
    baselines[i].Row.Seconds = seconds[trials.size() + i];
  }
}

/// Sets the error of \a row, and the counts `answers`, `time_error` and `within`. \a error is the
/// error bound for Difference::Within; if it is 0, the count `within` is omitted.
void SetErrors(const FieldCase& field, const BenchOptions& options, const MethodResult& result,
  double error, BenchRow& row)
{
  const auto results = std::count_if(
    result.Ends.begin(), result.Ends.end(), [](const End& end) { return end.HasResult; });
  row.Counts["answers"] = results;
  if (results > 0)
  {
    const vtkIdType stride = field.IsStiff ? 1 : options.Pick(1, 4, 1);
    const Difference difference = field.Exact.Compare(result, stride, error);
    row.SetError(Norm, difference.Mean);
    row.Counts["time_error"] = difference.Time;
    if (error > 0.0)
    {
      row.Counts["within"] = difference.Within;
    }
  }
}

std::vector<OwnTrial> MakeOwnTrials(
  const FieldCase& field, const BenchOptions& options, const BenchRows& rows)
{
  const std::vector<double> all = { 1e-3, 1e-4, 1e-5, ClaimedTolerance, 1e-7, 1e-8, 1e-9, 1e-10 };
  const std::vector<double> some = { 1e-3, ClaimedTolerance, 1e-8, 1e-10 };
  const std::vector<double> few = { ClaimedTolerance, 1e-9 };
  const auto tolerances =
    field.IsStiff ? options.Pick(some, few, few) : options.Pick(all, some, few);
  std::vector<OwnTrial> trials;
  for (const auto& integrator : Integrators)
  {
    for (const double tolerance : tolerances)
    {
      const auto filter = NewFlowField(field.What, integrator.first, tolerance);
      if (field.IsStiff)
      {
        filter->SetMaximumError(tolerance);
      }
      trials.push_back({ filter, rows.Make(field.What.Name, integrator.second) });
      trials.back().Row.Parameter = tolerance;
    }
  }
  return trials;
}

void AddOwnRows(const FieldCase& field, const BenchOptions& options, std::vector<OwnTrial>& trials,
  BenchRows& rows)
{
  for (OwnTrial& trial : trials)
  {
    BenchRow& row = trial.Row;
    SetErrors(field, options, GetFlowFieldResult(field.What, trial.Filter),
      10.0 * trial.Filter->GetMaximumError(), row);
    vtkInterlumeReport* report = trial.Filter->GetReport();
    row.Set({ { "samples", report->GetCount("Samples") }, { "steps", report->GetCount("Steps") },
      { "stiff_steps", report->GetCount("StiffSteps") },
      { "rejected", report->GetCount("RejectedSteps") + report->GetCount("RejectedStiffSteps") },
      { "evaluations", report->GetCount("Evaluations") } });
    rows.Add(row);
  }
}

std::vector<BaselineTrial> MakeBaselineTrials(
  const FieldCase& field, const BenchOptions& options, const BenchRows& rows)
{
  const auto steps = options.Pick<std::vector<double>>(
    { 0.5, 0.25, 0.125, 0.0625, 0.03125 }, { 0.5, 0.125 }, { 0.5, 0.25 });
  const auto errors = options.Pick<std::vector<double>>(
    { 1e-4, 1e-6, 1e-8, 1e-10, 1e-12 }, { 1e-5, 1e-8 }, { 1e-5, 1e-7 });
  std::vector<BaselineTrial> trials;
  for (const int integrator : { vtkStreamTracer::RUNGE_KUTTA4, vtkStreamTracer::RUNGE_KUTTA45 })
  {
    for (const double parameter : integrator == vtkStreamTracer::RUNGE_KUTTA45 ? errors : steps)
    {
      TracerSettings settings;
      settings.Integrator = integrator;
      settings.Parameter = parameter;
      trials.push_back({ settings, rows.Make(field.What.Name, settings.GetName()) });
      trials.back().Row.Parameter = parameter;
    }
  }
  return trials;
}

void AddBaselineRows(const FieldCase& field, const BenchOptions& options,
  std::vector<BaselineTrial>& trials, BenchRows& rows)
{
  for (BaselineTrial& trial : trials)
  {
    const auto tracer = NewTracer(field.What, trial.Settings);
    tracer->Update();
    const MethodResult result = GetTracerResult(field.What, tracer);
    SetErrors(field, options, result, 0.0, trial.Row);
    trial.Row.Counts["steps"] = result.Steps;
    rows.Add(trial.Row);
  }
}

/**
 * Measures the cases of MakeFieldCases with one thread. Methods: each integrator of
 * vtkImplicitFlowField, with the tolerance as the parameter: MaximumError divided by the maximum
 * speed, or MaximumError itself in stiff fields. Fields that are not stiff also have rows for
 * vtkStreamTracer: `RK4` (parameter: step in cell lengths) and `RK45` (parameter: MaximumError).
 */
void AddToleranceRows(const BenchOptions& options, BenchRows& rows)
{
  for (const FieldCase& field : MakeFieldCases(options))
  {
    std::vector<OwnTrial> own = MakeOwnTrials(field, options, rows);
    std::vector<BaselineTrial> baselines;
    if (!field.IsStiff)
    {
      baselines = MakeBaselineTrials(field, options, rows);
    }
    Measure(field, options, own, baselines);
    AddOwnRows(field, options, own, rows);
    AddBaselineRows(field, options, baselines, rows);
  }
}

std::vector<BenchClaim> CheckToleranceClaims(const std::vector<BenchRow>& rows)
{
  return { BenchClaim::AtLeast(
    "at a tolerance of 1e-6, 99.9 % of the answers within 10 times of it, automatic", 0.999, rows,
    [](const BenchRow& row) -> std::optional<double>
    {
      return row.Method == Automatic && row.Parameter.get<double>() == ClaimedTolerance
        ? std::optional<double>(row.Counts.value("within", 0.0))
        : std::nullopt;
    }) };
}

std::vector<BenchPlot> MakeTolerancePlots(const std::vector<BenchRow>& rows)
{
  std::vector<BenchPlot> plots;
  for (const BenchRow& row : rows)
  {
    const bool isOwn = std::any_of(Integrators.begin(), Integrators.end(),
      [&row](const std::pair<int, const char*>& one) { return row.Method == one.second; });
    if (!isOwn && row.Method != "RK4" && row.Method != "RK45")
    {
      continue;
    }
    BenchPlot& plot = FindOrAdd(plots,
      BenchPlot::OfErrors("flow-tolerance-" + row.Case,
        "Place (u,v) of the end, " + row.Case + ", 1 thread", "run time (s)",
        "mean distance from the streamline (unit of length)",
        "Which integrator and tolerance locate the endpoint of a streamline (" + row.Case +
          ") accurately?",
        "vtkImplicitFlowField: labels are tolerances divided by the maximum speed. "
        "vtkStreamTracer: labels are steps or tolerances. Endpoints are compared with the exact "
        "streamlines."));
    plot.AddRow(row, !isOwn, isOwn ? row.Method : std::string(Baseline) + " " + row.Method);
    if (row.Method == Automatic && row.Parameter.get<double>() == ClaimedTolerance &&
      row.Case.rfind("stiff", 0) != 0)
    {
      plot.SetDefault(row.Method, row.GetParameterText());
    }
  }
  return plots;
}
}

BenchPart MakeTolerancePart()
{
  return { AddToleranceRows, MakeTolerancePlots, CheckToleranceClaims };
}
}
