// SPDX-License-Identifier: BSD-3-Clause
// The fast path for a contour of one value on structured grids, which compares values as bits. The
// output and report equal the results of the general path, which is used for a second value outside
// the range. Tests images with and without rotation, rectilinear and structured grids, rows shorter
// and longer than machine words, all scalar types, ties, non-finite values, with and without an
// index, and any number of threads.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace
{

using namespace reference;
using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

Grid Contour(vtkDataSet* data, double value, bool addsValue, vtkInterlumeReport* report)
{
  vtkNew<vtkIsotableContour> filter;
  filter->SetInputData(data);
  filter->SetValue(0, value);
  if (addsValue)
  {
    filter->SetValue(1, 1e300);
  }
  filter->WarnOnEmptyOutputOff();
  filter->Update();
  report->DeepCopy(filter->GetReport());
  return filter->GetOutput();
}

void CompareBytes(vtkDataArray* a, vtkDataArray* b, const std::string& name, Check& check)
{
  if (!check.That(a && b, name) ||
    !check.Equal(a->GetDataType(), b->GetDataType(), "type of " + name) ||
    !check.Equal(a->GetNumberOfValues(), b->GetNumberOfValues(), "values of " + name))
  {
    return;
  }
  const auto bytes = static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize();
  check.That(bytes == 0 || !std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes),
    "bytes of " + name);
}

/// Compares two contours for bit-identity. Returns the number of triangles.
vtkIdType CompareGrids(const Grid& quick, const Grid& general, Check& check)
{
  check.Equal(quick->GetNumberOfCells(), general->GetNumberOfCells(), "triangles");
  check.Equal(quick->GetNumberOfPoints(), general->GetNumberOfPoints(), "points");
  if (quick->GetNumberOfCells() == 0 || general->GetNumberOfCells() == 0)
  {
    return 0;
  }
  CompareBytes(
    quick->GetPoints()->GetData(), general->GetPoints()->GetData(), "coordinates", check);
  CompareBytes(quick->GetCells()->GetConnectivityArray(),
    general->GetCells()->GetConnectivityArray(), "ids", check);
  vtkDataSetAttributes* const ofQuick[] = { quick->GetPointData(), quick->GetCellData() };
  vtkDataSetAttributes* const ofAny[] = { general->GetPointData(), general->GetCellData() };
  for (int kind = 0; kind < 2; ++kind)
  {
    check.Equal(ofQuick[kind]->GetNumberOfArrays(), ofAny[kind]->GetNumberOfArrays(), "arrays");
    for (int a = 0; a < ofAny[kind]->GetNumberOfArrays(); ++a)
    {
      const char* const name = ofAny[kind]->GetArrayName(a);
      CompareBytes(ofQuick[kind]->GetArray(name), ofAny[kind]->GetArray(name), name, check);
    }
  }
  return quick->GetNumberOfCells();
}

/// Compares the results of the fast and the general path. Returns the number of triangles.
vtkIdType Compare(vtkDataSet* data, double value, Check& check)
{
  vtkNew<vtkInterlumeReport> report;
  vtkNew<vtkInterlumeReport> other;
  const Grid quick = Contour(data, value, false, report);
  const Grid general = Contour(data, value, true, other);
  check.Equal(report->GetCount("CellsByBits"), data->GetNumberOfCells(), "cells compared as bits");
  check.Equal(other->GetCount("CellsByBits"), 0, "cells compared as bits with two values");
  check.Equal(
    report->GetCount("CellsWithOutput"), other->GetCount("CellsWithOutput"), "cells with output");
  check.Equal(
    report->GetCount("NonFiniteCells"), other->GetCount("NonFiniteCells"), "non-finite cells");
  check.Equal(report->GetCount("CollapsedSimplices"), other->GetCount("CollapsedSimplices"),
    "collapsed triangles");
  check.Equal(report->GetCount("CellsVisited"), data->GetNumberOfCells(), "cells visited");
  return CompareGrids(quick, general, check);
}

void SetScalars(vtkDataSet* data, int type, double maximum, unsigned int seed)
{
  std::minstd_rand random(seed);
  const auto scalars = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  scalars->SetName("field");
  scalars->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    scalars->SetComponent(p, 0, maximum * static_cast<double>(random() % 1000) / 999.0);
  }
  data->GetPointData()->SetScalars(scalars);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("cells");
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    ids->InsertNextValue(3 * cell);
  }
  data->GetCellData()->AddArray(ids);
}

constexpr int Types[] = { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_FLOAT,
  VTK_DOUBLE };

