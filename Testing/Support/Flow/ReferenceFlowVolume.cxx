// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Flow/ReferenceFlowVolume.h"

#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceRandom.h"

#include "vtkFieldData.h"
#include "vtkFlowVolume.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkTerminationPlane.h"
#include "vtkTetra.h"
#include "vtkUnstructuredGrid.h"

vtkSmartPointer<vtkTerminationPlane> reference::MakeWidePlane(double position)
{
  auto plane = vtkSmartPointer<vtkTerminationPlane>::New();
  plane->SetOrigin(position, -5, -5);
  plane->SetPoint1(position, 5, -5);
  plane->SetPoint2(position, -5, 5);
  return plane;
}

vtkSmartPointer<vtkUnstructuredGrid> reference::ExtractFlow(vtkDataSet* samples)
{
  vtkNew<vtkFlowVolume> volume;
  AllowWarnings(volume);
  volume->SetInputData(samples);
  volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  volume->Update();
  return volume->GetOutput();
}

vtkSmartPointer<vtkUnstructuredGrid> reference::ExtractUncutFlow(vtkDataSet* samples)
{
  vtkSmartPointer<vtkDataSet> bare = vtk::TakeSmartPointer(samples->NewInstance());
  bare->ShallowCopy(samples);
  bare->GetFieldData()->RemoveArray("BeyondSampleId");
  return ExtractFlow(bare);
}

double reference::MeasureVolumeIn(
  vtkUnstructuredGrid* mesh, const std::function<bool(const double*)>& isInside)
{
  double sum = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    double x[4][3];
    double center[3];
    for (int i = 0; i < 4; ++i)
    {
      mesh->GetPoint(ids->GetId(i), x[i]);
    }
    vtkTetra::TetraCenter(x[0], x[1], x[2], x[3], center);
    sum += isInside(center) ? vtkTetra::ComputeVolume(x[0], x[1], x[2], x[3]) : 0.0;
  }
  return sum;
}

std::vector<std::array<double, 3>> reference::MakeRandomPositions(int boxes, unsigned int seed)
{
  Random random(seed);
  std::vector<std::array<double, 3>> positions;
  for (int i = 0; i < boxes * boxes * boxes; ++i)
  {
    const int box[3] = { i % boxes, i / boxes % boxes, i / boxes / boxes };
    positions.emplace_back();
    for (int axis = 0; axis < 3; ++axis)
    {
      positions.back()[axis] = -1.0 + 2.0 * (box[axis] + random.Get(0.0, 1.0)) / boxes;
    }
  }
  return positions;
}
