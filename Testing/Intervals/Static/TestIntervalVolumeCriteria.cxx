// SPDX-License-Identifier: BSD-3-Clause
// Criteria on additional arrays: the volumes of the intersection, union and difference, for linear
// functions and for arbitrary values on tetrahedra. The order of criteria has no effect, and
// several intervals still tile the domain.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace reference;

using Filter = vtkIntervalVolume;

/// Returns the volume extracted with ranges[0] as the interval and the other ranges as criteria.
double ExtractedVolume(vtkUnstructuredGrid* mesh, const std::vector<Range>& ranges, Check& check,
  int operation = Filter::INTERSECTION)
{
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(mesh);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, ranges[0].Array);
  filter->SetInterval(0, ranges[0].Lower, ranges[0].Upper);
  for (size_t i = 1; i < ranges.size(); ++i)
  {
    filter->AddCriterion(ranges[i].Array, ranges[i].Lower, ranges[i].Upper);
  }
  filter->SetCriteriaOperation(operation);
  filter->WarnOnEmptyOutputOff();
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  const long long number = static_cast<long long>(ranges.size());
  check.Equal(filter->GetReport()->GetCount("Passes"),
    operation == Filter::UNION ? 2 * number - 1 : number, "passes");
  vtkUnstructuredGrid* output = filter->GetOutput();
  check.That(IsValid(output, VTK_TETRA), "the output consists of tetrahedra");
  check.That(output->GetNumberOfCells() == 0 || output->GetCellData()->HasArray("IntervalId"),
    "IntervalId is passed");
  const auto isWithin = [&](const Range& range, vtkIdType point, double tolerance)
  {
    const double value = output->GetPointData()->GetArray(range.Array)->GetComponent(point, 0);
    return value >= range.Lower - tolerance && value <= range.Upper + tolerance;
  };
  long long invalid = 0;
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const auto satisfies = [&](const Range& range) { return isWithin(range, p, 1e-14); };
    const auto exceeds = [&](const Range& range) { return isWithin(range, p, -1e-14); };
    invalid += operation == Filter::INTERSECTION
      ? !std::all_of(ranges.begin(), ranges.end(), satisfies)
      : operation == Filter::UNION
      ? std::none_of(ranges.begin(), ranges.end(), satisfies)
      : !satisfies(ranges[0]) || std::any_of(ranges.begin() + 1, ranges.end(), exceeds);
  }
  check.Equal(invalid, 0, "points outside of the region");
  return static_cast<double>(MeasureTetrahedra(output).Sum);
}

/// Returns the volume of the region that the filter extracts, by inclusion and exclusion.
double ExpectedVolume(vtkUnstructuredGrid* mesh, const std::vector<Range>& ranges, int operation)
{
  if (operation == Filter::INTERSECTION)
  {
    return static_cast<double>(ClippedVolume(mesh, ranges));
  }
  long double volume = 0;
  for (unsigned int set = 1; set < 1u << ranges.size(); ++set)
  {
    std::vector<Range> members;
    for (size_t i = 0; i < ranges.size(); ++i)
    {
      if (set >> i & 1)
      {
        members.push_back(ranges[i]);
      }
    }
    if (operation == Filter::UNION)
    {
      volume += (members.size() % 2 ? 1 : -1) * ClippedVolume(mesh, members);
    }
    else if (set & 1)
    {
      volume += (members.size() % 2 ? 1 : -1) * ClippedVolume(mesh, members);
    }
  }
  return static_cast<double>(volume);
}

vtkUnstructuredGrid* GetBoundary(vtkIntervalVolume* filter)
{
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(1));
}

constexpr int Operations[] = { Filter::INTERSECTION, Filter::UNION, Filter::DIFFERENCE };

void CheckLinear(MeshKind kind, Check& check)
{
  check.SetContext(GetName(kind) + ", linear");
  auto mesh = RenumberPoints(RotateCellPointOrder(MakeMesh(kind, { 3, 3, 2 }), 5), 5);
  AddLinearField(mesh, { 0.1, { -0.2, 0.9, 0.4 } }, "g");
  AddLinearField(mesh, { 0.3, { 0.5, 0.1, -0.6 } }, "h");
  AddLinearField(mesh, { 0.3, { 0.8, -0.37, 0.21 } });
  const double scale = static_cast<double>(MeshVolume(mesh));
  const Range f = { "f", 0.2, 1.3 };
  const Range g = { "g", 0.5, 2.2 };
  const Range h = { "h", 0.1, 0.7 };
  for (const std::vector<Range>& ranges :
    { std::vector<Range>{ f, g }, { g, f }, { f, g, h }, { h, g, f }, { f, f } })
  {
    for (int operation : Operations)
    {
      check.Near(ExtractedVolume(mesh, ranges, check, operation),
        ExpectedVolume(mesh, ranges, operation), 1e-12,
        "volume, operation " + std::to_string(operation), scale);
    }
  }
}

