// SPDX-License-Identifier: BSD-3-Clause
// Cell types other than linear 3D cells: quadratic cells are treated as linear, with a warning.
// Lower-dimensional cells and types without a linear counterpart are skipped and counted.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceReport.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkExplicitStructuredGrid.h"
#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkQuadraticHexahedron.h"
#include "vtkQuadraticPyramid.h"
#include "vtkQuadraticTetra.h"
#include "vtkQuadraticWedge.h"
#include "vtkSphereSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkTriQuadraticHexahedron.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

const LinearFunction Function = { 0.1, { 0.3, 0.5, 0.7 } };

/// Results and warnings of vtkIntervalVolume and vtkIsotableContour for a mesh.
struct Run
{
  double Volume;
  vtkIdType Triangles;
  ReportCopy Reports[2];
  std::string Warnings[2];
  std::string Errors;
};

Run Execute(vtkDataSet* mesh)
{
  Run run;
  vtkNew<vtkTest::ErrorObserver> observers[2];
  vtkNew<vtkIntervalVolume> volume;
  volume->SetSurfaceCells(vtkIntervalVolume::NEVER);
  volume->SetInterval(0, 0.3, 0.9);
  vtkNew<vtkIsotableContour> contour;
  contour->SetValue(0, 0.6);
  vtkUnstructuredGridAlgorithm* filters[] = { volume, contour };
  for (int i = 0; i < 2; ++i)
  {
    filters[i]->AddObserver(vtkCommand::WarningEvent, observers[i]);
    filters[i]->AddObserver(vtkCommand::ErrorEvent, observers[i]);
    filters[i]->SetInputDataObject(mesh);
    filters[i]->Update();
    run.Warnings[i] = observers[i]->GetWarningMessage();
    run.Errors += observers[i]->GetErrorMessage();
  }
  run.Volume = static_cast<double>(MeasureTetrahedra(volume->GetOutput()).Sum);
  run.Triangles = contour->GetOutput()->GetNumberOfCells();
  run.Reports[0] = volume->GetReport();
  run.Reports[1] = contour->GetReport();
  return run;
}

/// Returns a mesh of one cell whose points are at the cell's parametric coordinates.
vtkSmartPointer<vtkUnstructuredGrid> MeshOf(vtkCell* cell)
{
  MeshBuilder builder;
  std::vector<vtkIdType> ids;
  const double* x = cell->GetParametricCoords();
  for (int i = 0; i < cell->GetNumberOfPoints(); ++i)
  {
    ids.push_back(builder.AddPoint(x[3 * i], x[3 * i + 1], x[3 * i + 2]));
  }
  builder.AddCell(cell->GetCellType(), ids);
  auto mesh = builder.GetMesh();
  AddLinearField(mesh, Function);
  return mesh;
}

/// Returns a mesh of the linear cell with the same corners.
vtkSmartPointer<vtkUnstructuredGrid> CornersOf(vtkUnstructuredGrid* mesh, int type, int corners)
{
  auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
  result->SetPoints(mesh->GetPoints());
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(0, ids);
  result->InsertNextCell(type, corners, ids->GetPointer(0));
  AddLinearField(result, Function);
  return result;
}

void CheckQuadratic(vtkCell* cell, int linearType, int corners, Check& check)
{
  check.SetContext(cell->GetClassName());
  auto mesh = MeshOf(cell);
  auto linear = CornersOf(mesh, linearType, corners);
  const Run run = Execute(mesh);
  const Run expected = Execute(linear);
  check.That(expected.Volume != 0, "the linear cell has a volume");
  check.Near(run.Volume, expected.Volume, 1e-14, "the volume equals the volume of the linear cell");
  check.Equal(
    run.Triangles, expected.Triangles, "the triangles equal the triangles of the linear cell");
  for (int i = 0; i < 2; ++i)
  {
    check.Equal(run.Reports[i]->GetCount("LinearizedCells"), 1, "linearized cells");
    check.That(!run.Warnings[i].empty(), "there is a warning");
    check.Equal(
      expected.Reports[i]->GetCount("LinearizedCells"), 0, "linearized cells of a linear mesh");
    check.That(expected.Warnings[i].empty(), "there is no warning for a linear mesh");
  }
  check.That(run.Errors.empty(), "there is no error");
}

