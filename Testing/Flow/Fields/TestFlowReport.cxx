// SPDX-License-Identifier: BSD-3-Clause
// interlume::FlowReport: contributions of samples and of other reports, and the published values.
#include "Support/Checks/ReferenceCheck.h"

#include "Advection/AdvectionOptions.h"
#include "Streams/FlowReport.h"

#include "vtkInterlumeReport.h"
#include "vtkNew.h"

namespace
{

using namespace reference;

/// Returns a report of two samples that reached a surface and one sample that did not. Each counter
/// has a different value.
interlume::FlowReport MakeReport()
{
  interlume::AdvectionResult result;
  result.Status = vtkFlowStatus::REACHED_SURFACE;
  result.Id = 7;
  result.Steps = 11;
  result.RejectedSteps = 12;
  result.StiffSteps = 13;
  result.RejectedStiffSteps = 14;
  result.Evaluations = 15;
  result.JacobianEvaluations = 16;
  result.DistanceEvaluations = 17;
  result.Cells = 18;
  result.Nearness = 0.5;
  interlume::FlowReport report;
  report.Add(result);
  result.StiffSteps = 0;
  result.Nearness = 0.0;
  report.Add(result);
  interlume::AdvectionResult left;
  left.Status = vtkFlowStatus::LEFT_DOMAIN;
  report.Add(left);
  return report;
}

void CheckValues(const interlume::FlowReport& report, int times, Check& check)
{
  vtkNew<vtkInterlumeReport> values;
  report.CopyTo(values);
  const auto expect = [&](const char* name, int number, int entry = 0)
  { check.Equal(values->GetCount(name, entry), number * times, name); };
  expect("Samples", 3);
  expect("Statuses", 2, vtkFlowStatus::REACHED_SURFACE);
  expect("Statuses", 1, vtkFlowStatus::LEFT_DOMAIN);
  expect("Statuses", 0, vtkFlowStatus::STAGNATED);
  expect("SamplesBySurface", 2);
  expect("ReachedWithinTolerance", 1);
  expect("Steps", 22);
  expect("RejectedSteps", 24);
  expect("StiffSteps", 13);
  expect("RejectedStiffSteps", 28);
  expect("StiffSamples", 1);
  expect("Evaluations", 30);
  expect("JacobianEvaluations", 32);
  expect("DistanceEvaluations", 34);
  expect("CellsVisited", 36);
  check.Equal(values->GetSize("SurfaceIds"), 1, "surfaces reached");
  check.Equal(values->GetCount("SurfaceIds"), 7, "the surface's id");
}

}

int TestFlowReport(int, char*[])
{
  Check check;
  interlume::FlowReport report = MakeReport();
  CheckValues(report, 1, check);
  report.Add(MakeReport());
  report.Add(MakeReport());
  CheckValues(report, 3, check);
  report.Executions = 41;
  report.MaximumError = 0.125;
  report.MinimumSpeed = 0.25;
  report.WholeFieldReason = "a reason";
  report.StepsPerProcess = { 5, 6 };
  report.Sampling.Time = { 0.5, 1.5, 2.5 };
  vtkNew<vtkInterlumeReport> values;
  report.CopyTo(values);
  check.Equal(values->GetCount("Executions"), 41, "executions");
  check.Near(values->GetNumber("MaximumError"), 0.125, 0.0, "error");
  check.Near(values->GetNumber("MinimumSpeed"), 0.25, 0.0, "speed");
  check.That(values->GetText("WholeFieldReason") == "a reason", "the reason");
  check.Equal(values->GetCount("StepsPerProcess", 1), 6, "steps of a process");
  check.Near(values->GetNumber("SamplingErrorTime", 2), 2.5, 0.0, "maximum time error");
  return check.Result();
}
