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
const char* const Norm = "mean distance of the ends from the streamlines";
const char* const Automatic = "automatic";
constexpr double ClaimedTolerance = 1e-6;

const std::vector<std::pair<int, const char*>> Integrators = { { vtkImplicitFlowField::AUTOMATIC,
                                                                 Automatic },
  { vtkImplicitFlowField::DORMAND_PRINCE, "dormand-prince" },
  { vtkImplicitFlowField::RUNGE_KUTTA_4, "runge-kutta-4" },
  { vtkImplicitFlowField::ROSENBROCK, "rosenbrock" } };

/// One integrator at one tolerance.
struct OwnTrial
{
  vtkSmartPointer<vtkImplicitFlowField> Filter;
  BenchRow Row;
};

/// vtkStreamTracer at one of its settings.
struct PeerTrial
{
  TracerSettings Settings;
  BenchRow Row;
};

/// Median times, all trials in turn and those of the peer with them, after a run of each that is
/// not counted; a stiff case takes seconds, is run once, and has no peer.
void Measure(const FieldCase& field, const BenchOptions& options, std::vector<OwnTrial>& trials,
  std::vector<PeerTrial>& peers)
{
  std::vector<BenchWork> works;
  for (OwnTrial& trial : trials)
  {
    trial.Row.Seconds = RunOnce(trial.Filter);
    works.push_back(WithThreads(1, Again(trial.Filter)));
  }
  if (field.IsStiff)
  {
    return;
  }
  for (const PeerTrial& trial : peers)
  {
    works.push_back(WithThreads(1, MakeTracing(field.What, trial.Settings)));
  }
  const std::vector<BenchSeconds> seconds = MeasureAlternately(works, options.GetRepeats());
  for (std::size_t i = 0; i < trials.size(); ++i)
  {
    trials[i].Row.Seconds = seconds[i];
  }
  for (std::size_t i = 0; i < peers.size(); ++i)
  {
    peers[i].Row.Seconds = seconds[trials.size() + i];
  }
}

/// \a error: 0, or that of Difference::Within.
void SetErrors(const FieldCase& field, const BenchOptions& options, const Answer& answer,
  double error, BenchRow& row)
{
  const auto answers = std::count_if(
    answer.Ends.begin(), answer.Ends.end(), [](const End& end) { return end.HasAnswer; });
  row.Counts["answers"] = answers;
  if (answers > 0)
  {
    const vtkIdType stride = field.IsStiff ? 1 : options.Pick(1, 4, 1);
    const Difference apart = field.Exact.Compare(answer, stride, error);
    row.SetError(Norm, apart.Mean);
    row.Counts["time_error"] = apart.Time;
    if (error > 0.0)
    {
      row.Counts["within"] = apart.Within;
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
      const auto filter = NewAdvection(field.What, integrator.first, tolerance);
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
    SetErrors(field, options, ReadAdvection(field.What, trial.Filter),
      10.0 * trial.Filter->GetMaximumError(), row);
    vtkInterlumeReport* report = trial.Filter->GetReport();
    row.Set({ { "samples", GetCount(report, "Samples") }, { "steps", GetCount(report, "Steps") },
      { "stiff_steps", GetCount(report, "StiffSteps") },
      { "rejected", GetCount(report, "RejectedSteps") + GetCount(report, "RejectedStiffSteps") },
      { "evaluations", GetCount(report, "Evaluations") } });
    rows.Add(row);
  }
}

std::vector<PeerTrial> MakePeerTrials(
  const FieldCase& field, const BenchOptions& options, const BenchRows& rows)
{
  const auto steps = options.Pick<std::vector<double>>(
    { 0.5, 0.25, 0.125, 0.0625, 0.03125 }, { 0.5, 0.125 }, { 0.5, 0.25 });
  const auto errors = options.Pick<std::vector<double>>(
    { 1e-4, 1e-6, 1e-8, 1e-10, 1e-12 }, { 1e-5, 1e-8 }, { 1e-5, 1e-7 });
  std::vector<PeerTrial> trials;
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

void AddPeerRows(const FieldCase& field, const BenchOptions& options,
  std::vector<PeerTrial>& trials, BenchRows& rows)
{
  for (PeerTrial& trial : trials)
  {
    const auto tracer = NewTracer(field.What, trial.Settings);
    tracer->Update();
    const Answer answer = ReadTracer(field.What, tracer);
    SetErrors(field, options, answer, 0.0, trial.Row);
    trial.Row.Counts["steps"] = answer.Steps;
    rows.Add(trial.Row);
  }
}

/**
 * The cases of FlowFields, by one thread. Methods: each integrator of vtkImplicitFlowField at each
 * tolerance, which is the parameter: MaximumError over the largest speed, but in fields that are
 * stiff MaximumError; and, where the field is not stiff, the peer's `RK4` by step in cells and
 * `RK45` by MaximumError.
 */
void AddToleranceRows(const BenchOptions& options, BenchRows& rows)
{
  for (const FieldCase& field : MakeFieldCases(options))
  {
    std::vector<OwnTrial> own = MakeOwnTrials(field, options, rows);
    std::vector<PeerTrial> peers;
    if (!field.IsStiff)
    {
      peers = MakePeerTrials(field, options, rows);
    }
    Measure(field, options, own, peers);
    AddOwnRows(field, options, own, rows);
    AddPeerRows(field, options, peers, rows);
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
        "Which integrator, at which tolerance, for the place at which a streamline of " + row.Case +
          " ends?",
        "vtkImplicitFlowField at tolerances over the largest speed, vtkStreamTracer at steps and "
        "tolerances; ends against the streamlines themselves."));
    plot.AddRow(row, !isOwn, isOwn ? row.Method : std::string(Peer) + " " + row.Method);
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