void CheckFlatCells(Check& check)
{
  check.SetContext("lower-dimensional cells");
  MeshBuilder builder;
  for (int i = 0; i < 8; ++i)
  {
    builder.AddPoint(i & 1, i >> 1 & 1, i >> 2 & 1);
  }
  builder.AddCell(VTK_VERTEX, { 0 });
  builder.AddCell(VTK_POLY_VERTEX, { 0, 1, 2 });
  builder.AddCell(VTK_LINE, { 0, 1 });
  builder.AddCell(VTK_POLY_LINE, { 0, 1, 3, 2 });
  builder.AddCell(VTK_TRIANGLE, { 0, 1, 2 });
  builder.AddCell(VTK_TRIANGLE_STRIP, { 0, 1, 2, 3 });
  builder.AddCell(VTK_POLYGON, { 0, 1, 3, 2 });
  builder.AddCell(VTK_PIXEL, { 0, 1, 2, 3 });
  builder.AddCell(VTK_QUAD, { 0, 1, 3, 2 });
  builder.AddCell(VTK_QUADRATIC_EDGE, { 0, 1, 2 });
  builder.AddCell(VTK_QUADRATIC_TRIANGLE, { 0, 1, 2, 3, 4, 5 });
  builder.AddCell(VTK_VOXEL, { 0, 1, 2, 3, 4, 5, 6, 7 });
  builder.AddCell(VTK_EMPTY_CELL, {});
  auto mesh = builder.GetMesh();
  AddLinearField(mesh, Function);
  const Run run = Execute(mesh);
  const std::array<double, 3> size = { 1, 1, 1 };
  check.Near(run.Volume,
    static_cast<double>(BoxVolumeBelow(size, Function, 0.9) - BoxVolumeBelow(size, Function, 0.3)),
    1e-14, "volume of the voxel");
  for (const ReportCopy& report : run.Reports)
  {
    check.Equal(report->GetCount("Cells"), 13, "cells");
    check.That(report->GetNumber("LowerDimensionalCells") >= 11 &&
        report->GetNumber("LowerDimensionalCells") <= 12,
      "lower-dimensional cells");
    check.Equal(report->GetCount("LowerDimensionalCells") + report->GetCount("UnsupportedCells"),
      12, "the empty cell is counted as skipped or as lower-dimensional");
    check.Equal(report->GetCount("CellsWithOutput"), 1, "cells with output");
  }
  check.That(run.Errors.empty(), "there is no error");
}

void CheckPolyData(Check& check)
{
  check.SetContext("vtkPolyData");
  vtkNew<vtkSphereSource> source;
  source->Update();
  vtkPolyData* sphere = source->GetOutput();
  AddLinearField(sphere, Function);
  const Run run = Execute(sphere);
  check.That(run.Volume == 0 && run.Triangles == 0, "the output is empty");
  for (const ReportCopy& report : run.Reports)
  {
    check.Equal(
      report->GetCount("LowerDimensionalCells"), sphere->GetNumberOfCells(), "cells skipped");
  }
  check.That(run.Errors.empty(), "there is no error");
}

void CheckExplicitGrid(Check& check)
{
  check.SetContext("vtkExplicitStructuredGrid");
  vtkNew<vtkExplicitStructuredGrid> grid;
  grid->SetDimensions(2, 2, 2);
  auto mesh = MakeMesh(MeshKind::Hexahedra, { 1, 1, 1 });
  grid->SetPoints(mesh->GetPoints());
  grid->SetCells(mesh->GetCells());
  AddLinearField(grid, Function);
  AddLinearField(mesh, Function);
  const Run run = Execute(grid);
  const Run expected = Execute(mesh);
  check.Near(run.Volume, expected.Volume, 1e-14, "the volume equals the volume of the hexahedron");
  check.Equal(
    run.Triangles, expected.Triangles, "the triangles equal the triangles of the hexahedron");
  check.That(expected.Volume > 0 && run.Errors.empty(), "there is no error");
}

}

int TestIntervalVolumeCells(int, char*[])
{
  Check check;
  CheckQuadratic(vtkNew<vtkQuadraticTetra>(), VTK_TETRA, 4, check);
  CheckQuadratic(vtkNew<vtkQuadraticHexahedron>(), VTK_HEXAHEDRON, 8, check);
  CheckQuadratic(vtkNew<vtkTriQuadraticHexahedron>(), VTK_HEXAHEDRON, 8, check);
  CheckQuadratic(vtkNew<vtkQuadraticWedge>(), VTK_WEDGE, 6, check);
  CheckQuadratic(vtkNew<vtkQuadraticPyramid>(), VTK_PYRAMID, 5, check);
  CheckFlatCells(check);
  CheckPolyData(check);
  CheckExplicitGrid(check);
  return check.Result();
}
