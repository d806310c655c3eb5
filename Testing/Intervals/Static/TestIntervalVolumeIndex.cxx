// SPDX-License-Identifier: BSD-3-Clause
// With a value index, modified intervals and contour values yield the same output as a fresh filter
// and visit fewer cells. Modified input is detected.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iostream>

namespace
{

using namespace reference;

struct IntervalRun
{
  vtkNew<vtkIntervalVolume> Filter;

  void Set(double lower, double upper)
  {
    this->Filter->SetInterval(0, lower, upper);
    this->Filter->SetInterval(1, upper, upper + 0.02);
    this->Filter->GenerateBoundariesOn();
  }
};

struct OneIntervalRun
{
  vtkNew<vtkIntervalVolume> Filter;

  void Set(double lower, double upper) { this->Filter->SetInterval(0, lower, upper); }
};

struct ContourRun
{
  vtkNew<vtkIsotableContour> Filter;

  void Set(double lower, double upper)
  {
    this->Filter->SetValue(0, lower);
    this->Filter->SetValue(1, upper);
  }
};

/// Adds a field that varies most along z, where cell ids increase by the largest steps. Blocks of
/// consecutive cells then have narrow ranges, as in datasets much larger than a block.
void AddSmoothField(vtkDataSet* data)
{
  vtkDoubleArray* field = AddRandomField(data, 1);
  double bounds[6];
  data->GetBounds(bounds);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double x[3];
    data->GetPoint(i, x);
    for (int a = 0; a < 3; ++a)
    {
      x[a] = (x[a] - bounds[2 * a]) / (bounds[2 * a + 1] - bounds[2 * a]);
    }
    field->SetValue(
      i, 0.5 + 0.4 * std::sin(3 * (x[2] - 0.5)) + 0.05 * std::cos(5 * x[0]) * std::sin(4 * x[1]));
  }
}

template <typename Run>
void CheckAgainstFresh(Run& retained, vtkDataSet* data, double lower, double upper, Check& check)
{
  retained.Set(lower, upper);
  retained.Filter->Update();
  Run fresh;
  fresh.Filter->SetInputDataObject(data);
  fresh.Set(lower, upper);
  fresh.Filter->Update();
  check.That(fresh.Filter->GetOutput()->GetNumberOfCells() > 0,
    "the output is not empty from " + std::to_string(lower));
  for (int port = 0; port < fresh.Filter->GetNumberOfOutputPorts(); ++port)
  {
    const std::string difference =
      FindDifference(vtkUnstructuredGrid::SafeDownCast(retained.Filter->GetOutputDataObject(port)),
        vtkUnstructuredGrid::SafeDownCast(fresh.Filter->GetOutputDataObject(port)));
    check.That(difference.empty(), difference);
  }
  vtkInterlumeReport* a = retained.Filter->GetReport();
  vtkInterlumeReport* b = fresh.Filter->GetReport();
  check.Equal(a->GetCount("Cells"), data->GetNumberOfCells(), "cells");
  check.Equal(a->GetCount("CellsWithOutput"), b->GetCount("CellsWithOutput"), "cells with output");
  check.That(a->GetNumber("CellsVisited") >= a->GetNumber("CellsWithOutput"),
    "visited cells are at least the cells with output");
}

template <typename Run>
void CheckRun(const DataSetVariant& form, const char* filterName, Check& check)
{
  check.SetContext(form.Name + ", " + filterName);
  AddSmoothField(form.Data);
  Run retained;
  retained.Filter->SetInputDataObject(form.Data);
  constexpr double steps[][2] = { { 0.5, 0.6 }, { 0.51, 0.6 }, { 0.4, 0.45 }, { 0.65, 0.66 },
    { 0.3, 0.8 }, { 0.5, 0.51 } };
  for (const auto& step : steps)
  {
    CheckAgainstFresh(retained, form.Data, step[0], step[1], check);
  }
  vtkInterlumeReport* report = retained.Filter->GetReport();
  std::cout << form.Name << ", " << filterName << ": " << report->GetNumber("CellsVisited")
            << " of " << report->GetNumber("Cells") << " cells visited, "
            << report->GetNumber("CellsWithOutput") << " with output\n";
  check.That(report->GetNumber("CellsVisited") < report->GetNumber("Cells") / 2,
    "fewer than half of the cells visited");

  // Modifies the values of the array, then uses another array and another input.
  vtkDataArray* scalars = form.Data->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetComponent(i, 0, 1 - scalars->GetComponent(i, 0) * scalars->GetComponent(i, 0));
  }
  scalars->Modified();
  form.Data->Modified();
  CheckAgainstFresh(retained, form.Data, 0.7, 0.71, check);
  AddRandomField(form.Data, 2, "g");
  CheckAgainstFresh(retained, form.Data, 0.7, 0.71, check);
  AddSmoothField(form.Data);
  CheckAgainstFresh(retained, form.Data, 0.7, 0.71, check);

  retained.Filter->UseValueIndexOff();
  CheckAgainstFresh(retained, form.Data, 0.4, 0.45, check);
  CheckAgainstFresh(retained, form.Data, 0.45, 0.46, check);
}

