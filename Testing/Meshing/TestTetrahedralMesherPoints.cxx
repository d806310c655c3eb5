// SPDX-License-Identifier: BSD-3-Clause
// Input of points only: their Delaunay tetrahedralization, refined if a bound is set.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMeshing.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTestErrorObserver.h"
#include "vtkTetra.h"
#include "vtkTetrahedralMesher.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iostream>
#include <random>

namespace
{

using namespace reference;

const LinearFunction Function = { 0.25, { 1.5, -2.5, 3.5 } };

/// Returns the corners of a unit cube and random points inside.
vtkSmartPointer<vtkPolyData> MakePoints(int number)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint(i & 1, i >> 1 & 1, i >> 2 & 1);
  }
  std::mt19937 random(3);
  for (int i = 0; i < number; ++i)
  {
    double x[3];
    for (double& coordinate : x)
    {
      coordinate = random() / 4294967296.0;
    }
    points->InsertNextPoint(x);
  }
  data->SetPoints(points);
  AddLinearField(data, Function);
  return data;
}

void CheckDelaunay(vtkUnstructuredGrid* mesh, Check& check)
{
  int inside = 0;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(t, ids);
    double x[4][3];
    for (int i = 0; i < 4; ++i)
    {
      mesh->GetPoint(ids->GetId(i), x[i]);
    }
    double center[3];
    const double square = vtkTetra::Circumsphere(x[0], x[1], x[2], x[3], center);
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      double y[3];
      mesh->GetPoint(p, y);
      inside += vtkMath::Distance2BetweenPoints(center, y) < square * (1 - 1e-9);
    }
  }
  check.Equal(inside, 0, "points within a circumscribed sphere");
}

void CheckMesh(vtkUnstructuredGrid* mesh, Check& check)
{
  const TetrahedraReport report = Inspect(mesh);
  check.That(report.Tetrahedra > 0, "there are tetrahedra");
  check.Equal(report.NotPositive + report.FacesTooOften + report.FacesTurned, 0, "a valid mesh");
  check.Near(report.Volume, 1.0, 1e-12, "volume of the hull");
  check.Near(report.BoundaryVolume, 1.0, 1e-12, "volume within the outer faces");
  check.That(LinearError(mesh, "f", Function) < 1e-12, "a linear field is reproduced");
}

}

int TestTetrahedralMesherPoints(int, char*[])
{
  Check check;
  auto points = MakePoints(300);
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(points);
  mesher->Update();
  check.SetContext("Delaunay");
  CheckMesh(mesher->GetOutput(), check);
  CheckDelaunay(mesher->GetOutput(), check);
  check.Equal(mesher->GetOutput()->GetNumberOfPoints(), 308, "points");
  check.Equal(mesher->GetReport()->GetCount("AddedPoints"), 0, "points added");

  check.SetContext("a regular grid: many points on one sphere");
  vtkNew<vtkPoints> boxGrid;
  for (const auto& [k, j, i] : AllIndices(5, 5, 5))
  {
    boxGrid->InsertNextPoint(i / 4.0, j / 4.0, k / 4.0);
  }
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(boxGrid);
  AddLinearField(grid, Function);
  mesher->SetInputData(grid);
  mesher->Update();
  CheckMesh(mesher->GetOutput(), check);
  CheckDelaunay(mesher->GetOutput(), check);

  check.SetContext("every point twice");
  auto twice = MakePoints(50);
  for (vtkIdType p = 0; p < 58; ++p)
  {
    double x[3];
    twice->GetPoint(p, x);
    twice->GetPoints()->InsertNextPoint(x);
  }
  AddLinearField(twice, Function);
  mesher->SetInputData(twice);
  mesher->Update();
  CheckMesh(mesher->GetOutput(), check);
  check.Equal(mesher->GetOutput()->GetNumberOfPoints(), 58, "distinct points");
  check.Equal(mesher->GetReport()->GetCount("MergedPoints"), 58, "merged points");

  check.SetContext("refined");
  auto coarse = MakePoints(50);
  AddRandomField(coarse, 9, "random");
  mesher->SetInputData(coarse);
  for (double volume : { 0.0, 0.001 })
  {
    mesher->SetQualityBound(2.0);
    mesher->SetMaximumVolume(volume);
    mesher->Update();
    CheckMesh(mesher->GetOutput(), check);
    vtkInterlumeReport* report = mesher->GetReport();
    std::cout << report->GetNumber("Tetrahedra") << " tetrahedra, "
              << report->GetNumber("AddedPoints") << " points added, ratio "
              << report->GetNumber("LargestRadiusEdgeRatio") << ", largest "
              << report->GetNumber("LargestVolume") << "\n";
    check.That(report->GetNumber("LargestRadiusEdgeRatio") <= 2.0 * (1 + 1e-9),
      "the quality bound is satisfied");
    check.That(volume == 0.0 || report->GetNumber("LargestVolume") <= volume * (1 + 1e-9),
      "the maximum volume is satisfied");
    check.That(report->GetNumber("AddedPoints") > 0, "points are added");
    // Interpolated values lie between the values at the surrounding tetrahedron's points.
    double range[2];
    mesher->GetOutput()->GetPointData()->GetArray("random")->GetRange(range);
    check.That(
      range[0] >= -1e-9 && range[1] <= 1 + 1e-9, "interpolated values are within the input range");
  }
  return check.Result();
}
