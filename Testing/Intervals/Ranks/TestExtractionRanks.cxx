// SPDX-License-Identifier: BSD-3-Clause
// Extraction of grids that processes have in pieces, under MPI: the simplices of all processes
// together are those of one process with all of the grid, to the last bit of their coordinates.
#include "Support/Inputs/DataFiles.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferencePieceSource.h"

#include "vtkIntervalVolume.h"
#include "vtkIsotableContour.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include "vtkCallbackCommand.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkShortArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

namespace
{

using namespace reference;

/// A dataset with the values that it is asked for.
struct Case
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Data;
  double Low;
  double Middle;
  double High;
  double Change;
};

/// The points first ... last along each axis of a grid with rows.
vtkSmartPointer<vtkDataSet> ReadPart(
  const std::string& name, const char* array, int first = 0, int last = 0)
{
  vtkSmartPointer<vtkDataSet> data = interlume::ReadData(name);
  data->GetPointData()->SetActiveScalars(array);
  const int extent[6] = { first, last, first, last, first, last };
  if (vtkImageData* image = vtkImageData::SafeDownCast(data))
  {
    image->Crop(extent);
  }
  else if (vtkStructuredGrid* grid = vtkStructuredGrid::SafeDownCast(data))
  {
    grid->Crop(extent);
  }
  return data;
}

/// Bytes as short integers, which have room for what time adds.
vtkSmartPointer<vtkDataSet> MakeImage()
{
  vtkSmartPointer<vtkDataSet> image = ReadPart("neghip.vti", "SLCImage", 20, 32);
  vtkNew<vtkShortArray> scalars;
  scalars->DeepCopy(image->GetPointData()->GetScalars());
  image->GetPointData()->SetScalars(scalars);
  return image;
}

/// Few whole numbers on planes that come closer and closer, so that bounds are met everywhere.
vtkSmartPointer<vtkDataSet> MakeRectilinear()
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  const int dimensions[3] = { 8, 6, 7 };
  grid->SetDimensions(dimensions);
  vtkNew<vtkDoubleArray> coordinates[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < dimensions[axis]; ++i)
    {
      coordinates[axis]->InsertNextValue(0.37 * i - 0.011 * i * i);
    }
  }
  grid->SetXCoordinates(coordinates[0]);
  grid->SetYCoordinates(coordinates[1]);
  grid->SetZCoordinates(coordinates[2]);
  AddIntegerField(grid, 4, 7);
  return grid;
}

/// Cells of all kinds, polyhedra among them, scaled so that coordinates are rounded.
vtkSmartPointer<vtkDataSet> MakeMixed(MeshKind kind)
{
  const vtkSmartPointer<vtkUnstructuredGrid> mesh = MakeMesh(kind, { { 3, 3, 3 } }, 3);
  vtkPoints* points = mesh->GetPoints();
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    double x[3];
    points->GetPoint(id, x);
    points->SetPoint(id, 0.137 * x[0] + 0.3, 0.211 * x[1] - 0.4, 0.173 * x[2] + 0.05);
  }
  AddIntegerField(mesh, 4, 11);
  return mesh;
}

std::vector<Case> MakeCases()
{
  return {
    { "image of whole numbers", MakeImage(), 20, 60, 120, 10 },
    { "rectilinear grid with many equal values", MakeRectilinear(), 1, 2, 3, 1 },
    { "structured grid", ReadPart("bluntfin.vts", "Density", 0, 12), 0.9, 1.6, 1.9, 0.125 },
    { "unstructured grid", ReadPart("disk_out_ref.vtu", "Temp"), 450, 500, 550, 5 },
    { "cells of all kinds with many equal values", MakeMixed(MeshKind::Mixed), 1, 2, 3, 1 },
    { "polyhedra with many equal values", MakeMixed(MeshKind::Kelvin), 1, 2, 3, 1 },
  };
}

