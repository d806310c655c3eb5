// SPDX-License-Identifier: BSD-3-Clause
// Settings of vtkImplicitFlowField: their effect on streamlines, output and requests to inputs.
// Also tests ids of surfaces and spheres, and pieces of meshes.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationBox.h"
#include "vtkTerminationCylinder.h"
#include "vtkTerminationPlane.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace reference;

Vector Uniform(const Vector&)
{
  return { { 0.5, 0.0, 0.0 } };
}

double GetValue(vtkDataSet* data, const char* name, vtkIdType id)
{
  return data->GetPointData()->GetArray(name)->GetComponent(id, 0);
}

vtkDataSet* Update(vtkImplicitFlowField* filter)
{
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

/// Tests the maximum time, the maximum error and the minimum speed, and automatic values for a
/// field without flow.
void TestLimits(Check& check)
{
  vtkNew<vtkImplicitFlowField> filter;
  check.Equal(filter->GetMaximumNumberOfSteps(), 0, "default steps");
  check.That(filter->GetArrivalTolerance() == 0.01, "default tolerance");
  filter->SetInputDataObject(MakeFlowImage(5, Uniform));
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  filter->SetMaximumTime(5.0);
  vtkDataSet* output = Update(filter);
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    const double time = 2.0 * output->GetPoint(id)[0];
    check.Equal(static_cast<int>(GetValue(output, "FlowStatus", id)),
      time < 5.0 ? vtkFlowStatus::REACHED_SURFACE : vtkFlowStatus::OUT_OF_TIME,
      "status of exceeding the time");
    check.Near(GetValue(output, "AdvectionTime", id), std::min(5.0, time), 1e-12, "time", 1.0);
  }
  filter->SetMaximumError(0.125);
  filter->SetMinimumSpeed(0.75);
  Update(filter);
  check.That(filter->GetReport()->GetNumber("MaximumError") == 0.125, "the error that is set");
  check.That(filter->GetReport()->GetNumber("MinimumSpeed") == 0.75, "the speed that is set");
  check.Equal(filter->GetReport()->GetCount("Statuses", vtkFlowStatus::STAGNATED), 100,
    "all streamlines are too slow");
  filter->SetMaximumError(0.0);
  filter->SetMinimumSpeed(0.0);
  filter->SetInputDataObject(MakeFlowImage(5, [](const Vector&) { return Vector{}; }));
  Update(filter);
  check.That(filter->GetReport()->GetNumber("MaximumError") == std::numeric_limits<double>::min(),
    "the minimum error for a field without flow");
  check.Equal(filter->GetReport()->GetCount("Statuses", vtkFlowStatus::STAGNATED), 100,
    "the minimum speed for a field without flow");
}

/// Tests that each integration method takes steps of its kind only, and that step counts are stored
/// in arrays if requested.
void TestMethods(Check& check)
{
  vtkNew<vtkImplicitFlowField> filter;
  auto image = MakeFlowImage(5, Uniform);
  AddRandomVectors(image, 3);
  filter->SetInputDataObject(image);
  filter->SetMaximumNumberOfSteps(500);
  filter->DomainFacesOn();
  vtkIdType evaluations = 0;
  for (const int integrator : { vtkImplicitFlowField::DORMAND_PRINCE,
         vtkImplicitFlowField::RUNGE_KUTTA_4, vtkImplicitFlowField::ROSENBROCK })
  {
    check.SetContext("integrator " + std::to_string(integrator));
    const bool isStiff = integrator == vtkImplicitFlowField::ROSENBROCK;
    filter->SetIntegrator(integrator);
    filter->StoreStepCountsOff();
    check.That(Update(filter)->GetPointData()->GetArray("AdvectionSteps") == nullptr &&
        Update(filter)->GetPointData()->GetArray("StiffSteps") == nullptr,
      "no step arrays by default");
    filter->StoreStepCountsOn();
    vtkDataSet* output = Update(filter);
    double steps = 0.0;
    double stiffSteps = 0.0;
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
    {
      steps += GetValue(output, "AdvectionSteps", id);
      stiffSteps += GetValue(output, "StiffSteps", id);
    }
    vtkInterlumeReport* report = filter->GetReport();
    check.Near(steps, report->GetNumber("Steps"), 0.0, "steps of all samples");
    check.Near(stiffSteps, report->GetNumber("StiffSteps"), 0.0, "stiff steps of all samples");
    check.That((isStiff ? stiffSteps : steps) > 100.0, "steps of the method");
    check.Near(isStiff ? steps : stiffSteps, 0.0, 0.0, "steps of other methods");
    check.That(isStiff || report->GetNumber("RejectedSteps") > 0, "some steps are rejected");
    check.That(evaluations != report->GetNumber("Evaluations"), "evaluations of the method");
    evaluations = report->GetNumber("Evaluations");
  }
  check.SetContext("");
}

