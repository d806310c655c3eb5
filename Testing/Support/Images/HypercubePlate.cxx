// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/HypercubePlate.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkImageDataToPointSet.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkProgrammableFilter.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"

namespace reference
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Moves the interior points of the output to their positions at the requested time.
void MoveInteriorPoints(void* data)
{
  auto* filter = static_cast<vtkProgrammableFilter*>(data);
  vtkInformation* info = filter->GetOutputInformation(0);
  const double* range = info->Get(Pipeline::TIME_RANGE());
  const double fraction =
    (info->Get(Pipeline::UPDATE_TIME_STEP()) - range[0]) / (range[1] - range[0]);
  vtkStructuredGrid* plate = filter->GetStructuredGridOutput();
  plate->ShallowCopy(filter->GetStructuredGridInput());
  double bounds[6];
  plate->GetBounds(bounds);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType point = 0; point < plate->GetNumberOfPoints(); ++point)
  {
    double x[3];
    plate->GetPoint(point, x);
    if (bounds[0] < x[0] && x[0] < bounds[1] && bounds[2] < x[1] && x[1] < bounds[3])
    {
      x[0] += 0.4 * fraction;
      x[1] += 0.25 * fraction;
    }
    points->InsertNextPoint(x);
  }
  plate->SetPoints(points);
}

}

vtkSmartPointer<vtkAlgorithm> MakeHypercubePlate(
  int cells, int steps, double duration, bool isMoving)
{
  vtkNew<vtkAnalyticFieldSource> constant;
  constant->SetFieldToLinear();
  constant->SetGradient(0.0, 0.0, 0.0);
  constant->SetRate(0.0);
  constant->SetDimensions(cells + 1, cells + 1, 2);
  constant->SetBounds(-0.5 * cells, 0.5 * cells, -0.5 * cells, 0.5 * cells, 0.0, 1.0);
  constant->SetTimeRange(0.0, duration);
  constant->SetNumberOfTimeSteps(steps);
  auto grid = vtkSmartPointer<vtkImageDataToPointSet>::New();
  grid->SetInputConnection(constant->GetOutputPort());
  if (!isMoving)
  {
    return grid;
  }
  auto plate = vtkSmartPointer<vtkProgrammableFilter>::New();
  plate->SetInputConnection(grid->GetOutputPort());
  plate->SetExecuteMethod(&MoveInteriorPoints, plate);
  return plate;
}

}
