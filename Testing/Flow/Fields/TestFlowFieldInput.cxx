// SPDX-License-Identifier: BSD-3-Clause
// Inputs of flow filters: grids with boundary triangles, blocks with float and double vectors, and
// blocks next to surface patches. Also tests messages for planar fields, and that a
// filter executes again after an abort.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowBoundary.h"
#include "vtkFlowCriticalPoints.h"
#include "vtkFlowLIC.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkTerminationPlane.h"

#include "vtkCallbackCommand.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <functional>
#include <string>

namespace
{

using namespace reference;

Vector Shear(const Vector& x)
{
  return { { 1.0, 0.25 * x[2], 0.125 } };
}

vtkSmartPointer<vtkImplicitFlowField> NewFilter(vtkDataObject* input)
{
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputDataObject(input);
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  return filter;
}

void Expect(vtkAlgorithm* filter, const std::string& part, Check& check)
{
  const std::string found = UpdateAndGetErrors(filter);
  check.Contains(found, part);
}

vtkSmartPointer<vtkImageData> MakeBlock(int start, int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(3, 5, 5);
  image->SetOrigin(start, 0.0, 0.0);
  AddVectors(image, Shear, type);
  return image;
}

double GetTimes(vtkImplicitFlowField* filter)
{
  vtkDataArray* times = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))
                          ->GetPointData()
                          ->GetArray("AdvectionTime");
  double sum = 0.0;
  for (vtkIdType id = 0; times && id < times->GetNumberOfTuples(); ++id)
  {
    sum += times->GetComponent(id, 0);
  }
  return sum;
}

void TestBoundary(Check& check)
{
  check.SetContext("boundary triangles");
  const auto grid = MakeFlowMesh(MeshKind::Tetrahedra6, { { 4, 4, 4 } });
  AddVectors(grid, Shear);
  auto whole = NewFilter(grid);
  check.That(UpdateAndGetErrors(whole).empty(), "only tetrahedra");
  vtkNew<vtkUnstructuredGrid> both;
  both->DeepCopy(grid);
  vtkNew<vtkIdList> corners;
  const vtkIdType tetrahedra = grid->GetNumberOfCells();
  for (vtkIdType cell = 0; cell < tetrahedra; ++cell)
  {
    grid->GetCellPoints(cell, corners);
    corners->SetNumberOfIds(3);
    both->InsertNextCell(VTK_TRIANGLE, corners);
  }
  auto filter = NewFilter(both);
  check.That(UpdateAndGetErrors(filter).empty(), "no error");
  check.Equal(filter->GetReport()->GetCount("LowerDimensionalCells"), tetrahedra, "counted");
  check.Equal(whole->GetReport()->GetCount("LowerDimensionalCells"), 0, "no triangles to count");
  check.Near(GetTimes(filter), GetTimes(whole), 1e-12, "the results are unchanged");
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(filter->GetOutputPort());
  check.That(UpdateAndGetErrors(volume).empty(), "a volume without errors");
  check.That(volume->GetOutput()->GetNumberOfCells() > 0, "the volume has tetrahedra");
  vtkNew<vtkFlowCriticalPoints> points;
  points->SetInputData(both);
  const std::string none = WarningsOf(points);
  check.Contains(none, "no isolated critical point");
  // A separate block with one triangle and without vectors.
  vtkNew<vtkPolyData> patch;
  patch->SetPoints(grid->GetPoints());
  patch->AllocateEstimate(1, 3);
  patch->InsertNextCell(VTK_TRIANGLE, 3, corners->GetPointer(0));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, patch);
  blocks->SetBlock(1, grid);
  auto composite = NewFilter(blocks);
  const std::string wrong = UpdateAndGetErrors(composite);
  check.That(wrong.empty(), "a block of triangles is skipped: " + wrong);
  check.Near(GetTimes(composite), GetTimes(whole), 1e-12, "the results are unchanged by the block");
}