/// What is compared: an output of a filter, with the arrays that belong to a simplex.
struct Extraction
{
  std::string Name;
  vtkSmartPointer<vtkUnstructuredGridAlgorithm> Filter;
  vtkInterlumeReport* Report;
  int Port;
  std::vector<std::string> CellArrays;
  std::string Fourth;
};

std::vector<Extraction> MakeExtractions(const Case& test)
{
  const auto makeSource = [&test](int steps)
  {
    auto source = vtkSmartPointer<PieceSource>::New();
    source->SetWhole(test.Data);
    source->SetNumberOfTimeSteps(steps);
    source->SetChange(test.Change);
    return source;
  };
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInputConnection(makeSource(1)->GetOutputPort());
  volume->SetInterval(0, test.Low, test.Middle);
  volume->SetInterval(1, test.Middle, test.High);
  volume->GenerateBoundariesOn();
  vtkNew<vtkIntervalVolume> whole;
  whole->SetInputConnection(makeSource(1)->GetOutputPort());
  whole->SetInterval(0, test.Low, test.Middle);
  whole->SetInterval(1, test.Middle, test.High);
  whole->GenerateBoundariesOn();
  whole->KeepWholeCellsOn();
  vtkNew<vtkIsotableContour> contour;
  contour->SetInputConnection(makeSource(1)->GetOutputPort());
  contour->SetValue(0, test.Low);
  contour->SetValue(1, test.Middle);
  vtkNew<vtkTimeVaryingIntervalVolume> inTime;
  inTime->SetInputConnection(makeSource(3)->GetOutputPort());
  inTime->SetInterval(0, test.Low, test.Middle);
  inTime->SetInterval(1, test.Middle, test.High);
  inTime->GenerateSimplicesOn();
  inTime->SetGenerateBoundaries(true);
  volume->ReportBalanceOn();
  whole->ReportBalanceOn();
  contour->ReportBalanceOn();
  inTime->ReportBalanceOn();
  vtkInterlumeReport* const ofVolume = volume->GetReport();
  vtkInterlumeReport* const ofWhole = whole->GetReport();
  vtkInterlumeReport* const ofContour = contour->GetReport();
  vtkInterlumeReport* const ofTime = inTime->GetReport();
  return {
    { "tetrahedra", volume.Get(), ofVolume, 0, { "IntervalId" }, "" },
    { "boundary triangles", volume.Get(), ofVolume, 1, { "IntervalId", "BoundarySide" }, "" },
    { "whole cells", whole.Get(), ofWhole, 0, { "IntervalId" }, "" },
    { "boundary triangles of whole cells", whole.Get(), ofWhole, 1,
      { "IntervalId", "BoundarySide" }, "" },
    { "contours", contour.Get(), ofContour, 0, { "ContourId" }, "" },
    { "tetrahedra in time", inTime.Get(), ofTime, 0, { "IntervalId", "SimplexClass", "TimeSlab" },
      "DeltaT" },
    { "boundaries in time", inTime.Get(), ofTime, 1, { "IntervalId", "BoundaryKind" }, "Time" },
    { "4-simplices", inTime.Get(), ofTime, 2, { "IntervalId", "TimeSlab", "AtStep" }, "Time" },
  };
}

/// Numbers of a set one after the other, each simplex begun by how many it has.
std::vector<double> Flatten(const std::vector<GeometricSimplex>& set)
{
  std::vector<double> numbers;
  for (const GeometricSimplex& simplex : set)
  {
    numbers.push_back(static_cast<double>(simplex.size()));
    numbers.insert(numbers.end(), simplex.begin(), simplex.end());
  }
  return numbers;
}