std::vector<std::vector<int>> GetSurfaces(vtkDataSet* output)
{
  std::vector<std::vector<int>> rows;
  auto* table = vtkIntArray::SafeDownCast(output->GetFieldData()->GetArray("TerminationSurfaces"));
  for (vtkIdType i = 0; table && i < table->GetNumberOfTuples(); ++i)
  {
    const int* tuple = table->GetPointer(3 * i);
    rows.emplace_back(tuple, tuple + 3);
  }
  return rows;
}

/// Automatic ids skip the ids of all parts of other surfaces, so ids are unique. Also tests
/// periodic parameters.
void TestIds(Check& check)
{
  vtkNew<vtkTerminationBox> box;
  box->SetId(1);
  vtkNew<vtkTerminationCylinder> cylinder;
  cylinder->SetId(20);
  auto same = MakeFlowPlane(1.0);
  same->SetId(20);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(MakeFlowImage(5, Uniform));
  auto removed = MakeFlowPlane(3.5);
  filter->AddTerminationSurface(removed);
  auto first = MakeFlowPlane(2.0);
  filter->AddTerminationSurface(first);
  filter->AddTerminationSurface(MakeFlowPlane(3.0));
  filter->AddTerminationSurface(box);
  filter->AddTerminationSurface(cylinder);
  filter->AddTerminationSurface(same);
  filter->RemoveTerminationSurface(removed);
  check.Equal(filter->GetNumberOfTerminationSurfaces(), 5, "surfaces");
  check.That(filter->GetTerminationSurface(0) == first, "another surface is removed");
  filter->DomainFacesOn();
  filter->SetDomainFaceId(300);
  vtkDataSet* output = Update(filter);
  std::vector<std::vector<int>> expected = { { 0, 0, 0 } };
  const int next = 1 + box->GetNumberOfParts();
  expected.push_back({ next, 0, 0 });
  for (int part = 0; part < box->GetNumberOfParts(); ++part)
  {
    expected.push_back({ 1 + part, 0, 0 });
  }
  for (int part = 0; part < cylinder->GetNumberOfParts(); ++part)
  {
    expected.push_back(
      { 20 + part, cylinder->IsPeriodic(0, part) ? 1 : 0, cylinder->IsPeriodic(1, part) ? 1 : 0 });
  }
  check.Equal(
    expected[static_cast<std::size_t>(2 + box->GetNumberOfParts())][1], 1, "u is periodic");
  check.Equal(
    expected[static_cast<std::size_t>(2 + box->GetNumberOfParts())][2], 0, "v is not periodic");
  for (int face = 0; face < 6; ++face)
  {
    expected.push_back({ 300 + face, 0, 0 });
  }
  check.That(GetSurfaces(output) == expected, "the table of surfaces");
  filter->RemoveAllTerminationSurfaces();
  check.Equal(static_cast<int>(GetValue(Update(filter), "TerminationId", 2)), 300, "id of a face");
}

vtkIdType CountReached(vtkImplicitFlowField* filter, int id)
{
  vtkInterlumeReport* report = filter->GetReport();
  vtkIdType reached = 0;
  for (vtkIdType i = 0; i < report->GetSize("SurfaceIds"); ++i)
  {
    reached +=
      report->GetNumber("SurfaceIds", i) == id ? report->GetNumber("SamplesBySurface", i) : 0;
  }
  return reached;
}

