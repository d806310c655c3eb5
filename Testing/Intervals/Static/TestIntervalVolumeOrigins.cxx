// SPDX-License-Identifier: BSD-3-Clause
// Origin arrays of an interval volume: points lie on the given edges at the given weights, and
// cells and boundary triangles lie inside the given cells. The arrays are absent by default.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceLattice.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkIntervalVolume.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{

using namespace reference;

void CheckPoints(vtkDataSet* input, vtkUnstructuredGrid* output, Check& check)
{
  vtkDataArray* ends = output->GetPointData()->GetArray("OriginPoints");
  vtkDataArray* weights = output->GetPointData()->GetArray("OriginWeight");
  if (!check.That(
        ends && weights && ends->GetNumberOfComponents() == 2, "the origin arrays of points exist"))
  {
    return;
  }
  int onEdges = 0;
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const vtkIdType near = static_cast<vtkIdType>(ends->GetComponent(p, 0));
    const vtkIdType far = static_cast<vtkIdType>(ends->GetComponent(p, 1));
    const double weight = weights->GetComponent(p, 0);
    onEdges += near != far;
    check.That(weight >= 0.0 && weight <= 0.5 && (near != far || weight == 0.0), "a weight");
    double x[3];
    double a[3];
    double b[3];
    output->GetPoint(p, x);
    input->GetPoint(near, a);
    input->GetPoint(far, b);
    for (int axis = 0; axis < 3; ++axis)
    {
      check.Near(x[axis], a[axis] + weight * (b[axis] - a[axis]), 1e-12, "a coordinate", 1.0);
    }
  }
  check.That(
    onEdges > 0 && onEdges < output->GetNumberOfPoints(), "points on edges and at input points");
}

// The center of each cell lies in its origin cell.
void CheckCells(vtkDataSet* input, vtkUnstructuredGrid* output, Check& check)
{
  vtkDataArray* origins = output->GetCellData()->GetArray("OriginCell");
  if (!check.That(origins && origins->GetNumberOfTuples() == output->GetNumberOfCells(),
        "the origin arrays of cells exist"))
  {
    return;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    output->GetCellPoints(cell, ids);
    double center[3] = { 0.0, 0.0, 0.0 };
    for (vtkIdType c = 0; c < ids->GetNumberOfIds(); ++c)
    {
      double x[3];
      output->GetPoint(ids->GetId(c), x);
      for (int axis = 0; axis < 3; ++axis)
      {
        center[axis] += x[axis] / static_cast<double>(ids->GetNumberOfIds());
      }
    }
    double bounds[6];
    input->GetCellBounds(static_cast<vtkIdType>(origins->GetComponent(cell, 0)), bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
      check.That(
        center[axis] >= bounds[2 * axis] - 1e-12 && center[axis] <= bounds[2 * axis + 1] + 1e-12,
        "the cell lies in its origin cell");
    }
  }
}

}

int TestIntervalVolumeOrigins(int, char*[])
{
  Check check;
  auto image = MakeImage({ 6, 5, 7 });
  AddRandomField(image, 3);
  for (const DataSetVariant& form : FormsOf(image))
  {
    check.SetContext(form.Name);
    vtkNew<vtkIntervalVolume> volume;
    volume->SetInputDataObject(form.Data);
    volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    volume->GenerateBoundariesOn();
    volume->SetInterval(0, 0.2, 0.4);
    volume->SetInterval(1, 0.4, 0.9);
    volume->Update();
    check.That(!volume->GetOutput()->GetPointData()->HasArray("OriginPoints"), "off by default");
    const vtkIdType copied = volume->GetReport()->GetCount("ArraysCopied");
    const vtkIdType interpolated = volume->GetReport()->GetCount("ArraysInterpolated");
    volume->GenerateOriginArraysOn();
    volume->Update();
    CheckPoints(form.Data, volume->GetOutput(), check);
    CheckCells(form.Data, volume->GetOutput(), check);
    CheckCells(form.Data, volume->GetOutput(1), check);
    check.Equal(volume->GetReport()->GetCount("ArraysCopied"), copied, "arrays copied");
    check.Equal(
      volume->GetReport()->GetCount("ArraysInterpolated"), interpolated, "arrays interpolated");
    volume->AddCriterion("f", 0.3, 0.8);
    volume->Update();
    check.That(volume->GetOutput()->GetNumberOfCells() > 0 &&
        !volume->GetOutput()->GetPointData()->HasArray("OriginPoints"),
      "no origin arrays with criteria");
  }
  return check.Result();
}