/// The simplices of all processes in the first one, sorted.
std::vector<GeometricSimplex> Gather(
  vtkMultiProcessController* controller, const std::vector<GeometricSimplex>& own)
{
  vtkNew<vtkDoubleArray> sent;
  const std::vector<double> numbers = Flatten(own);
  sent->SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), sent->GetPointer(0));
  vtkNew<vtkDoubleArray> all;
  controller->GatherV(sent, all, 0);
  std::vector<GeometricSimplex> set;
  for (vtkIdType at = 0; controller->GetLocalProcessId() == 0 && at < all->GetNumberOfValues();)
  {
    const double* begin = all->GetPointer(at) + 1;
    set.emplace_back(begin, begin + static_cast<vtkIdType>(begin[-1]));
    at += 1 + static_cast<vtkIdType>(begin[-1]);
  }
  std::sort(set.begin(), set.end());
  return set;
}

std::vector<GeometricSimplex> Extract(const Extraction& extraction, int piece, int pieces)
{
  extraction.Filter->UpdateInformation();
  extraction.Filter->UpdatePiece(piece, pieces, 0);
  return GeometricSet(
    vtkUnstructuredGrid::SafeDownCast(extraction.Filter->GetOutputDataObject(extraction.Port)),
    extraction.CellArrays, extraction.Fourth);
}

std::vector<double> CellsPerProcess(const Extraction& extraction)
{
  std::vector<double> cells;
  for (vtkIdType i = 0; i < extraction.Report->GetSize("CellsPerProcess"); ++i)
  {
    cells.push_back(extraction.Report->GetNumber("CellsPerProcess", i));
  }
  return cells;
}

/// What the processes said of their work is what each has done, and the same in all of them.
void TestBalance(Check& check, vtkMultiProcessController* controller, const Extraction& extraction,
  const std::string& context)
{
  vtkInterlumeReport* report = extraction.Report;
  const std::vector<double> cells = CellsPerProcess(extraction);
  const int ranks = controller->GetNumberOfProcesses();
  vtkFieldData* fields = extraction.Filter->GetOutputDataObject(0)->GetFieldData();
  check.SetContext(context + ", balance");
  if (ranks == 1)
  {
    check.That(cells.empty(), "one process says nothing");
    check.That(!fields->HasArray("LoadBalance"), "nor does its output");
    check.Near(report->GetNumber("Balance"), 0.0, 0.0, "nothing is known");
    return;
  }
  check.Equal(static_cast<long long>(cells.size()), ranks, "processes");
  if (static_cast<int>(cells.size()) != ranks)
  {
    return;
  }
  check.Near(cells[static_cast<std::size_t>(controller->GetLocalProcessId())],
    report->GetNumber("CellsWithOutput"), 0.0, "the own cells");
  std::vector<double> largest(cells.size());
  std::vector<double> smallest(cells.size());
  controller->AllReduce(cells.data(), largest.data(), ranks, vtkCommunicator::MAX_OP);
  controller->AllReduce(cells.data(), smallest.data(), ranks, vtkCommunicator::MIN_OP);
  check.That(largest == cells && smallest == cells, "the same in all processes");
  const double sum = std::accumulate(cells.begin(), cells.end(), 0.0);
  const double most = *std::max_element(cells.begin(), cells.end());
  check.Near(
    report->GetNumber("Balance"), sum > 0.0 ? most * ranks / sum : 0.0, 0.0, "most over mean");
  vtkDataArray* shown = fields->GetArray("CellsOfProcesses");
  vtkDataArray* balance = fields->GetArray("LoadBalance");
  check.That(shown && shown->GetNumberOfValues() == ranks && balance, "the output tells it");
  if (shown && balance)
  {
    check.Near(shown->GetComponent(ranks - 1, 0), cells.back(), 0.0, "the last");
    check.Near(balance->GetComponent(0, 0), report->GetNumber("Balance"), 0.0, "the same balance");
  }
}

