// SPDX-License-Identifier: BSD-3-Clause
// Arrays that are linear in space and time are reproduced exactly, and cell arrays are copied. Time
// is the time of the slice for any input type. 4-simplices read from a file yield bit-identical
// output.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/TimeVarying/ReferenceSimplexGrid.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{

using namespace reference;

double Linear(const double* x, double t, int component)
{
  return 3.0 + component - 2.0 * x[0] + 0.5 * x[1] + (1.5 + component) * x[2] - 0.75 * t;
}

vtkSmartPointer<vtkUnstructuredGrid> MakeInput()
{
  KuhnOptions options;
  options.MovedInSpace = 0.15;
  options.MovedInTime = 0.15;
  auto grid = MakeKuhnGrid(options);
  vtkNew<vtkDoubleArray> linear;
  linear->SetName("linear");
  linear->SetNumberOfComponents(2);
  linear->SetComponentName(1, "second");
  linear->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
  {
    double x[3];
    grid->GetPoint(point, x);
    const double t = grid->GetPointData()->GetArray("Time")->GetComponent(point, 0);
    for (int c = 0; c < 2; ++c)
    {
      linear->SetComponent(point, c, Linear(x, t, c));
    }
  }
  grid->GetPointData()->AddArray(linear);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("number");
  vtkNew<vtkStringArray> texts;
  texts->SetName("text");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    numbers->InsertNextValue(cell);
    texts->InsertNextValue("cell " + std::to_string(cell));
  }
  grid->GetCellData()->AddArray(numbers);
  grid->GetCellData()->AddArray(texts);
  return grid;
}

void CheckTime(vtkUnstructuredGrid* slice, double t, Check& check)
{
  auto* times = vtkDoubleArray::SafeDownCast(slice->GetPointData()->GetArray("Time"));
  check.That(times && times->GetNumberOfValues() == slice->GetNumberOfPoints() &&
      std::all_of(times->Begin(), times->End(), [t](double time) { return time == t; }),
    "Time is the slice time in double");
  check.That(slice->GetNumberOfCells() > 0, "there are tetrahedra");
}

void CheckArrays(Check& check)
{
  check.SetContext("arrays");
  auto grid = MakeInput();
  grid->GetPointData()->SetActiveScalars("Time");
  const double t = 1.3;
  auto slice = SliceAt(grid, t);
  CheckTime(slice, t, check);
  vtkPointData* points = slice->GetPointData();
  check.That(points->GetScalars() == points->GetArray("Time"), "Time remains the active scalars");
  check.Equal(points->GetNumberOfArrays(), 2, "point arrays");
  vtkDataArray* linear = points->GetArray("linear");
  double most = 0;
  for (vtkIdType point = 0; point < slice->GetNumberOfPoints(); ++point)
  {
    double x[3];
    slice->GetPoint(point, x);
    for (int c = 0; c < 2; ++c)
    {
      most = std::max(most, std::abs(linear->GetComponent(point, c) - Linear(x, t, c)));
    }
  }
  check.Near(most, 0.0, 1e-14, "error of a linear array", 3.0);
  check.That(linear->GetComponentName(1) == std::string("second"), "component names are preserved");

  auto* numbers = vtkIdTypeArray::SafeDownCast(slice->GetCellData()->GetArray("number"));
  auto* texts = vtkStringArray::SafeDownCast(slice->GetCellData()->GetAbstractArray("text"));
  if (!check.That(numbers && texts, "cell arrays preserve their types"))
  {
    return;
  }
  for (vtkIdType cell = 0; cell < slice->GetNumberOfCells(); ++cell)
  {
    const vtkIdType from = numbers->GetValue(cell);
    const SimplexEvents simplex = GetSimplexEvents(grid, from);
    double bounds[6];
    slice->GetCell(cell)->GetBounds(bounds);
    bool inside = texts->GetValue(cell) == "cell " + std::to_string(from);
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto range = std::minmax_element(simplex.begin(), simplex.end(),
        [axis](const Event& a, const Event& b) { return a[axis] < b[axis]; });
      inside = inside && bounds[2 * axis] >= (*range.first)[axis] - 1e-12 &&
        bounds[2 * axis + 1] <= (*range.second)[axis] + 1e-12;
    }
    check.That(inside, "cell values equal the values of the surrounding 4-simplex");
  }
}

/// Checks that a Time array of another type yields the same slices as an array of doubles.
void CheckTimeArray(vtkDataArray* times, const std::string& name, Check& check)
{
  check.SetContext(name);
  auto grid = MakeKuhnGrid({});
  const double ts[] = { 0.0, 0.3, 1.0, 2.7, 3.0 };
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> expected;
  for (const double t : ts)
  {
    expected.push_back(SliceAt(grid, t));
  }
  vtkDataArray* given = grid->GetPointData()->GetArray("Time");
  times->SetName("Time");
  times->SetNumberOfTuples(given->GetNumberOfTuples());
  for (vtkIdType point = 0; point < given->GetNumberOfTuples(); ++point)
  {
    times->SetComponent(point, 0, given->GetComponent(point, 0));
  }
  grid->GetPointData()->AddArray(times);
  for (size_t i = 0; i < expected.size(); ++i)
  {
    auto slice = SliceAt(grid, ts[i]);
    CheckTime(slice, ts[i], check);
    const std::string difference = FindDifference(slice, expected[i]);
    check.That(difference.empty(), difference);
  }
}

void CheckTimeArrays(Check& check)
{
  for (const int type :
    { VTK_FLOAT, VTK_INT, VTK_UNSIGNED_CHAR, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG })
  {
    auto times = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
    CheckTimeArray(times, times->GetClassName(), check);
  }
  vtkNew<vtkSOADataArrayTemplate<double>> apart;
  apart->SetNumberOfComponents(1);
  CheckTimeArray(apart, "a structure of arrays", check);
}

void CheckPrecision(Check& check)
{
  check.SetContext("precision");
  auto grid = MakeInput();
  check.Equal(SliceAt(grid, 1.3)->GetPoints()->GetDataType(), VTK_DOUBLE, "type of the points");
  vtkNew<vtkPoints> narrow;
  narrow->SetDataTypeToFloat();
  narrow->DeepCopy(grid->GetPoints());
  grid->SetPoints(narrow);
  check.Equal(SliceAt(grid, 1.3)->GetPoints()->GetDataType(), VTK_FLOAT, "type of the points");
}

void CheckFile(Check& check)
{
  check.SetContext("file");
  auto grid = MakeInput();
  vtkNew<vtkIdTypeArray> globalIds;
  globalIds->SetName("global");
  for (vtkIdType point = grid->GetNumberOfPoints(); point > 0; --point)
  {
    globalIds->InsertNextValue(point);
  }
  grid->GetPointData()->SetGlobalIds(globalIds);
  const char* const name = "TestSimplexTimeSliceArrays.vtu";
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(name);
  writer->SetInputData(grid);
  check.Equal(writer->Write(), 1, "the file is written");
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(name);
  reader->Update();
  std::remove(name);
  for (const double t : { 0.0, 1.3, 3.0 })
  {
    auto slice = SliceAt(reader->GetOutput(), t);
    CheckTime(slice, t, check);
    check.That(slice->GetPointData()->GetArray("global") == nullptr, "global ids are not passed");
    const std::string difference = FindDifference(slice, SliceAt(grid, t));
    check.That(difference.empty(), difference);
  }
}

}

int TestSimplexTimeSliceArrays(int, char*[])
{
  Check check;
  CheckArrays(check);
  CheckTimeArrays(check);
  CheckPrecision(check);
  CheckFile(check);
  return check.Result();
}
