// SPDX-License-Identifier: BSD-3-Clause
// Tests invalid input and settings. The filter must report an error that names the array and the
// value, have an empty output, and work again after correction.
#include "StabilityChecks.h"

#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkFieldData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnstructuredGrid.h"

#include <functional>

namespace
{

using namespace reference;
using namespace stability;

/// Returns a mesh with random scalars f and pressure, a vector array, a string array and a cell
/// array.
vtkSmartPointer<vtkUnstructuredGrid> MakeInput()
{
  auto mesh = MakeMesh(MeshKind::Mixed, { 2, 2, 2 });
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("velocity");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(mesh->GetNumberOfPoints());
  vectors->FillValue(0.5);
  mesh->GetPointData()->AddArray(vectors);
  vtkNew<vtkStringArray> text;
  text->SetName("label");
  text->SetNumberOfValues(mesh->GetNumberOfPoints());
  mesh->GetPointData()->AddArray(text);
  vtkNew<vtkDoubleArray> constants;
  constants->SetName("material");
  constants->SetNumberOfTuples(mesh->GetNumberOfPoints());
  constants->FillValue(0.5);
  mesh->GetFieldData()->AddArray(constants);
  AddRandomField(mesh, 2, "pressure");
  AddRandomField(mesh, 1);
  return mesh;
}

template <typename Filter>
struct ErrorCase
{
  const char* Name;
  const char* Extreme;
  std::vector<std::string> Words; ///< texts that the message must contain
  std::function<void(Filter*)> Break;
  std::function<void(Filter*)> Mend;
};

template <typename Filter>
void TestErrors(StabilityCatalogue& catalogue, const std::vector<ErrorCase<Filter>>& cases)
{
  for (const ErrorCase<Filter>& one : cases)
  {
    vtkNew<Filter> filter;
    filter->SetInputData(MakeInput());
    one.Mend(filter);
    one.Break(filter);
    catalogue.SetClass(filter->GetClassName());
    ReportRejection(catalogue, filter, std::string(filter->GetClassName()) + "-" + one.Name,
      one.Extreme, one.Words, [&]() { one.Mend(filter); });
  }
}

template <typename Filter>
void SetArray(Filter* filter, const char* name)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

/// Returns cases with invalid scalar arrays, for vtkIntervalVolume or vtkIsotableContour.
template <typename Filter>
std::vector<ErrorCase<Filter>> ArrayCases(const std::function<void(Filter*)>& set)
{
  auto mend = [set](Filter* filter)
  {
    SetArray(filter, "f");
    set(filter);
  };
  return { { "missing-array", "an array that does not exist", { "nosuch" },
             [](Filter* filter) { SetArray(filter, "nosuch"); }, mend },
    { "components", "a scalar with three components", { "velocity", "3" },
      [](Filter* filter) { SetArray(filter, "velocity"); }, mend },
    { "string-array", "a string array as scalar", { "label" },
      [](Filter* filter) { SetArray(filter, "label"); }, mend },
    { "field-array", "an array that is in the field data only", { "material" },
      [](Filter* filter) { SetArray(filter, "material"); }, mend } };
}

void TestIntervalErrors(StabilityCatalogue& catalogue)
{
  auto set = [](vtkIntervalVolume* filter)
  {
    filter->RemoveAllCriteria();
    filter->SetCriteriaOperation(vtkIntervalVolume::INTERSECTION);
    filter->SetInterval(0, 0.25, 0.75);
    filter->GenerateBoundariesOn();
  };
  using Case = ErrorCase<vtkIntervalVolume>;
  std::vector<Case> cases = ArrayCases<vtkIntervalVolume>(set);
  auto addBounds = [&](const char* name, const char* extreme, double lower, double upper,
                     const std::vector<std::string>& named)
  {
    cases.push_back({ name, extreme, named,
      [=](vtkIntervalVolume* filter) { filter->SetInterval(0, lower, upper); }, set });
  };
  addBounds("lower-above-upper", "lower 0.875, upper 0.125", 0.875, 0.125, { "0.875", "0.125" });
  addBounds("lower-nan", "lower is NaN", NaN, 0.5, { "nan" });
  addBounds("upper-nan", "upper is NaN", 0.5, NaN, { "nan" });
  addBounds("lower-infinite", "lower is minus infinity", -Infinity, 0.5, { "-inf" });
  addBounds("upper-infinite", "upper is infinity", 0.5, Infinity, { "inf" });
  auto addCriterion = [&](const char* name, const char* extreme, const char* array, double lower,
                        double upper, const std::vector<std::string>& named)
  {
    cases.push_back({ name, extreme, named,
      [=](vtkIntervalVolume* filter) { filter->AddCriterion(array, lower, upper); }, set });
  };
  addCriterion("criterion-missing", "a criterion on an array that does not exist", "nosuch", 0, 1,
    { "nosuch" });
  addCriterion(
    "criterion-components", "a criterion on a vector array", "velocity", 0, 1, { "velocity", "3" });
  addCriterion("criterion-string", "a criterion on a string array", "label", 0, 1, { "label" });
  addCriterion("criterion-range", "a criterion from 0.875 to 0.125", "pressure", 0.875, 0.125,
    { "pressure", "0.875", "0.125" });
  addCriterion("criterion-nan", "a criterion to NaN", "pressure", 0, NaN, { "pressure", "nan" });
  for (const int operation : { vtkIntervalVolume::UNION, vtkIntervalVolume::DIFFERENCE })
  {
    const bool isUnion = operation == vtkIntervalVolume::UNION;
    cases.push_back({ isUnion ? "union-missing" : "difference-missing",
      isUnion ? "a union with an array that does not exist"
              : "a difference with an array that does not exist",
      { "nosuch" },
      [=](vtkIntervalVolume* filter)
      {
        filter->SetCriteriaOperation(operation);
        filter->AddCriterion("nosuch", 0, 1);
      },
      set });
  }
  TestErrors(catalogue, cases);
}

void TestContourErrors(StabilityCatalogue& catalogue)
{
  auto set = [](vtkIsotableContour* filter) { filter->SetValue(0, 0.5); };
  std::vector<ErrorCase<vtkIsotableContour>> cases = ArrayCases<vtkIsotableContour>(set);
  cases.push_back({ "value-nan", "a value that is NaN", { "nan" },
    [](vtkIsotableContour* filter) { filter->SetValue(0, NaN); }, set });
  cases.push_back({ "value-infinite", "a value that is infinite", { "inf" },
    [](vtkIsotableContour* filter) { filter->SetValue(0, Infinity); }, set });
  TestErrors(catalogue, cases);
}

template <typename Filter>
void TestEmpty(StabilityCatalogue& catalogue, const char* name, const char* extreme,
  vtkDataObject* input, const std::string& words, const std::function<void(Filter*)>& set)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(input);
  set(filter);
  catalogue.SetClass(filter->GetClassName());
  ReportEmpty(catalogue, filter, std::string(filter->GetClassName()) + "-" + name, extreme, words);
}

