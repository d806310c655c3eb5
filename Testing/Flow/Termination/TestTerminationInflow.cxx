// SPDX-License-Identifier: BSD-3-Clause
// vtkTerminationInflow: the rectangle is perpendicular to the main axis of the flow, at the end
// where the flow enters, and as wide as the inflow, on every kind of grid. For forward streamlines,
// the rectangle is at the end where the flow leaves.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationInflow.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace reference;

/// Distance between the rectangle and the end of the field: half the width of one of 32 slabs.
constexpr double Inside = 4.0 / 64.0;

void CheckRectangle(vtkTerminationInflow* surface, int axis, double position, const double low[3],
  const double high[3], Check& check)
{
  check.That(surface->Update().empty(), "the rectangle is valid");
  double bounds[6];
  surface->GetBounds(bounds);
  for (int i = 0; i < 3; ++i)
  {
    check.Near(bounds[2 * i], i == axis ? position : low[i], 1e-9, "lower bound", 1.0);
    check.Near(bounds[2 * i + 1], i == axis ? position : high[i], 1e-9, "upper bound", 1.0);
  }
  const double* origin = surface->GetOrigin();
  const double* point1 = surface->GetPoint1();
  const int alongU = axis == 0 ? 1 : 0;
  check.Near(
    point1[alongU] - origin[alongU], high[alongU] - low[alongU], 1e-9, "u along x or y", 1.0);
  double normal[3];
  surface->EvaluateNormal(origin, normal);
  check.Near(normal[axis], 1.0, 1e-9, "normal along the positive axis", 1.0);
}

/// Uniform flow along each axis, in both directions.
void TestUniform(Check& check)
{
  const double low[3] = { 0.0, 0.0, 0.0 };
  const double high[3] = { 4.0, 4.0, 4.0 };
  for (const auto& grid : MakeFlowGrids())
  {
    for (int direction = 0; direction < 6; ++direction)
    {
      const int axis = direction / 2;
      const double sense = direction % 2 == 0 ? 1.0 : -1.0;
      check.SetContext(grid.first + ", direction " + std::to_string(direction));
      const auto vectors = AddVectors(grid.second,
        [axis, sense](const Vector&)
        {
          Vector v{ { 0.01, 0.02, 0.03 } };
          v[axis] = 2.0 * sense;
          return v;
        });
      vtkNew<vtkTerminationInflow> surface;
      check.That(
        surface->InitializeFromField(grid.second, vectors, true).empty(), "the rectangle is found");
      CheckRectangle(surface, axis, sense > 0.0 ? Inside : 4.0 - Inside, low, high, check);
      check.That(surface->InitializeFromField(grid.second, vectors, false).empty(),
        "the rectangle is found for forward streamlines");
      CheckRectangle(surface, axis, sense > 0.0 ? 4.0 - Inside : Inside, low, high, check);
    }
  }
}

/// A jet through a part of the inlet, the same with a rectangle of half the size, and a flow whose
/// rate increases downstream.
void TestParts(Check& check)
{
  check.SetContext("jet");
  const auto image = MakeFlowImage(9,
    [](const Vector& x) {
      return Vector{ { 0.0, 0.0, x[0] <= 2.0 ? 1.0 : 0.0 } };
    });
  vtkNew<vtkTerminationInflow> surface;
  surface->InitializeFromField(image, image->GetPointData()->GetVectors(), true);
  // In the cells with x from 2 to 2.5, only the points at x = 2 have flow.
  const double low[3] = { 0.0, 0.0, 0.0 };
  const double high[3] = { 2.5, 4.0, 4.0 };
  CheckRectangle(surface, 2, Inside, low, high, check);
  surface->SetSize(0.5);
  surface->InitializeFromField(image, image->GetPointData()->GetVectors(), true);
  const double halfLow[3] = { 0.625, 1.0, 0.0 };
  const double halfHigh[3] = { 1.875, 3.0, 4.0 };
  CheckRectangle(surface, 2, Inside, halfLow, halfHigh, check);
  check.SetContext("little flow at the inlet");
  // The speed is 0.1 before x = 2 and 1 after it. It is linear in the cell in between.
  const auto widening = MakeFlowImage(33,
    [](const Vector& x) {
      return Vector{ { x[0] < 2.0 ? 0.1 : 1.0, 0.0, 0.0 } };
    });
  surface->SetSize(1.0);
  surface->InitializeFromField(widening, widening->GetPointData()->GetVectors(), true);
  double bounds[6];
  surface->GetBounds(bounds);
  check.That(bounds[0] > 1.8 && bounds[0] < 2.1, "the rectangle is where the flow rate is high");
}

/// Fields without flow, and fields with NaN.
void TestBad(Check& check)
{
  check.SetContext("bad fields");
  const auto still = MakeFlowImage(5, [](const Vector&) { return Vector{}; });
  vtkNew<vtkTerminationInflow> surface;
  check.Contains(surface->InitializeFromField(still, still->GetPointData()->GetVectors(), true),
    "field has no flow");
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  const auto holes = MakeFlowImage(9,
    [notANumber](const Vector& x) {
      return Vector{ { x[1] > 3.6 ? notANumber : 1.0, 0.0, 0.0 } };
    });
  check.That(surface->InitializeFromField(holes, holes->GetPointData()->GetVectors(), true).empty(),
    "NaN is ignored");
  const double low[3] = { 0.0, 0.0, 0.0 };
  const double high[3] = { 0.0, 3.5, 4.0 };
  CheckRectangle(surface, 0, Inside, low, high, check);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(still);
  filter->AddTerminationSurface(surface);
  check.Contains(UpdateAndGetErrors(filter), "field has no flow");
}

/// The filter places the surface depending on the field and on Direction, and executes only once
/// when Direction changes.
void TestFilter(Check& check)
{
  check.SetContext("filter");
  const auto image = MakeFlowImage(9, [](const Vector&) { return Vector{ { 0.5, 0.0, 0.0 } }; });
  vtkNew<vtkTerminationInflow> surface;
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  filter->AddTerminationSurface(surface);
  for (const int direction : { vtkImplicitFlowField::BACKWARD, vtkImplicitFlowField::FORWARD })
  {
    filter->SetDirection(direction);
    filter->Update();
    const vtkIdType executions = filter->GetReport()->GetNumber("Executions");
    filter->Update();
    check.Equal(filter->GetReport()->GetCount("Executions"), executions, "no further execution");
    vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    const bool isBackward = direction == vtkImplicitFlowField::BACKWARD;
    for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
    {
      const double distance =
        isBackward ? output->GetPoint(p)[0] - Inside : 4.0 - Inside - output->GetPoint(p)[0];
      const double status = output->GetPointData()->GetArray("FlowStatus")->GetComponent(p, 0);
      check.That((status == vtkFlowStatus::REACHED_SURFACE) == (distance > 0.0),
        "samples that reach the surface");
      if (distance > 0.0)
      {
        check.Near(output->GetPointData()->GetArray("AdvectionTime")->GetComponent(p, 0),
          2.0 * distance, 1e-9, "advection time", 1.0);
      }
    }
  }
}
}

int TestTerminationInflow(int, char*[])
{
  return RunChecks({ TestUniform, TestParts, TestBad, TestFilter });
}