void TestTypes(Check& check)
{
  check.SetContext("types of blocks");
  double known = 0.0;
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, MakeBlock(0, VTK_DOUBLE));
    blocks->SetBlock(1, MakeBlock(2, type));
    auto filter = NewFilter(blocks);
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
    check.That(UpdateAndGetErrors(filter).empty(), "no error");
    auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    check.Equal(output->GetNumberOfPoints(), 125, "number of samples of both");
    check.Equal(output->GetPointData()->GetVectors()->GetDataType(), VTK_DOUBLE, "vectors");
    check.That(type == VTK_DOUBLE || std::abs(GetTimes(filter) - known) < 1e-6, "the same results");
    known = GetTimes(filter);
    check.That(known > 100.0, "times");
  }
}

void TestPlane(Check& check)
{
  check.SetContext("plane");
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 5, 1);
  AddVectors(image, Shear);
  vtkNew<vtkUnstructuredGrid> quads;
  vtkNew<vtkPoints> points;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    points->InsertNextPoint(image->GetPoint(id));
  }
  quads->SetPoints(points);
  const vtkIdType corners[4] = { 0, 1, 6, 5 };
  quads->InsertNextCell(VTK_QUAD, 4, corners);
  AddVectors(quads, Shear);
  for (vtkDataSet* data : std::initializer_list<vtkDataSet*>{ image, quads })
  {
    Expect(NewFilter(data), "Flow in a plane needs two layers of points", check);
    vtkNew<vtkFlowCriticalPoints> critical;
    critical->SetInputData(data);
    Expect(critical, "Flow in a plane needs two layers of points", check);
    vtkNew<vtkFlowBoundary> boundary;
    boundary->SetInputData(data);
    Expect(boundary, "Flow in a plane needs two layers of points", check);
  }
}

void TestAbort(Check& check)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 9, 9);
  AddVectors(image, Shear);
  auto field = NewFilter(image);
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(field->GetOutputPort());
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(mapping->GetOutputPort());
  volume->SetInterval(0, 0.2, 0.7);
  volume->SetTimeRange(0.5, 2.5);
  vtkNew<vtkFlowLIC> lic;
  lic->SetInputData(image);
  vtkAlgorithm* const filters[] = { field, mapping, volume, lic };
  for (vtkAlgorithm* filter : filters)
  {
    check.SetContext(std::string("abort of ") + filter->GetClassName());
    const auto count = [filter]()
    {
      auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      return output->GetNumberOfPoints();
    };
    filter->Update();
    const vtkIdType whole = count();
    check.That(whole > 0, "the output is not empty");
    ProgressWatch watch;
    ObserveProgress(filter, watch);
    watch.AbortAt = 0.0;
    // Clears the abort flag at the end of the execution, because clearing it later would modify the
    // filter again.
    vtkNew<vtkCallbackCommand> clearAbort;
    clearAbort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(0); });
    filter->AddObserver(vtkCommand::EndEvent, clearAbort);
    filter->Modified();
    filter->Update();
    check.Equal(count(), 0, "no output after an abort");
    watch.AbortAt = 2.0;
    filter->Update();
    check.Equal(count(), whole, "the full output after the flag is cleared");
    filter->RemoveAllObservers();
  }
}

// Arrays copied from samples must have one value per point or cell.
void TestShortArrays(Check& check)
{
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    const bool isOfPoints = association == vtkDataObject::POINT;
    check.SetContext(isOfPoints ? "short point array" : "short cell array");
    const auto image = MakeBlock(0, VTK_DOUBLE);
    vtkNew<vtkDoubleArray> array;
    array->SetName("other");
    array->SetNumberOfTuples(image->GetNumberOfElements(association) - 1);
    array->Fill(0.0);
    image->GetAttributes(association)->AddArray(array);
    auto filter = NewFilter(image);
    Expect(filter,
      isOfPoints ? "array \"other\" has 74 tuples; 75 are needed, one for each point"
                 : "array \"other\" has 31 tuples; 32 are needed, one for each cell",
      check);
    check.Equal(
      vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0, "empty");
    // Samples on a separate image do not use the arrays of the field.
    filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
    check.That(UpdateAndGetErrors(filter).empty(), "samples of an image");
  }
}

}

int TestFlowFieldInput(int, char*[])
{
  return RunChecks({ TestBoundary, TestTypes, TestPlane, TestAbort, TestShortArrays });
}
