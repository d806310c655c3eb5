// SPDX-License-Identifier: BSD-3-Clause
// Progress, aborts while TetGen runs, repeatability, and PrintSelf.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMeshing.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTetrahedralMesher.h"
#include "vtkUnstructuredGrid.h"

#include <chrono>

namespace
{

using namespace reference;

void CheckRuns(vtkDataSet* input, Check& check)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputDataObject(input);
  mesher->SetMaximumVolume(0.01);
  ProgressWatch watch;
  ObserveProgress(mesher, watch);
  mesher->Update();
  vtkNew<vtkUnstructuredGrid> first;
  first->DeepCopy(mesher->GetOutput());
  check.That(first->GetNumberOfCells() > 0, "the output is not empty");
  check.That(watch.Progress.size() >= 3, "progress is reported");
  check.That(std::is_sorted(watch.Progress.begin(), watch.Progress.end()), "progress increases");
  check.That(watch.Progress.back() <= 1, "progress is at most 1");
  mesher->Modified();
  mesher->Update();
  check.That(
    FindDifference(first, mesher->GetOutput()).empty(), "a second run yields bit-identical output");
  for (std::size_t after : { 0, 1 })
  {
    watch = ProgressWatch();
    watch.AbortAfter = after;
    mesher->Modified();
    mesher->Update();
    check.Equal(mesher->GetOutput()->GetNumberOfCells(), 0, "cells after an abort");
    mesher->SetAbortExecute(0);
  }
  watch = ProgressWatch();
  mesher->Modified();
  mesher->Update();
  check.That(
    FindDifference(first, mesher->GetOutput()).empty(), "output after an abort is bit-identical");
}

/// Aborting interrupts TetGen within seconds, although meshing would take minutes.
void CheckAbortWithinTetGen(Check& check)
{
  auto box = MakeEmptySurface();
  AppendBox(box, { 0, 0, 0 }, { 1, 1, 1 });
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(box);
  mesher->SetMaximumVolume(1e-8);
  mesher->SetMaximumNumberOfAddedPoints(100000000);
  ProgressWatch watch;
  watch.AbortAfter = 4;
  ObserveProgress(mesher, watch);
  const auto start = std::chrono::steady_clock::now();
  mesher->Update();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  check.Equal(mesher->GetOutput()->GetNumberOfCells(), 0, "cells");
  check.That(time.count() < 10.0,
    "the filter returns soon after the abort: " + std::to_string(time.count()));
}

void CheckPrint(Check& check)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetQualityBound(1.25);
  mesher->SetMinimumDihedralAngle(12.5);
  mesher->SetMaximumVolume(0.375);
  mesher->SetMaximumNumberOfAddedPoints(4321);
  mesher->SetTimeLimit(87.5);
  mesher->SetWorkerFileName("nowhere");
  CheckPrinted(Print(mesher),
    { "QualityBound: 1.25", "MinimumDihedralAngle: 12.5", "MaximumVolume: 0.375",
      "MaximumNumberOfAddedPoints: 4321", "PreserveBoundary: 0", "FillNestedShells: 0",
      "SplitContacts: 1", "TimeLimit: 87.5", "WorkerFileName: nowhere", "Cells:", "CellsByTetGen",
      "CellsConed", "SkippedCells", "UnsupportedCells", "SurfaceTriangles", "SplitTriangles",
      "MergedPoints", "FoldedFaces", "FirstFoldedCell", "AddedPoints", "Regions",
      "Tetrahedra:", "TetrahedraAboveQualityBound", "TetrahedraAboveMaximumVolume",
      "LargestRadiusEdgeRatio", "SmallestVolume", "LargestVolume", "TetGenCalls" },
    check);
}

}

int TestTetrahedralMesherProgress(int, char*[])
{
  Check check;
  check.SetContext("surface");
  auto torus = MakeTorus(30, 16);
  AddRandomField(torus, 1);
  CheckRuns(torus, check);
  check.SetContext("cells");
  auto cells = MakeConcaveMesh({ 6, 6, 6 }, 0.1);
  AddRandomField(cells, 1);
  CheckRuns(cells, check);
  check.SetContext("points");
  vtkNew<vtkPolyData> points;
  points->SetPoints(cells->GetPoints());
  AddRandomField(points, 1);
  CheckRuns(points, check);
  check.SetContext("abort within TetGen");
  CheckAbortWithinTetGen(check);
  check.SetContext("print");
  CheckPrint(check);
  return check.Result();
}