/// Two flow sources have separate spheres, and spirals have spheres too.
void TestSpheres(Check& check)
{
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(MakeFlowImage(17,
    [](const Vector& x) {
      return Vector{ { (x[0] - 0.7) * (x[0] - 2.1) * (x[0] - 3.3), x[1] - 1.9, x[2] - 1.8 } };
    }));
  filter->CriticalPointSpheresOn();
  filter->SetCriticalPointId(500);
  vtkDataSet* output = Update(filter);
  check.Equal(filter->GetReport()->GetSize("SurfaceIds"), 2, "two spheres");
  const double low = GetValue(output, "TerminationId", 0);
  check.That(low == 500.0 || low == 501.0, "ids start at the given id");
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    const bool isLow = output->GetPoint(id)[0] < 2.1;
    check.That(GetValue(output, "FlowStatus", id) != vtkFlowStatus::REACHED_SURFACE ||
        GetValue(output, "TerminationId", id) == (isLow ? low : 1001.0 - low),
      "each side reaches its sphere");
  }
  filter->SetInputDataObject(MakeFlowImage(9,
    [](const Vector& x)
    {
      return Vector{ { 1.9 - x[0] + 3.0 * (x[1] - 2.1), 2.1 - x[1] - 3.0 * (x[0] - 1.9),
        1.8 - x[2] } };
    }));
  filter->SetDirectionToForward();
  Update(filter);
  check.That(CountReached(filter, 500) > 500, "a spiral sink");
  filter->SetInputDataObject(MakeFlowImage(9,
    [](const Vector& x)
    {
      return Vector{ { x[0] - 1.9 + 3.0 * (x[1] - 2.1), x[1] - 2.1 - 3.0 * (x[0] - 1.9),
        x[2] - 1.8 } };
    }));
  filter->SetDirectionToBackward();
  Update(filter);
  check.That(CountReached(filter, 500) > 500, "a spiral source");
}

vtkSmartPointer<vtkDoubleArray> MakeArray(
  vtkDataSet* data, const char* name, const std::function<double(const double*)>& value)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    array->InsertNextValue(value(data->GetPoint(id)));
  }
  data->GetPointData()->AddArray(array);
  return array;
}

/// Each array has its own mean, and only one if the array is added twice. Arrays with several
/// components are rejected.
void TestMeans(Check& check)
{
  auto image = MakeFlowImage(5, Uniform);
  MakeArray(image, "Along", [](const double* x) { return x[0]; });
  MakeArray(image, "Across", [](const double* x) { return x[1]; });
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  for (const char* name : { "Along", "Across", "Along" })
  {
    filter->AddMeanArray(name);
  }
  check.Equal(filter->GetNumberOfMeanArrays(), 2, "arrays with a mean");
  vtkDataSet* output = Update(filter);
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    const double* x = output->GetPoint(id);
    check.Near(GetValue(output, "MeanAlong", id), 0.5 * x[0], 1e-12, "mean along the flow", 1.0);
    check.Near(GetValue(output, "MeanAcross", id), x[1], 1e-12, "mean across the flow", 1.0);
  }
  filter->AddMeanArray(image->GetPointData()->GetVectors()->GetName());
  const std::string wrong = UpdateAndGetErrors(filter);
  check.That(wrong.find("Cannot compute a mean along streamlines: array \"") != std::string::npos &&
      wrong.find("\" has 3 components; 1 is needed.") != std::string::npos,
    "no mean of vectors");
}

/// The filter requests the whole field, but only one piece of samples from another input.
void TestRequests(Check& check)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  auto mesh = MakeFlowMesh(MeshKind::Hexahedra, { { 4, 4, 4 } });
  AddVectors(mesh, Uniform);
  auto image = MakeFlowImage(5, Uniform);
  for (vtkDataSet* field : { static_cast<vtkDataSet*>(mesh), static_cast<vtkDataSet*>(image) })
  {
    vtkNew<vtkImplicitFlowField> filter;
    filter->SetInputDataObject(field);
    filter->AddTerminationSurface(MakeFlowPlane(0.0));
    filter->SetSampleData(mesh);
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
    filter->UpdateInformation();
    filter->UpdatePiece(1, 3, 0);
    vtkInformation* information = filter->GetInputInformation(0, 0);
    check.Equal(information->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), 1, "pieces of the field");
    check.Equal(information->Get(Pipeline::UPDATE_PIECE_NUMBER()), 0, "piece of the field");
    vtkInformation* samples = filter->GetInputInformation(1, 0);
    check.Equal(samples->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()), 3, "pieces of the samples");
    check.Equal(samples->Get(Pipeline::UPDATE_PIECE_NUMBER()), 1, "piece of the samples");
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
    filter->UpdatePiece(1, 3, 0);
    if (field == image)
    {
      int extent[6];
      filter->GetInputInformation(0, 0)->Get(Pipeline::UPDATE_EXTENT(), extent);
      check.That(
        extent[1] - extent[0] == 4 && extent[3] - extent[2] == 4 && extent[5] - extent[4] == 4,
        "the whole extent of an image");
    }
  }
}