void CheckTetrahedra(MeshKind kind, Check& check)
{
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    check.SetContext(GetName(kind) + ", random, seed " + std::to_string(seed));
    auto mesh = MapProjectively(RenumberPoints(MakeMesh(kind, { 4, 3, 3 }), seed), seed);
    AddRandomField(mesh, seed + 10, "g");
    AddRandomField(mesh, seed + 20, "h");
    AddRandomField(mesh, seed);
    const std::vector<Range> ranges = { { "f", 0.2, 0.7 }, { "g", 0.3, 0.9 }, { "h", -1, 0.6 } };
    for (int operation : Operations)
    {
      check.Near(ExtractedVolume(mesh, ranges, check, operation),
        ExpectedVolume(mesh, ranges, operation), 1e-12,
        "volume, operation " + std::to_string(operation), static_cast<double>(MeshVolume(mesh)));
    }
  }
}

/// For every kind of mesh, the volumes for disjoint ranges of a criterion add up to the volume
/// without the criterion, as do those of the intersection and the difference. The union adds what
/// the complement of the interval has in common with the criterion.
void CheckSum(MeshKind kind, Check& check)
{
  check.SetContext(GetName(kind) + ", sum");
  auto mesh = MakeMesh(kind, { 3, 3, 2 });
  AddRandomField(mesh, 9, "g");
  AddRandomField(mesh, 8);
  const double scale = static_cast<double>(MeshVolume(mesh));
  const Range f = { "f", 0.25, 0.75 };
  const double whole = ExtractedVolume(mesh, { f }, check);
  double sum = 0;
  for (const Range& g : { Range{ "g", -1, 0.4 }, { "g", 0.4, 0.6 }, { "g", 0.6, 2 } })
  {
    sum += ExtractedVolume(mesh, { f, g }, check);
  }
  check.Near(sum, whole, 1e-12, "sum of the volumes", scale);
  const Range g = { "g", 0.4, 0.6 };
  check.Near(ExtractedVolume(mesh, { f, g }, check) +
      ExtractedVolume(mesh, { f, g }, check, Filter::DIFFERENCE),
    whole, 1e-12, "intersection and difference", scale);
  double united = whole;
  for (const Range& outside : { Range{ "f", -1, 0.25 }, { "f", 0.75, 2 } })
  {
    united += ExtractedVolume(mesh, { outside, g }, check);
  }
  check.Near(ExtractedVolume(mesh, { f, g }, check, Filter::UNION), united, 1e-12, "union", scale);
}

/// Values equal to a bound belong to the interval and to the criterion. Cells where all values
/// equal a bound are therefore counted once.
void CheckTies(MeshKind kind, Check& check)
{
  check.SetContext(GetName(kind) + ", ties");
  auto mesh = MakeMesh(kind, { 4, 4, 4 });
  AddIntegerField(mesh, 2, 9, "g");
  AddIntegerField(mesh, 2, 8);
  const double scale = static_cast<double>(MeshVolume(mesh));
  for (double value : { 0, 1 })
  {
    const Range f = { "f", value, 0.75 + value };
    const Range g = { "g", value - 0.5, value };
    const double both = ExtractedVolume(mesh, { f, g }, check);
    const double onlyF = ExtractedVolume(mesh, { f, g }, check, Filter::DIFFERENCE);
    const double onlyG = ExtractedVolume(mesh, { g, f }, check, Filter::DIFFERENCE);
    check.Near(both + onlyF, ExtractedVolume(mesh, { f }, check), 1e-12, "interval", scale);
    check.Near(both + onlyG, ExtractedVolume(mesh, { g }, check), 1e-12, "criterion", scale);
    check.Near(ExtractedVolume(mesh, { f, g }, check, Filter::UNION), both + onlyF + onlyG, 1e-12,
      "union", scale);
  }
}