/// Tests all scalar types. Many of the small integers equal the isovalue.
void CheckTypes(Check& check)
{
  const std::array<int, 3> sizes[] = { { { 2, 2, 2 } }, { { 31, 4, 3 } }, { { 32, 3, 4 } },
    { { 33, 5, 5 } }, { { 34, 4, 2 } }, { { 64, 3, 3 } }, { { 65, 3, 3 } }, { { 97, 2, 6 } } };
  for (const auto& size : sizes)
  {
    auto image = MakeImage(size);
    for (int type : Types)
    {
      for (double maximum : { 2.0, 5.0, 100.0 })
      {
        SetScalars(image, type, maximum, static_cast<unsigned int>(size[0] + type));
        for (double value : { 1.0, 1.5, maximum, 0.0, -1.0, 127.0, 1e30 })
        {
          check.SetContext("row " + std::to_string(size[0]) + ", type " + std::to_string(type) +
            ", to " + std::to_string(maximum) + ", at " + std::to_string(value));
          Compare(image, value, check);
        }
      }
    }
  }
}

void CheckGrids(Check& check)
{
  for (int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    auto image = MakeImage({ 37, 9, 8 });
    SetScalars(image, type, 4.0, 7);
    for (const DataSetVariant& form : FormsOf(image))
    {
      if (!vtkUnstructuredGrid::SafeDownCast(form.Data))
      {
        check.SetContext(form.Name);
        SetScalars(form.Data, type, 4.0, 7);
        check.That(Compare(form.Data, 2.0, check) > 500, "there are triangles");
        check.That(Compare(form.Data, 2.5, check) > 500, "there are triangles");
      }
    }
  }
}

/// Tests a left-handed image, and an image with a string array, whose values are copied instead of
/// interpolated.
void CheckKinds(Check& check)
{
  check.SetContext("left-handed");
  auto image = MakeImage({ 37, 9, 8 });
  SetScalars(image, VTK_FLOAT, 4.0, 7);
  image->SetDirectionMatrix(-1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
  check.That(Compare(image, 2.0, check) > 500, "there are triangles");
  check.SetContext("strings");
  vtkNew<vtkStringArray> strings;
  strings->SetName("strings");
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    strings->InsertNextValue("point " + std::to_string(p));
  }
  image->GetPointData()->AddArray(strings);
  for (double value : { 2.0, 2.5 })
  {
    vtkNew<vtkInterlumeReport> report;
    const Grid quick = Contour(image, value, false, report);
    const Grid general = Contour(image, value, true, report);
    auto* const ofQuick =
      vtkStringArray::SafeDownCast(quick->GetPointData()->GetAbstractArray("strings"));
    auto* const ofAny =
      vtkStringArray::SafeDownCast(general->GetPointData()->GetAbstractArray("strings"));
    bool areEqual = check.That(ofQuick && ofAny, "strings") &&
      check.Equal(ofQuick->GetNumberOfValues(), general->GetNumberOfPoints(), "strings");
    for (vtkIdType p = 0; areEqual && p < general->GetNumberOfPoints(); ++p)
    {
      areEqual = ofQuick->GetValue(p) == ofAny->GetValue(p);
    }
    check.That(areEqual, "strings are equal");
  }
}

