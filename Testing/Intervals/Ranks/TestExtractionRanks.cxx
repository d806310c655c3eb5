// SPDX-License-Identifier: BSD-3-Clause
// Distributed extraction under MPI: the simplices of all processes together equal the simplices of
// a single process, with bit-identical coordinates.
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

/// A dataset with active scalars, the values to extract, and the scalar change per time step.
struct Case
{
  std::string Name;
  vtkSmartPointer<vtkDataSet> Data;
  double Low;
  double Center;
  double High;
  double Change;
};

/// Reads a dataset. Crops a structured dataset to the points \a first to \a last along each axis.
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

/// Returns part of a volume, converted from bytes to short integers so that the values added per
/// time step do not overflow.
vtkSmartPointer<vtkDataSet> MakeImage()
{
  vtkSmartPointer<vtkDataSet> image = ReadPart("neghip.vti", "SLCImage", 20, 32);
  vtkNew<vtkShortArray> scalars;
  scalars->DeepCopy(image->GetPointData()->GetScalars());
  image->GetPointData()->SetScalars(scalars);
  return image;
}

/// Returns a grid with decreasing spacing and small integers as scalars, so that interval bounds
/// equal scalars in many cells.
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

/// Returns a mesh whose coordinates are not exactly representable. Its scalars are small integers.
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
    { "image of integers", MakeImage(), 20, 60, 120, 10 },
    { "rectilinear grid with many equal values", MakeRectilinear(), 1, 2, 3, 1 },
    { "structured grid", ReadPart("bluntfin.vts", "Density", 0, 12), 0.9, 1.6, 1.9, 0.125 },
    { "unstructured grid", ReadPart("disk_out_ref.vtu", "Temp"), 450, 500, 550, 5 },
    { "cells of all kinds with many equal values", MakeMixed(MeshKind::Mixed), 1, 2, 3, 1 },
    { "polyhedra with many equal values", MakeMixed(MeshKind::Kelvin), 1, 2, 3, 1 },
  };
}

/// An output of a filter and the arrays to compare per simplex.
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
    source->SetFullData(test.Data);
    source->SetNumberOfTimeSteps(steps);
    source->SetChange(test.Change);
    return source;
  };
  vtkNew<vtkIntervalVolume> volume;
  volume->SetInputConnection(makeSource(1)->GetOutputPort());
  volume->SetInterval(0, test.Low, test.Center);
  volume->SetInterval(1, test.Center, test.High);
  volume->GenerateBoundariesOn();
  vtkNew<vtkIntervalVolume> single;
  single->SetInputConnection(makeSource(1)->GetOutputPort());
  single->SetInterval(0, test.Low, test.Center);
  single->SetInterval(1, test.Center, test.High);
  single->GenerateBoundariesOn();
  single->KeepInteriorCellsOn();
  vtkNew<vtkIsotableContour> contour;
  contour->SetInputConnection(makeSource(1)->GetOutputPort());
  contour->SetValue(0, test.Low);
  contour->SetValue(1, test.Center);
  vtkNew<vtkTimeVaryingIntervalVolume> inTime;
  inTime->SetInputConnection(makeSource(3)->GetOutputPort());
  inTime->SetInterval(0, test.Low, test.Center);
  inTime->SetInterval(1, test.Center, test.High);
  inTime->GenerateSimplicesOn();
  inTime->SetGenerateBoundaries(true);
  volume->ReportBalanceOn();
  single->ReportBalanceOn();
  contour->ReportBalanceOn();
  inTime->ReportBalanceOn();
  vtkInterlumeReport* const ofVolume = volume->GetReport();
  vtkInterlumeReport* const ofFull = single->GetReport();
  vtkInterlumeReport* const ofContour = contour->GetReport();
  vtkInterlumeReport* const ofTime = inTime->GetReport();
  return {
    { "tetrahedra", volume.Get(), ofVolume, 0, { "IntervalId" }, "" },
    { "boundary triangles", volume.Get(), ofVolume, 1, { "IntervalId", "BoundarySide" }, "" },
    { "interior cells", single.Get(), ofFull, 0, { "IntervalId" }, "" },
    { "boundary triangles of interior cells", single.Get(), ofFull, 1,
      { "IntervalId", "BoundarySide" }, "" },
    { "contours", contour.Get(), ofContour, 0, { "ContourId" }, "" },
    { "tetrahedra in time", inTime.Get(), ofTime, 0, { "IntervalId", "SimplexClass", "TimeSlab" },
      "DeltaT" },
    { "boundaries in time", inTime.Get(), ofTime, 1, { "IntervalId", "BoundaryKind" }, "Time" },
    { "4-simplices", inTime.Get(), ofTime, 2, { "IntervalId", "TimeSlab", "AtStep" }, "Time" },
  };
}