/// The union with a criterion that all points satisfy is the domain, also if an interval of zero
/// width consists of constant cells, and at the largest numbers.
void CheckWholeUnion(MeshKind kind, Check& check)
{
  auto mesh = MakeMesh(kind, { 4, 4, 4 });
  vtkDataArray* f = AddIntegerField(mesh, 3, 8);
  AddLinearField(mesh, { 0.5, { 0.01, 0, 0 } }, "g");
  mesh->GetPointData()->SetActiveScalars("f");
  const double domain = static_cast<double>(MeshVolume(mesh));
  const double largest = std::numeric_limits<double>::max();
  for (const Range& range :
    { Range{ "f", 1, 1 }, { "f", 0, 1 }, { "f", 1, 1.5 }, { "f", 2, largest },
      { "f", largest, largest }, { "f", -largest, -largest }, { "f", -largest, largest } })
  {
    check.SetContext(GetName(kind) + ", whole union with [" + std::to_string(range.Lower) + ", " +
      std::to_string(range.Upper) + "]");
    check.Near(ExtractedVolume(mesh, { range, { "g", -9, 9 } }, check, Filter::UNION), domain,
      1e-12, "volume", domain);
  }
  for (const double extreme : { largest, -largest })
  {
    check.SetContext(GetName(kind) + ", extreme values");
    f->Fill(extreme);
    const Range range = { "f", extreme, extreme };
    const Range all = { "g", -9, 9 };
    check.Near(
      ExtractedVolume(mesh, { range, all }, check, Filter::UNION), domain, 1e-12, "union", domain);
    check.Near(ExtractedVolume(mesh, { all, range }, check, Filter::DIFFERENCE), 0, 1e-12,
      "difference", domain);
  }
}

/// The difference with a criterion of zero width has no boundary where its value is crossed.
void CheckZeroWidth(Check& check)
{
  check.SetContext("criterion of zero width");
  auto image = MakeImage({ 6, 5, 4 });
  AddLinearField(image, { 0, { 0, 1, 0 } }, "g");
  AddLinearField(image, { 0, { 1, 0, 0 } });
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(image);
  filter->SetInterval(0, -1.15, -1);
  filter->GenerateBoundariesOn();
  filter->Update();
  const vtkIdType triangles = GetBoundary(filter)->GetNumberOfCells();
  filter->AddCriterion("g", 1.4, 1.4);
  filter->SetCriteriaOperation(Filter::DIFFERENCE);
  filter->Update();
  vtkDataArray* sides = GetBoundary(filter)->GetCellData()->GetArray("BoundarySide");
  double range[2];
  sides->GetRange(range);
  check.That(range[0] == 0 && range[1] == 1, "only sides of the interval");
  check.That(GetBoundary(filter)->GetNumberOfCells() >= triangles, "triangles of the interval");
}

/// A criterion on ids is an error.
void CheckIds(Check& check)
{
  check.SetContext("ids");
  auto image = MakeImage({ 2, 2, 2 });
  AddLinearField(image, { 0, { 1, 0, 0 } });
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  ids->SetNumberOfValues(image->GetNumberOfPoints());
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfValues(), vtkIdType(0));
  for (const bool isPedigree : { false, true })
  {
    image->GetPointData()->SetGlobalIds(isPedigree ? nullptr : ids.GetPointer());
    image->GetPointData()->SetPedigreeIds(isPedigree ? ids.GetPointer() : nullptr);
    for (int operation : Operations)
    {
      vtkNew<vtkIntervalVolume> filter;
      filter->SetInputData(image);
      filter->SetInterval(0, -2, 2);
      filter->AddCriterion("ids", 0, 4);
      filter->SetCriteriaOperation(operation);
      const std::string errors = UpdateAndGetErrors(filter);
      check.That(errors.find("\"ids\"") != std::string::npos, "an error names the array");
      check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "cells");
    }
  }
}