/// Pieces of a mesh preserve point, cell and field data.
void TestPieces(Check& check)
{
  auto mesh = MakeFlowMesh(MeshKind::Tetrahedra6, { { 4, 3, 2 } });
  AddVectors(mesh, Uniform);
  vtkNew<vtkPoints> doubles;
  doubles->SetDataTypeToDouble();
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    doubles->InsertNextPoint(mesh->GetPoint(id));
  }
  mesh->SetPoints(doubles);
  vtkNew<vtkIdTypeArray> points;
  points->SetName("PointNumber");
  for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
  {
    points->InsertNextValue(id);
  }
  mesh->GetPointData()->SetGlobalIds(points);
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("CellNumber");
  for (vtkIdType id = 0; id < mesh->GetNumberOfCells(); ++id)
  {
    cells->InsertNextValue(id);
  }
  mesh->GetCellData()->SetGlobalIds(cells);
  vtkNew<vtkIntArray> note;
  note->SetName("Note");
  note->InsertNextValue(9);
  mesh->GetFieldData()->AddArray(note);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(mesh);
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  vtkIdType next = 0;
  for (int piece = 0; piece < 5; ++piece)
  {
    filter->UpdatePiece(piece, 5, 0);
    auto* part = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
    check.Equal(part->GetPoints()->GetDataType(), VTK_DOUBLE, "coordinates");
    check.That(part->GetFieldData()->GetArray("Note") != nullptr, "field data");
    auto* pointIds = part->GetPointData()->GetGlobalIds();
    auto* cellIds = part->GetCellData()->GetGlobalIds();
    if (!check.That(pointIds && cellIds, "global ids"))
    {
      return;
    }
    for (vtkIdType id = 0; id < part->GetNumberOfPoints(); ++id)
    {
      const double* x = mesh->GetPoint(static_cast<vtkIdType>(pointIds->GetComponent(id, 0)));
      const Vector expected = { { x[0], x[1], x[2] } };
      for (int i = 0; i < 3; ++i)
      {
        check.Near(
          part->GetPoint(id)[i], expected[static_cast<std::size_t>(i)], 0.0, "the input point");
      }
    }
    for (vtkIdType id = 0; id < part->GetNumberOfCells(); ++id)
    {
      check.Near(cellIds->GetComponent(id, 0), static_cast<double>(next), 0.0, "the input cell");
      double bounds[6];
      double expected[6];
      part->GetCellBounds(id, bounds);
      mesh->GetCellBounds(next++, expected);
      check.That(std::equal(bounds, bounds + 6, expected), "the position of the cell");
    }
  }
  check.Equal(next, mesh->GetNumberOfCells(), "cells of all pieces");
}

/// Vectors with too few tuples are errors.
void TestVectors(Check& check)
{
  auto image = MakeFlowImage(3, Uniform);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  vtkNew<vtkDoubleArray> few;
  few->SetName("Few");
  few->SetNumberOfComponents(3);
  few->SetNumberOfTuples(8);
  few->Fill(1.0);
  image->GetPointData()->AddArray(few);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Few");
  CheckError(filter, "\"Few\" has 8 tuples; 27 are needed, one for each point", check);
}

}

int TestImplicitFlowFieldSettings(int, char*[])
{
  Check check;
  TestLimits(check);
  TestMethods(check);
  TestIds(check);
  TestSpheres(check);
  TestMeans(check);
  TestRequests(check);
  TestPieces(check);
  TestVectors(check);
  return check.Result();
}
