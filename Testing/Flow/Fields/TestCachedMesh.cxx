// SPDX-License-Identifier: BSD-3-Clause
// The face connectivity of a mesh is cached between executions: when it is reused, when it is not,
// and whether results are bit-identical to results without the cache.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFlowLIC.h"
#include "vtkIdList.h"
#include "vtkImplicitFlowField.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <string>

namespace
{

using namespace reference;

vtkSmartPointer<vtkImplicitFlowField> NewFilter(vtkUnstructuredGrid* mesh)
{
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputData(mesh);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(5, 6, 4);
  filter->DomainFacesOn();
  return filter;
}

/// Returns the point arrays of the samples as bytes.
std::string GetBytes(vtkImplicitFlowField* filter)
{
  std::string bytes;
  vtkPointData* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    bytes += array->GetName();
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
  }
  return bytes;
}

/// Executes the filter again and compares the results with those for a copy of the mesh, which is
/// not cached.
void CheckAgain(vtkImplicitFlowField* filter, vtkUnstructuredGrid* mesh, bool isCached,
  const std::string& what, Check& check)
{
  filter->Modified();
  filter->Update();
  const vtkIdType reused = filter->GetReport()->GetNumber("ReusedFaceMatches");
  check.That(isCached ? reused > 0 && reused % mesh->GetNumberOfCells() == 0 : reused == 0,
    what + ": " + std::to_string(reused) + " cached faces used");
  vtkNew<vtkUnstructuredGrid> copy;
  copy->DeepCopy(mesh);
  const auto fresh = NewFilter(copy);
  fresh->Update();
  check.Equal(
    fresh->GetReport()->GetCount("ReusedFaceMatches"), 0, what + ": cached faces used for a copy");
  check.That(GetBytes(fresh) == GetBytes(filter), what + ": the samples");
  check.Equal(filter->GetReport()->GetCount("NonconformingFaces"),
    fresh->GetReport()->GetCount("NonconformingFaces"), what);
  check.Equal(filter->GetReport()->GetCount("ToleranceMatchedFaces"),
    fresh->GetReport()->GetCount("ToleranceMatchedFaces"), what);
}

vtkSmartPointer<vtkUnstructuredGrid> MakeSwirl(MeshKind kind)
{
  auto mesh = MakeFlowMesh(kind, { { 4, 4, 4 } });
  AddVectors(mesh,
    [](const Vector& x) {
      return Vector{ { 1.5 - x[1] + 0.1 * std::sin(3.0 * x[2]), x[0] - 2.3, 0.7 } };
    });
  return mesh;
}

void TestChanges(MeshKind kind, Check& check)
{
  const auto mesh = MakeSwirl(kind);
  const auto filter = NewFilter(mesh);
  CheckAgain(filter, mesh, false, "first", check);
  CheckAgain(filter, mesh, true, "again", check);
  filter->SetMaximumTime(1.0);
  filter->Update();
  check.That(filter->GetReport()->GetNumber("ReusedFaceMatches") > 0, "another maximum time");
  filter->SetMaximumTime(0.0);
  AddVectors(mesh, [](const Vector& x) { return Vector{ { 1.0, 0.2 * x[0], -0.3 } }; });
  CheckAgain(filter, mesh, true, "other vectors", check);
  {
    const auto second = NewFilter(mesh);
    CheckAgain(second, mesh, true, "another filter", check);
  }
  vtkNew<vtkPoints> points;
  points->DeepCopy(mesh->GetPoints());
  mesh->SetPoints(points);
  CheckAgain(filter, mesh, false, "other points", check);
  double x[3];
  points->GetPoint(62, x);
  points->SetPoint(62, x[0] + 0.2, x[1] - 0.1, x[2] + 0.1);
  points->Modified();
  CheckAgain(filter, mesh, false, "a moved point", check);
  CheckAgain(filter, mesh, true, "the point is unchanged", check);
  mesh->Modified();
  CheckAgain(filter, mesh, false, "a mesh marked as modified", check);
  mesh->AllocateCellGhostArray()->SetValue(5, vtkDataSetAttributes::HIDDENCELL);
  CheckAgain(filter, mesh, false, "a hidden cell", check);
  mesh->GetCellGhostArray()->SetValue(6, vtkDataSetAttributes::HIDDENCELL);
  mesh->GetCellGhostArray()->Modified();
  CheckAgain(filter, mesh, false, "another hidden cell", check);
  // Swaps two cells with equal numbers of points.
  vtkNew<vtkIdList> first;
  vtkNew<vtkIdList> other;
  mesh->GetCellPoints(0, first);
  mesh->GetCellPoints(1, other);
  if (first->GetNumberOfIds() == other->GetNumberOfIds())
  {
    mesh->GetCells()->ReplaceCellAtId(0, other);
    mesh->GetCells()->ReplaceCellAtId(1, first);
    mesh->GetCells()->Modified();
    CheckAgain(filter, mesh, false, "cells in another order", check);
  }
}

/// The cache of a mesh is released with the last filter that uses it, which may be a vtkFlowLIC.
void TestOwners(Check& check)
{
  const auto mesh = MakeSwirl(FlowMeshKinds().front());
  NewFilter(mesh)->Update();
  auto filter = NewFilter(mesh);
  CheckAgain(filter, mesh, false, "after the first filter is deleted", check);
  filter = nullptr;
  vtkNew<vtkFlowLIC> lic;
  lic->SetInputData(mesh);
  lic->Update();
  filter = NewFilter(mesh);
  CheckAgain(filter, mesh, true, "after LIC", check);
  lic->SetInputData(MakeSwirl(FlowMeshKinds().front()));
  lic->Update();
  filter = nullptr;
  filter = NewFilter(mesh);
  CheckAgain(filter, mesh, false, "after all filters use another mesh", check);
}

}

int TestCachedMesh(int, char*[])
{
  Check check;
  for (const MeshKind kind : FlowMeshKinds())
  {
    check.SetContext("kind " + std::to_string(static_cast<int>(kind)));
    TestChanges(kind, check);
  }
  check.SetContext("");
  TestOwners(check);
  return check.Result();
}
