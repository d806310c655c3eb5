// SPDX-License-Identifier: BSD-3-Clause
// Reports of sources: the number of points, evaluations and bytes follow from settings and types,
// for the full extent and for pieces, with any number of threads. Reports are empty after an error.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkConstructiveModelSource.h"
#include "vtkDeltaWingSource.h"
#include "vtkInterlumeReport.h"
#include "vtkNew.h"
#include "vtkTaperedCylinderSource.h"
#include "vtkTurbulenceSource.h"

#include <array>
#include <limits>

namespace
{

using namespace reference;

constexpr vtkIdType Points = 7 * 6 * 5;

/// Compares the report with the expected points, evaluations, bytes and time.
void CheckReport(
  vtkInterlumeReport* report, const std::array<double, 4>& expected, const char* name, Check& check)
{
  check.SetContext(name);
  const char* const names[] = { "Points", "Evaluations", "Bytes", "Time" };
  for (int i = 0; i < 4; ++i)
  {
    check.Near(report->GetNumber(names[i]), expected[i], 0.0, names[i]);
  }
}

void CheckImages(Check& check)
{
  vtkNew<vtkTurbulenceSource> turbulence;
  CheckReport(turbulence->GetReport(), {}, "before an execution", check);
  turbulence->SetDimensions(7, 6, 5);
  turbulence->Update();
  CheckReport(turbulence->GetReport(), { Points, Points, 4 * Points, 0.0 }, "turbulence", check);
  const int part[6] = { 1, 3, 0, 1, 2, 4 };
  turbulence->Modified();
  turbulence->UpdateExtent(part);
  CheckReport(turbulence->GetReport(), { 18, 18, 72, 0.0 }, "a piece of turbulence", check);

  vtkNew<vtkAnalyticFlowSource> flow;
  flow->SetDimensions(7, 6, 5);
  flow->SetField(vtkAnalyticFlowSource::SPHERE);
  flow->Update();
  CheckReport(flow->GetReport(), { Points, Points, 24 * Points, 0.0 }, "flow", check);
  flow->SetInside(vtkAnalyticFlowSource::HIDDEN);
  flow->Update();
  CheckReport(flow->GetReport(), { Points, Points, 25 * Points, 0.0 }, "hidden points", check);
  CheckPrinted(
    Print(flow), { "Report:", "  Points: 210", "  Evaluations: 210", "  Bytes: 5250" }, check);

  vtkNew<vtkAnalyticFieldSource> field;
  field->SetDimensions(7, 6, 5);
  field->SetOutputScalarType(VTK_DOUBLE);
  field->UpdateTimeStep(1.25);
  CheckReport(field->GetReport(), { Points, Points, 8 * Points, 1.25 }, "field", check);
}

void CheckVolumes(Check& check)
{
  vtkNew<vtkConstructiveModelSource> model;
  model->SetWholeExtent(0, 6, 0, 5, 0, 4);
  model->Update();
  CheckReport(model->GetReport(), { Points, Points, 4 * Points, 0.0 }, "density", check);
  model->SetNumberOfSubsamples(3);
  model->Update();
  CheckReport(model->GetReport(), { Points, 27 * Points, 4 * Points, 0.0 }, "subsamples", check);
  model->SetOutputModeToColorBytes();
  // The requested extent is enlarged by one layer of points, but not beyond the whole extent.
  const int part[6] = { 2, 3, 0, 1, 4, 4 };
  model->UpdateExtent(part);
  CheckReport(model->GetReport(), { 4, 27 * 4 * 3 * 2, 16, 0.0 },
    "colors require the surrounding points", check);
  model->SetRoot(nullptr);
  check.That(!UpdateAndGetErrors(model).empty(), "missing root");
  CheckReport(model->GetReport(), {}, "after an error", check);
}

void CheckGrids(Check& check)
{
  vtkNew<vtkDeltaWingSource> wing;
  wing->SetDimensions(7, 6, 5);
  wing->UpdateTimeStep(0.5);
  CheckReport(wing->GetReport(), { Points, Points, 16 * Points, 0.5 }, "floats", check);
  vtkNew<vtkTaperedCylinderSource> cylinder;
  cylinder->SetDimensions(7, 6, 5);
  cylinder->SetOutputScalarType(VTK_DOUBLE);
  cylinder->Update();
  CheckReport(cylinder->GetReport(), { Points, Points, 32 * Points, 0.0 }, "doubles", check);
  CheckPrinted(
    Print(cylinder), { "Report:", "  Points: 210", "  Bytes: 6720", "  Time: 0" }, check);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  check.Contains(
    CaptureErrors(cylinder, [&]() { cylinder->UpdateTimeStep(infinity); }), "not finite");
  CheckReport(cylinder->GetReport(), {}, "after an error", check);
}

}

int TestSourceReports(int, char*[])
{
  return RunChecks({ CheckImages, CheckVolumes, CheckGrids });
}
