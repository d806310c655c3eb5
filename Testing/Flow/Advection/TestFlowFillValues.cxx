// SPDX-License-Identifier: BSD-3-Clause
// Speeds out of all proportion: automatic error and least speed leave fill values aside, and
// nothing else; the speeds themselves, and a field that holds some.
#include "Reference/Checks/ReferenceCheck.h"
#include "Reference/Checks/ReferenceMessages.h"
#include "Reference/Flow/ReferenceFlowGrid.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "Fields/SpeedScale.h"
#include "vtkTerminationInflow.h"
#include "vtkTerminationPlane.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{

using namespace reference;

/// \a number speeds, by their index.
void CheckScale(const std::string& name, int number, const std::function<double(int)>& speed,
  double scale, int fillValues, Check& check)
{
  interlume::SpeedScale first;
  interlume::SpeedScale second;
  for (int i = 0; i < number; ++i)
  {
    (i % 3 == 0 ? first : second).Add(speed(i));
  }
  first.Add(second);
  vtkIdType beyond = -1;
  check.That(first.GetScale(beyond) == scale, name + ": the scale");
  check.Equal(beyond, fillValues, name + ": fill values");
}

void TestScale(Check& check)
{
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  const auto filled = [](int first, double value)
  { return [first, value](int i) { return i < first ? value : 1.0 + i / 5000.0; }; };
  CheckScale("none", 0, filled(0, 0.0), 0.0, 0, check);
  CheckScale(
    "zeros", 100, [](int) { return 0.0; }, 0.0, 0, check);
  CheckScale("one", 1, filled(1, 7.0), 7.0, 0, check);
  CheckScale("plain", 5000, filled(0, 0.0), 1.0 + 4999 / 5000.0, 0, check);
  CheckScale("one fill value", 5000, filled(1, 1e30), 1.0 + 4999 / 5000.0, 1, check);
  CheckScale("fifty", 5000, filled(50, 1e30), 1.0 + 4999 / 5000.0, 50, check);
  CheckScale("too many to be left aside", 5000, filled(51, 1e30), 1e30, 0, check);
  CheckScale("a jet", 5000, filled(20, 500.0), 500.0, 0, check);
  CheckScale("one of eight", 8, filled(1, 17321.0), 1.0 + 7 / 5000.0, 1, check);
  CheckScale("one of seven", 7, filled(1, 17321.0), 17321.0, 0, check);
  CheckScale(
    "by and by", 5000, [](int i) { return std::pow(2.0, i / 50); }, std::pow(2.0, 99), 0, check);
  CheckScale(
    "among zeros", 5000, [](int i) { return i == 0 ? 1e20 : (i < 300 ? 3.0 : 0.0); }, 3.0, 1,
    check);
  CheckScale(
    "the least and the largest", 500, [tiny, huge](int i) { return i == 0 ? huge : tiny; }, tiny, 1,
    check);
  // Two kinds at once.
  CheckScale(
    "two kinds", 5000, [](int i) { return i == 0 ? 1e36 : (i == 1 ? 1e20 : 2.0); }, 2.0, 2, check);
}

/// A fill value in a corner changes no answer far from it, and is said.
void TestField(Check& check)
{
  auto image = MakeFlowImage(17,
    [](const Vector& x) {
      return Vector{ { 1.0, 0.1 * std::sin(x[2]), 0.0 } };
    });
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  filter->Update();
  vtkNew<vtkImageData> expected;
  expected->DeepCopy(filter->GetOutputDataObject(0));
  const double error = filter->GetReport().MaximumError;
  check.Equal(filter->GetReport().FillValues, 0, "fill values");
  const vtkIdType corner = image->GetNumberOfPoints() - 1;
  vtkDataArray* vectors = image->GetPointData()->GetVectors();
  vectors->SetTuple3(corner, 1e30, 1e30, 1e30);
  vectors->Modified();
  const std::string warning = WarningsOf(filter);
  check.That(warning.find("at 1 points") != std::string::npos, "a warning: " + warning);
  check.Equal(filter->GetReport().FillValues, 1, "fill values");
  check.That(filter->GetReport().MaximumError == error, "the error is as without");
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (const char* name : { "FlowStatus", "TerminationId", "AdvectionTime" })
  {
    vtkDataArray* found = output->GetPointData()->GetArray(name);
    vtkDataArray* other = expected->GetPointData()->GetArray(name);
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
    {
      const double* x = output->GetPoint(id);
      if (x[1] < 3.0 || x[2] < 3.0)
      {
        check.That(found->GetComponent(id, 0) == other->GetComponent(id, 0), name);
      }
    }
  }
  filter->SetMaximumError(error);
  filter->SetMinimumSpeed(1e-9);
  check.That(WarningsOf(filter).empty(), "nothing is said where nothing is automatic");
}

/// A surface that is placed by the flow is not drawn to a fill value.
void TestInflow(Check& check)
{
  auto image = MakeFlowImage(17,
    [](const Vector& x) {
      return Vector{ { 2.0 + std::sin(x[1]), 0.1, 0.0 } };
    });
  vtkDataArray* vectors = image->GetPointData()->GetVectors();
  double places[2][6];
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkTerminationInflow> inflow;
    check.That(
      inflow->PlaceIn(image, vectors, true).empty() && inflow->Update().empty(), "a place");
    inflow->GetBounds(places[i]);
    vectors->SetTuple3(image->GetNumberOfPoints() / 2, 0.0, 1e30, 0.0);
  }
  check.That(places[0][0] == places[1][0] && places[0][1] == places[1][1], "across the flow");
  check.That(places[1][1] < 1.0, "where it enters");
}

}

int TestFlowFillValues(int, char*[])
{
  Check check;
  TestScale(check);
  TestField(check);
  TestInflow(check);
  return check.Result();
}