/// Neither an error in one process, nor an abort, nor an empty piece keeps the others waiting.
void TestBalanceOfFailures(Check& check, vtkMultiProcessController* controller, const Case& test)
{
  const int ranks = controller->GetNumberOfProcesses();
  const int rank = controller->GetLocalProcessId();
  for (const std::string failure : { "error", "abort" })
  {
    for (const Extraction& extraction : MakeExtractions(test))
    {
      if (extraction.Port != 0)
      {
        continue;
      }
      const bool isHere = ranks > 1 && rank == ranks - 1;
      const int display = vtkObject::GetGlobalWarningDisplay();
      if (isHere && failure == "error")
      {
        vtkObject::GlobalWarningDisplayOff();
        extraction.Filter->SetInputArrayToProcess(
          0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "not there");
      }
      if (isHere && failure == "abort")
      {
        vtkNew<vtkCallbackCommand> abort;
        abort->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
          { vtkAlgorithm::SafeDownCast(filter)->SetAbortExecute(1); });
        extraction.Filter->AddObserver(vtkCommand::ProgressEvent, abort);
      }
      extraction.Filter->UpdateInformation();
      extraction.Filter->UpdatePiece(rank, ranks, 0);
      vtkObject::SetGlobalWarningDisplay(display);
      TestBalance(
        check, controller, extraction, test.Name + ", " + extraction.Name + ", " + failure);
      if (isHere && failure == "error")
      {
        check.Near(extraction.Report->GetNumber("CellsWithOutput"), 0, 0.0,
          "cells of the process with an error");
      }
    }
  }
}

void TestCase(Check& check, vtkMultiProcessController* controller, const Case& test)
{
  const int ranks = controller->GetNumberOfProcesses();
  const int rank = controller->GetLocalProcessId();
  // Each filter has a source of its own, so that none is asked for other pieces in turn.
  const std::vector<Extraction> pieces = MakeExtractions(test);
  const std::vector<Extraction> wholes = MakeExtractions(test);
  for (std::size_t number = 0; number < pieces.size(); ++number)
  {
    const std::vector<GeometricSimplex> own = Extract(pieces[number], rank, ranks);
    const std::vector<GeometricSimplex> all = Gather(controller, own);
    TestBalance(check, controller, pieces[number], test.Name + ", " + pieces[number].Name);
    if (rank != 0)
    {
      continue;
    }
    const std::vector<GeometricSimplex> whole = Extract(wholes[number], 0, 1);
    const std::vector<double> found = Flatten(all);
    const std::vector<double> expected = Flatten(whole);
    check.SetContext(
      test.Name + ", " + pieces[number].Name + ", " + std::to_string(ranks) + " processes");
    check.That(!whole.empty(), "there are simplices");
    check.That(CellsPerProcess(wholes[number]).empty(), "no balance of the whole");
    if (ranks > 1)
    {
      // Of a cell that only touches a value in faces between pieces the pieces decide otherwise
      // whether it counts: up to 74 of 1868 cells were seen.
      const std::vector<double> cells = CellsPerProcess(pieces[number]);
      check.Near(std::accumulate(cells.begin(), cells.end(), 0.0),
        wholes[number].Report->GetNumber("CellsWithOutput"), 0.05,
        "cells with output of all processes");
    }
    check.Equal(static_cast<long long>(all.size()), static_cast<long long>(whole.size()),
      "number of simplices");
    check.That(found.size() == expected.size() &&
        std::memcmp(found.data(), expected.data(), sizeof(double) * found.size()) == 0,
      "the same bytes");
    std::cout << test.Name << ", " << pieces[number].Name << ": " << whole.size()
              << ", the first has " << own.size() << ", balance "
              << pieces[number].Report->GetNumber("Balance") << std::endl;
  }
}

}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  Check check;
  for (const Case& test : MakeCases())
  {
    TestCase(check, controller, test);
  }
  TestBalanceOfFailures(check, controller, MakeCases().front());
  const int own = check.Result();
  int result = EXIT_SUCCESS;
  controller->AllReduce(&own, &result, 1, vtkCommunicator::MAX_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return result;
}