/// Concatenates the coordinates and values of all simplices. Each simplex is preceded by the number
/// of its values.
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

/// Collects the sorted simplices of all processes in process 0.
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

/// Checks that every process reports the same, correct numbers of cells per process.
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
    check.That(cells.empty(), "one process does not report cells per process");
    check.That(!fields->HasArray("LoadBalance"), "the output has no load balance array");
    check.Near(report->GetNumber("Balance"), 0.0, 0.0, "the balance is 0");
    return;
  }
  check.Equal(static_cast<long long>(cells.size()), ranks, "processes");
  if (static_cast<int>(cells.size()) != ranks)
  {
    return;
  }
  check.Near(cells[static_cast<std::size_t>(controller->GetLocalProcessId())],
    report->GetNumber("CellsWithOutput"), 0.0, "cells of this process");
  std::vector<double> largest(cells.size());
  std::vector<double> smallest(cells.size());
  controller->AllReduce(cells.data(), largest.data(), ranks, vtkCommunicator::MAX_OP);
  controller->AllReduce(cells.data(), smallest.data(), ranks, vtkCommunicator::MIN_OP);
  check.That(largest == cells && smallest == cells, "all processes have the same values");
  const double sum = std::accumulate(cells.begin(), cells.end(), 0.0);
  const double largestNumber = *std::max_element(cells.begin(), cells.end());
  check.Near(report->GetNumber("Balance"), sum > 0.0 ? largestNumber * ranks / sum : 0.0, 0.0,
    "the balance is the maximum over the mean");
  vtkDataArray* shown = fields->GetArray("CellsOfProcesses");
  vtkDataArray* balance = fields->GetArray("LoadBalance");
  check.That(shown && shown->GetNumberOfValues() == ranks && balance,
    "the output has the load balance arrays");
  if (shown && balance)
  {
    check.Near(shown->GetComponent(ranks - 1, 0), cells.back(), 0.0, "cells of the last process");
    check.Near(balance->GetComponent(0, 0), report->GetNumber("Balance"), 0.0,
      "the array has the reported balance");
  }
}

/// An error in one process, an abort or an empty piece must not block the other processes.
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
        check.Equal(
          extraction.Report->GetCount("CellsWithOutput"), 0, "cells of the process with an error");
      }
    }
  }
}

void TestCase(Check& check, vtkMultiProcessController* controller, const Case& test)
{
  const int ranks = controller->GetNumberOfProcesses();
  const int rank = controller->GetLocalProcessId();
  // Each filter has its own source. A shared source would be updated for different pieces in turn.
  const std::vector<Extraction> pieces = MakeExtractions(test);
  const std::vector<Extraction> singles = MakeExtractions(test);
  for (std::size_t number = 0; number < pieces.size(); ++number)
  {
    const std::vector<GeometricSimplex> own = Extract(pieces[number], rank, ranks);
    const std::vector<GeometricSimplex> all = Gather(controller, own);
    TestBalance(check, controller, pieces[number], test.Name + ", " + pieces[number].Name);
    if (rank != 0)
    {
      continue;
    }
    const std::vector<GeometricSimplex> single = Extract(singles[number], 0, 1);
    const std::vector<double> found = Flatten(all);
    const std::vector<double> expected = Flatten(single);
    check.SetContext(
      test.Name + ", " + pieces[number].Name + ", " + std::to_string(ranks) + " processes");
    check.That(!single.empty(), "there are simplices");
    check.That(CellsPerProcess(singles[number]).empty(), "no load balance for a single process");
    if (ranks > 1)
    {
      // Cells that reach a bound only on a face between pieces may be counted differently than with
      // a single process, hence the tolerance.
      const std::vector<double> cells = CellsPerProcess(pieces[number]);
      check.Near(std::accumulate(cells.begin(), cells.end(), 0.0),
        singles[number].Report->GetNumber("CellsWithOutput"), 0.05,
        "cells with output of all processes");
    }
    check.Equal(static_cast<long long>(all.size()), static_cast<long long>(single.size()),
      "number of simplices");
    check.That(found.size() == expected.size() &&
        std::memcmp(found.data(), expected.data(), sizeof(double) * found.size()) == 0,
      "coordinates are bit-identical");
    std::cout << test.Name << ", " << pieces[number].Name << ": " << single.size()
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