/// Sets a single value to the isovalue or to a non-finite value, so most rows have no such value.
void CheckFew(Check& check)
{
  for (double value : { 50.0, std::numeric_limits<double>::infinity(),
         -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    auto image = MakeImage({ 40, 7, 7 });
    SetScalars(image, VTK_DOUBLE, 99.5, 3);
    for (vtkIdType p = 0; p < image->GetNumberOfPoints(); p += 131)
    {
      const double before = image->GetPointData()->GetScalars()->GetComponent(p, 0);
      image->GetPointData()->GetScalars()->SetComponent(p, 0, value);
      check.SetContext(std::to_string(value) + " at " + std::to_string(p));
      check.That(Compare(image, 50.0, check) > 500, "there are triangles");
      image->GetPointData()->GetScalars()->SetComponent(p, 0, before);
    }
  }
}

/// Sets values that increase with the point index, except for noise. A few are integers or NaN.
void SetGrowing(vtkDataSet* data, int type)
{
  SetScalars(data, type, 4.0, 11);
  vtkDataArray* const scalars = data->GetPointData()->GetScalars();
  const vtkIdType number = scalars->GetNumberOfTuples();
  for (vtkIdType p = 0; p < number; ++p)
  {
    const double maximum = 90.0 * static_cast<double>(p) / static_cast<double>(number);
    scalars->SetComponent(p, 0, scalars->GetComponent(p, 0) + maximum);
  }
  for (vtkIdType p = 0; p < number; p += 97)
  {
    const double value = std::floor(scalars->GetComponent(p, 0));
    const bool isLost = type == VTK_FLOAT && p % 4 == 0;
    scalars->SetComponent(p, 0, isLost ? std::numeric_limits<double>::quiet_NaN() : value);
  }
}

/// Changes the isovalue between executions, so that the filter uses its value index.
void CheckIndex(vtkDataSet* data, Check& check)
{
  vtkNew<vtkIsotableContour> retained;
  retained->SetInputData(data);
  retained->WarnOnEmptyOutputOff();
  bool isFirst = true;
  for (double value : { 40.25, 20.0, 20.5, 70.0, 85.5, 1.0, -5.0, 200.0 })
  {
    retained->SetValue(0, value);
    retained->Update();
    vtkNew<vtkIsotableContour> plain;
    plain->SetInputData(data);
    plain->WarnOnEmptyOutputOff();
    plain->UseValueIndexOff();
    plain->SetValue(0, value);
    plain->Update();
    vtkInterlumeReport* report = retained->GetReport();
    const vtkIdType triangles = CompareGrids(retained->GetOutput(), plain->GetOutput(), check);
    check.That((value > 0.0 && value < 99.0) == (triangles > 0), "there are triangles");
    check.Equal(report->GetCount("CellsWithOutput"),
      plain->GetReport()->GetCount("CellsWithOutput"), "cells with output, by the index");
    const double cells = plain->GetReport()->GetNumber("CellsByBits");
    // The general path is used if a value in a ghost cell equals the isovalue or is NaN.
    const bool isFloat = data->GetPointData()->GetScalars()->GetDataType() == VTK_FLOAT;
    const bool mayBeTied = data->GetCellGhostArray() && (isFloat || value == std::floor(value));
    check.That(mayBeTied || cells > data->GetNumberOfCells() / 2, "cells are compared as bits");
    check.That(isFirst || cells == 0 ? report->GetNumber("CellsByBits") == cells
                                     : report->GetNumber("CellsByBits") < cells / 2,
      "the index skips cells");
    isFirst = false;
  }
}

void CheckIndices(Check& check)
{
  for (int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    const std::string text = ", index, type " + std::to_string(type);
    auto image = MakeImage({ 37, 22, 50 });
    SetGrowing(image, type);
    for (const DataSetVariant& form : FormsOf(image))
    {
      if (!vtkUnstructuredGrid::SafeDownCast(form.Data))
      {
        check.SetContext(form.Name + text);
        SetGrowing(form.Data, type);
        CheckIndex(form.Data, check);
      }
    }
    check.SetContext("layers of ghost cells" + text);
    vtkUnsignedCharArray* const ghosts = image->AllocateCellGhostArray();
    int points[3];
    image->GetDimensions(points);
    for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
    {
      const vtkIdType row = cell / (points[0] - 1);
      const bool isGhost = cell % (points[0] - 1) == 0 || row % (points[1] - 1) < 2 ||
        row / (points[1] - 1) + 2 == points[2];
      ghosts->SetValue(cell, isGhost ? vtkDataSetAttributes::DUPLICATECELL : 0);
    }
    CheckIndex(image, check);
  }
}

void CheckRuns(Check& check)
{
  for (double maximum : { 3.0, 97.3 })
  {
    auto image = MakeImage({ 50, 40, 30 });
    SetScalars(image, VTK_FLOAT, maximum, 5);
    if (maximum == 3.0)
    {
      SetScalars(image, VTK_UNSIGNED_CHAR, maximum, 5);
    }
    vtkNew<vtkInterlumeReport> report;
    CheckThreads(
      "to " + std::to_string(maximum),
      [&] { return std::vector<Grid>{ Contour(image, 1.0, false, report) }; }, check);
  }
}

/// The fast path is not used for several isovalues.
void CheckUnsuited(Check& check)
{
  check.SetContext("several values");
  auto image = MakeImage({ 9, 9, 9 });
  SetScalars(image, VTK_FLOAT, 4.0, 7);
  vtkNew<vtkIsotableContour> filter;
  filter->SetInputData(image);
  filter->SetValue(0, 1.25);
  filter->SetValue(1, 2.25);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("CellsByBits"), 0, "cells compared as bits");
}

}

int TestIsotableContourRows(int, char*[])
{
  Check check;
  CheckTypes(check);
  CheckGrids(check);
  CheckKinds(check);
  CheckFew(check);
  CheckIndices(check);
  CheckRuns(check);
  CheckUnsuited(check);
  return check.Result();
}