void TestEmptyInputs(StabilityCatalogue& catalogue)
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkImageData> image;
  vtkNew<vtkUnstructuredGrid> points;
  points->SetPoints(MakeInput()->GetPoints());
  AddRandomField(points, 1);
  struct
  {
    const char* Name;
    const char* Extreme;
    vtkDataObject* Input;
    const char* Words;
  } const inputs[] = { { "empty-grid", "an empty unstructured grid", grid, "no points" },
    { "empty-image", "an empty image", image, "no points" },
    { "no-cells", "points and values, but no cells", points, "no cells" } };
  for (const auto& one : inputs)
  {
    TestEmpty<vtkIntervalVolume>(catalogue, one.Name, one.Extreme, one.Input, one.Words,
      [](vtkIntervalVolume* filter) { filter->SetInterval(0, 0, 1); });
    TestEmpty<vtkIsotableContour>(catalogue, one.Name, one.Extreme, one.Input, one.Words,
      [](vtkIsotableContour* filter) { filter->SetValue(0, 0.5); });
  }
  TestEmpty<vtkIntervalVolume>(catalogue, "no-intervals", "no interval is set", MakeInput(),
    "no interval is set", [](vtkIntervalVolume*) {});
  TestEmpty<vtkIsotableContour>(catalogue, "no-values", "no value is set", MakeInput(),
    "no value is set", [](vtkIsotableContour*) {});
}

void TestSettings(StabilityCatalogue& catalogue)
{
  vtkNew<vtkIntervalVolume> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInterval(-1, 0, 1);
  filter->SetInterval(10000, 0, 1);
  const int afterIndices = filter->GetNumberOfIntervals();
  filter->SetNumberOfIntervals(-5);
  const int afterNegative = filter->GetNumberOfIntervals();
  filter->SetNumberOfIntervals(10001);
  const int afterMany = filter->GetNumberOfIntervals();
  catalogue.SetClass(filter->GetClassName());
  const bool passed = afterIndices == 0 && afterNegative == 0 && afterMany <= 10000;
  catalogue.Check("interval-indices", "indices and numbers of intervals out of range",
    "rejected: 0 to 10000 intervals",
    std::to_string(afterIndices) + ", " + std::to_string(afterNegative) + ", " +
      std::to_string(afterMany) + " intervals",
    passed);

  filter->SetNumberOfIntervals(0);
  double lower = 7;
  double upper = 7;
  filter->GetInterval(0, lower, upper);
  filter->GetInterval(-1, lower, upper);
  filter->GetCriterionRange(3, lower, upper);
  const bool noName = filter->GetCriterionArrayName(3) == nullptr;
  vtkNew<vtkIsotableContour> contour;
  contour->AddObserver(vtkCommand::ErrorEvent, observer);
  const double value = contour->GetValue(4);
  catalogue.Check("getter-indices", "an interval and a criterion that do not exist",
    "unchanged bounds, no name",
    "lower " + std::to_string(lower) + (noName ? ", no name" : ", a name"),
    noName && lower == 7.0 && upper == 7.0);
  catalogue.SetClass(contour->GetClassName());
  catalogue.Measure("getter-index", "a value that does not exist", "0", value, 0.0);
}

}

int TestStabilityInput(int argc, char* argv[])
{
  return RunCases(__func__, "", argc, argv,
    { TestIntervalErrors, TestContourErrors, TestEmptyInputs, TestSettings });
}
