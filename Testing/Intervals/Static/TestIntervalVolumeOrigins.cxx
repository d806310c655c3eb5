// SPDX-License-Identifier: BSD-3-Clause
// What an interval volume says of where its points and cells come from: points on the edges named,
// at the weights told; cells, and boundary triangles, inside the cells named; and no such arrays
// where they are not asked for.
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
  if (!check.That(ends && weights && ends->GetNumberOfComponents() == 2, "there are origins"))
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
  check.That(onEdges > 0 && onEdges < output->GetNumberOfPoints(), "on edges and on points");
}

// The middle of each cell is in the cell that it comes from.
void CheckCells(vtkDataSet* input, vtkUnstructuredGrid* output, Check& check)
{
  vtkDataArray* origins = output->GetCellData()->GetArray("OriginCell");
  if (!check.That(origins && origins->GetNumberOfTuples() == output->GetNumberOfCells(),
        "there are origins of cells"))
  {
    return;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    output->GetCellPoints(cell, ids);
    double middle[3] = { 0.0, 0.0, 0.0 };
    for (vtkIdType c = 0; c < ids->GetNumberOfIds(); ++c)
    {
      double x[3];
      output->GetPoint(ids->GetId(c), x);
      for (int axis = 0; axis < 3; ++axis)
      {
        middle[axis] += x[axis] / static_cast<double>(ids->GetNumberOfIds());
      }
    }
    double bounds[6];
    input->GetCellBounds(static_cast<vtkIdType>(origins->GetComponent(cell, 0)), bounds);
    for (int axis = 0; axis < 3; ++axis)
    {
      check.That(
        middle[axis] >= bounds[2 * axis] - 1e-12 && middle[axis] <= bounds[2 * axis + 1] + 1e-12,
        "a cell is where it comes from");
    }
  }
}

}

int TestIntervalVolumeOrigins(int, char*[])
{
  Check check;
  auto image = MakeImage({ 6, 5, 7 });
  AddRandomField(image, 3);
  for (const LatticeForm& form : FormsOf(image))
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
    const double copied = volume->GetReport()->GetNumber("ArraysCopied");
    const double interpolated = volume->GetReport()->GetNumber("ArraysInterpolated");
    volume->KeepOriginsOn();
    volume->Update();
    CheckPoints(form.Data, volume->GetOutput(), check);
    CheckCells(form.Data, volume->GetOutput(), check);
    CheckCells(form.Data, volume->GetOutput(1), check);
    check.Near(volume->GetReport()->GetNumber("ArraysCopied"), copied, 0.0, "arrays copied");
    check.Near(volume->GetReport()->GetNumber("ArraysInterpolated"), interpolated, 0.0,
      "arrays interpolated");
    volume->AddCriterion("f", 0.3, 0.8);
    volume->Update();
    check.That(volume->GetOutput()->GetNumberOfCells() > 0 &&
        !volume->GetOutput()->GetPointData()->HasArray("OriginPoints"),
      "none with criteria");
  }
  return check.Result();
}
