// SPDX-License-Identifier: BSD-3-Clause
// Critical points in degenerate, blanked and non-finite cells. Also tests threads, progress, abort
// and errors.
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceCriticalPoints.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"

#include "vtkDataSetAttributes.h"
#include "vtkFlowCriticalPoints.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <string>

namespace
{

using namespace reference;

void CheckLeftOut(Check& check)
{
  check.SetContext("skipped cells");
  const auto make = []()
  {
    auto mesh = MakeMesh(MeshKind::Hexahedra, { 3, 4, 2 });
    SetVelocity(mesh, LinearField(GenericMatrix, ZeroPositions[0]));
    return mesh;
  };
  const CriticalPoints whole(make());
  const vtkIdType cell = whole.GetCell(0);
  for (const unsigned char mark : { vtkDataSetAttributes::HIDDENCELL,
         vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::REFINEDCELL })
  {
    auto mesh = make();
    mesh->AllocateCellGhostArray()->SetValue(cell, mark);
    check.Equal(CriticalPoints(mesh).GetNumber(), 0, "in a blanked cell");
    mesh->GetCellGhostArray()->SetValue(cell, 0);
    mesh->GetCellGhostArray()->SetValue(cell + 1, mark);
    mesh->Modified();
    check.Equal(CriticalPoints(mesh).GetNumber(), 1, "next to a blanked cell");
  }
  auto mesh = make();
  vtkIdType corner = mesh->GetCell(cell)->GetPointId(3);
  mesh->AllocatePointGhostArray()->SetValue(corner, vtkDataSetAttributes::HIDDENPOINT);
  check.Equal(CriticalPoints(mesh).GetNumber(), 0, "in a cell with a hidden point");
  auto image = MakeImage({ 3, 3, 3 });
  FlowVector inside;
  image->GetCell(13)->GetPoints()->GetPoint(0, inside.data());
  inside = { { inside[0] + 0.03, inside[1] + 0.1, inside[2] + 0.2 } };
  SetVelocity(image, LinearField(GenericMatrix, inside));
  check.Equal(CriticalPoints(image).GetNumber(), 1, "in an image");
  image->AllocateCellGhostArray()->SetValue(13, vtkDataSetAttributes::HIDDENCELL);
  check.Equal(CriticalPoints(image).GetNumber(), 0, "in a blanked cell of an image");

  for (const DataSetVariant& form : FormsOf(MakeImage({ 3, 3, 3 })))
  {
    check.SetContext("hidden points, " + form.Name);
    SetVelocity(form.Data, LinearField(GenericMatrix, inside));
    check.Equal(CriticalPoints(form.Data).GetNumber(), 1, "critical points");
    form.Data->AllocatePointGhostArray()->SetValue(
      form.Data->GetCell(13)->GetPointId(2), vtkDataSetAttributes::HIDDENPOINT);
    form.Data->Modified();
    vtkNew<vtkFlowCriticalPoints> filter;
    AllowWarnings(filter);
    filter->SetInputDataObject(form.Data);
    check.That(UpdateAndGetErrors(filter).empty(), "no error");
    check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0, "in a cell with a hidden point");
  }
  check.SetContext("skipped cells");
  for (const double value : { std::nan(""), HUGE_VAL })
  {
    mesh = make();
    corner = mesh->GetCell(cell)->GetPointId(0);
    mesh->GetPointData()->GetVectors()->SetComponent(corner, 2, value);
    vtkNew<vtkIdList> cells;
    mesh->GetPointCells(corner, cells);
    const CriticalPoints result(mesh);
    check.Equal(result.GetNumber(), 0, "in a non-finite cell");
    check.Equal(result.Filter->GetReport()->GetCount("NonFiniteCells"), cells->GetNumberOfIds(),
      "number of non-finite cells");
  }
  check.SetContext("an empty cell");
  mesh = make();
  // The zero is in the last cell before an empty cell. It must not be found again in the empty
  // cell, with cached points of the previous cell.
  SetVelocity(mesh, LinearField(GenericMatrix, { { 2.3, 3.4, 1.6 } }));
  mesh->InsertNextCell(VTK_EMPTY_CELL, 0, &corner);
  check.Equal(CriticalPoints(mesh).GetNumber(), 1, "critical points");
  check.SetContext("skipped cells");
  mesh = make();
  SetVelocity(mesh, [](const FlowVector&) { return FlowVector{}; });
  const CriticalPoints zero(mesh);
  check.Equal(zero.GetNumber(), 0, "in a zero field");
  check.Equal(zero.Filter->GetReport()->GetCount("ZeroCells"), 24, "number of zero cells");
  CheckPrinted(Print(const_cast<vtkFlowCriticalPoints*>(zero.Filter.GetPointer())),
    { "ZeroCells: 24", "DegenerateCells: 0", "NonFiniteCells: 0" }, check);
}

vtkSmartPointer<vtkImageData> MakeRandomImage()
{
  Random random(53);
  auto image = MakeImage({ 12, 11, 10 });
  SetVelocity(image, [&random](const FlowVector&) { return random.GetPoint(1.0); });
  return image;
}

void CheckExecution(Check& check)
{
  check.SetContext("execution");
  auto image = MakeRandomImage();
  const auto find = [&]()
  {
    const CriticalPoints result(image);
    check.That(result.GetNumber() > 20, "there are critical points");
    return GetBytes(result.Output);
  };
  CheckSame("execution", find, check);
  vtkNew<vtkFlowCriticalPoints> filter;
  AllowWarnings(filter);
  filter->SetInputData(image);
  const auto update = [&filter]()
  {
    filter->Update();
    return GetBytes(filter->GetOutput());
  };
  CheckAborts(filter, 5, { 0.0, 0.5 }, update, check);
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  auto image = MakeImage({ 2, 2, 2 });
  vtkNew<vtkFlowCriticalPoints> filter;
  AllowWarnings(filter);
  filter->SetInputData(image);
  CheckError(filter, "The field has no active vectors", check);
  SetVelocity(image, LinearField(GenericMatrix, { { 0.0, 0.0, 0.0 } }));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Wind");
  CheckError(filter, "The field has no point or cell array \"Wind\"", check);
  vtkNew<vtkFloatArray> wind;
  wind->SetName("Wind");
  wind->SetNumberOfComponents(2);
  wind->SetNumberOfTuples(27);
  image->GetPointData()->AddArray(wind);
  filter->Modified();
  CheckError(filter, "Array \"Wind\" has 2 components; 3 are needed", check);
  auto plane = MakeImage({ 2, 2, 0 });
  SetVelocity(plane, LinearField(GenericMatrix, { { 0.0, 0.0, 0.0 } }));
  vtkNew<vtkFlowCriticalPoints> other;
  AllowWarnings(other);
  other->SetInputData(plane);
  CheckError(
    other, "The field has no three-dimensional cells. Flow in a plane needs two layers", check);
  auto mesh = MakeMesh(MeshKind::Boxes, { 1, 1, 1 });
  SetVelocity(mesh, LinearField(GenericMatrix, { { 0.0, 0.0, 0.0 } }));
  other->SetInputData(mesh);
  CheckError(other, "Cell 0 is a vtkPolyhedron", check);
  vtkNew<vtkUnstructuredGrid> empty;
  other->SetInputData(empty);
  check.That(UpdateAndGetErrors(other).empty(), "an empty grid is not an error");
}

}

int TestFlowCriticalPointRuns(int, char*[])
{
  return RunChecks({ CheckLeftOut, CheckExecution, CheckErrors });
}