/// The region of a union that no interval contains has the IntervalId -1. Each part keeps the
/// arrays of the input, and the boundaries of criteria have their own sides.
void CheckLabels(Check& check)
{
  check.SetContext("labels");
  auto image = MakeImage({ 6, 5, 4 });
  AddLinearField(image, { 0.1, { 0.3, 0.21, 0.4 } }, "g");
  AddLinearField(image, { 0, { 1, 0, 0 } });
  vtkNew<vtkDoubleArray> unnamed;
  unnamed->SetNumberOfComponents(3);
  unnamed->SetNumberOfTuples(image->GetNumberOfPoints());
  unnamed->Fill(2.5);
  image->GetPointData()->AddArray(unnamed);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(image);
  filter->SetInterval(0, -1.15, -1);
  filter->SetInterval(1, -1, -0.85);
  filter->AddCriterion("g", 0.9, 1.3);
  filter->WarnOnEmptyOutputOff();
  filter->AddCriterion("g", 1.9, 3);
  filter->GenerateBoundariesOn();
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (int operation : Operations)
  {
    filter->SetCriteriaOperation(operation);
    filter->Update();
    vtkUnstructuredGrid* boundary = GetBoundary(filter);
    check.Equal(boundary->GetNumberOfPoints(), filter->GetOutput()->GetNumberOfPoints(), "points");
    std::set<std::pair<int, int>> labels;
    for (vtkIdType cell = 0; cell < boundary->GetNumberOfCells(); ++cell)
    {
      const auto label = [&](const char* name)
      { return static_cast<int>(boundary->GetCellData()->GetArray(name)->GetComponent(cell, 0)); };
      labels.insert({ label("IntervalId"), label("BoundarySide") });
    }
    std::set<std::pair<int, int>> expected = { { 0, 0 }, { 0, 1 }, { 1, 0 }, { 1, 1 } };
    if (operation == Filter::UNION)
    {
      expected.insert({ { -1, 2 }, { -1, 3 }, { -1, 4 } });
    }
    else if (operation == Filter::DIFFERENCE)
    {
      expected.insert({ { 0, 2 }, { 0, 3 }, { 0, 4 }, { 1, 2 }, { 1, 3 }, { 1, 4 } });
    }
    else
    {
      // No value of g satisfies both criteria.
      expected.clear();
    }
    check.That(labels == expected, "labels, operation " + std::to_string(operation));
    const int arrays = filter->GetOutput()->GetPointData()->GetNumberOfArrays();
    check.Equal(arrays, image->GetPointData()->GetNumberOfArrays(),
      "point arrays, operation " + std::to_string(operation));
    double range[2] = { -1, -1 };
    if (operation != Filter::INTERSECTION)
    {
      filter->GetOutput()->GetCellData()->GetArray("IntervalId")->GetRange(range);
    }
    check.Equal(
      static_cast<int>(range[0]), operation == Filter::DIFFERENCE ? 0 : -1, "lowest interval");
  }
}

/// With interior cells, the union and the difference have the same volume. Cells are skipped where
/// the scalar or the array of a criterion is NaN.
void CheckInteriorCells(Check& check)
{
  auto image = MakeImage({ 6, 5, 4 });
  vtkDataArray* g = AddRandomField(image, 4, "g");
  vtkDataArray* f = AddRandomField(image, 3);
  vtkNew<vtkIntervalVolume> filter;
  filter->SetInputData(image);
  filter->SetInterval(0, 0.1, 2);
  filter->AddCriterion("g", 0.05, 0.95);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const bool hasNaN : { false, true })
  {
    if (hasNaN)
    {
      f->SetComponent(0, 0, std::nan(""));
      g->SetComponent(g->GetNumberOfTuples() - 1, 0, std::nan(""));
      image->Modified();
    }
    for (int operation : Operations)
    {
      check.SetContext(
        "interior cells, operation " + std::to_string(operation) + (hasNaN ? ", NaN" : ""));
      filter->SetCriteriaOperation(operation);
      filter->KeepInteriorCellsOff();
      filter->Update();
      const double volume = static_cast<double>(MeshVolume(filter->GetOutput()));
      check.That(volume > 1e-3, "the volume is finite and not empty");
      filter->KeepInteriorCellsOn();
      filter->Update();
      check.Near(static_cast<double>(MeshVolume(filter->GetOutput())), volume, 1e-12, "volume", 60);
      check.That(
        (filter->GetReport()->GetCount("InteriorCells") > 0) == (operation != Filter::DIFFERENCE),
        "interior cells");
    }
  }
}

}

int TestIntervalVolumeCriteria(int, char*[])
{
  Check check;
  for (MeshKind kind : AllMeshKinds())
  {
    CheckLinear(kind, check);
    CheckSum(kind, check);
    CheckWholeUnion(kind, check);
  }
  CheckZeroWidth(check);
  CheckIds(check);
  for (MeshKind kind : TetrahedralMeshKinds())
  {
    CheckTetrahedra(kind, check);
    CheckTies(kind, check);
  }
  CheckLabels(check);
  CheckInteriorCells(check);
  return check.Result();
}