/// Modified cells must be detected even if their points and values are the same.
void CheckOtherCells(Check& check)
{
  check.SetContext("cells in another order");
  const auto mesh = MakeMesh(MeshKind::Wedges, { 12, 12, 12 });
  AddSmoothField(mesh);
  IntervalRun retained;
  retained.Filter->SetInputDataObject(mesh);
  CheckAgainstFresh(retained, mesh, 0.5, 0.6, check);
  CheckAgainstFresh(retained, mesh, 0.4, 0.45, check);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = mesh->GetNumberOfCells(); cell-- > 0;)
  {
    mesh->GetCellPoints(cell, corners);
    cells->InsertNextCell(corners);
  }
  mesh->SetCells(VTK_WEDGE, cells);
  CheckAgainstFresh(retained, mesh, 0.65, 0.66, check);
  CheckAgainstFresh(retained, mesh, 0.3, 0.31, check);
}

/// Blocks of cells whose values all equal the upper bound belong to the interval.
void CheckFlatBlocks(Check& check)
{
  const auto image = MakeImage({ 20, 20, 20 });
  vtkDoubleArray* field = AddRandomField(image, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double z = image->GetPoint(i)[2] / image->GetBounds()[5];
    field->SetValue(i, z > 0.5 ? 1.0 : 0.5 * z);
  }
  for (const DataSetVariant& form : FormsOf(image))
  {
    check.SetContext(form.Name + ", values that equal the upper bound");
    OneIntervalRun retained;
    retained.Filter->SetInputDataObject(form.Data);
    CheckAgainstFresh(retained, form.Data, 0.1, 0.2, check);
    CheckAgainstFresh(retained, form.Data, 0.2, 1.0, check);
    CheckAgainstFresh(retained, form.Data, 1.0, 2.0, check);
  }
}

/// Every leaf of a composite input has a separate value index.
void CheckComposite(Check& check)
{
  check.SetContext("composite");
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int block = 0; block < 3; ++block)
  {
    auto image = MakeImage({ 20, 20, 20 });
    AddSmoothField(image);
    blocks->SetBlock(block, image);
  }
  IntervalRun retained;
  retained.Filter->SetInputDataObject(blocks);
  for (double lower : { 0.3, 0.4, 0.5 })
  {
    retained.Set(lower, lower + 0.01);
    retained.Filter->Update();
  }
  vtkInterlumeReport* report = retained.Filter->GetReport();
  std::cout << "composite: " << report->GetNumber("CellsVisited") << " of "
            << report->GetNumber("Cells") << " cells visited, "
            << report->GetNumber("CellsWithOutput") << " with output\n";
  check.That(report->GetNumber("CellsWithOutput") > 0, "the output is not empty");
  check.That(report->GetNumber("CellsVisited") < report->GetNumber("Cells") / 2,
    "fewer than half of the cells visited");
}

}

int TestIntervalVolumeIndex(int, char*[])
{
  Check check;
  auto image = MakeImage({ 20, 20, 20 });
  AddSmoothField(image);
  for (const DataSetVariant& form : FormsOf(image))
  {
    CheckRun<IntervalRun>(form, "intervals", check);
    CheckRun<ContourRun>(form, "contours", check);
  }
  for (MeshKind kind : { MeshKind::Wedges, MeshKind::Mixed })
  {
    auto mesh = MakeMesh(kind, { 12, 12, 12 });
    CheckRun<IntervalRun>({ GetName(kind), mesh }, "intervals", check);
  }
  CheckOtherCells(check);
  CheckFlatBlocks(check);
  CheckComposite(check);
  return check.Result();
}
