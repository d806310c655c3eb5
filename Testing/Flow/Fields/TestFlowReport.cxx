// SPDX-License-Identifier: BSD-3-Clause
// vtkFlowReport: what a sample adds, what another report adds, and what is printed.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"

#include "Advection/AdvectionOptions.h"
#include "vtkFlowReport.h"

#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace reference;

std::string Print(const vtkFlowReport& report)
{
  std::ostringstream text;
  report.Print(text, vtkIndent());
  return text.str();
}

/// Two samples that reached a surface, one that did not, no two numbers alike.
vtkFlowReport MakeReport()
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
  vtkFlowReport report;
  report.Add(result);
  result.StiffSteps = 0;
  result.Nearness = 0.0;
  report.Add(result);
  interlume::AdvectionResult left;
  left.Status = vtkFlowStatus::LEFT_DOMAIN;
  report.Add(left);
  return report;
}

void CheckLines(const vtkFlowReport& report, int times, Check& check)
{
  const auto line = [times](const std::string& name, int number)
  { return name + ": " + std::to_string(number * times) + "\n"; };
  CheckPrinted(Print(report),
    { line("Samples", 3), line("Samples, reached surface", 2), line("Samples, left domain", 1),
      line("Samples, stagnated", 0), line("Reached surface 7", 2),
      line("ReachedWithinTolerance", 1), line("\nSteps", 22), line("\nRejectedSteps", 24),
      line("\nStiffSteps", 13), line("RejectedStiffSteps", 28), line("StiffSamples", 1),
      line("\nEvaluations", 30), line("JacobianEvaluations", 32), line("DistanceEvaluations", 34),
      line("CellsVisited", 36) },
    check);
  check.Equal(report.Reached.size(), 1, "surfaces reached");
}

}

int TestFlowReport(int, char*[])
{
  Check check;
  vtkFlowReport report = MakeReport();
  CheckLines(report, 1, check);
  report.Add(MakeReport());
  report.Add(MakeReport());
  CheckLines(report, 3, check);
  report.Executions = 41;
  report.MaximumError = 0.125;
  report.MinimumSpeed = 0.25;
  CheckPrinted(
    Print(report), { "Executions: 41\n", "MaximumError: 0.125\n", "MinimumSpeed: 0.25\n" }, check);
  return check.Result();
}
