// SPDX-License-Identifier: BSD-3-Clause
// The time-varying Exodus data set: the pipeline delivers each time step, and adjacent intervals
// divide the total volume and duration without gap or overlap.

#include "Support/Inputs/DataFiles.h"
#include "Support/Inputs/ExodusTimeSource.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTetra.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <string>
#include <vector>

namespace
{
using reference::Check;

constexpr double DURATION = 2.0;

/// Returns the volume of hexahedra, each split into six tetrahedra around the diagonal from corner
/// 0 to corner 6.
double Volume(vtkUnstructuredGrid* hexahedra)
{
  const int ring[6] = { 1, 2, 3, 7, 4, 5 };
  double volume = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < hexahedra->GetNumberOfCells(); ++cell)
  {
    hexahedra->GetCellPoints(cell, corners);
    double first[3];
    double last[3];
    hexahedra->GetPoint(corners->GetId(0), first);
    hexahedra->GetPoint(corners->GetId(6), last);
    for (int i = 0; i < 6; ++i)
    {
      double a[3];
      double b[3];
      hexahedra->GetPoint(corners->GetId(ring[i]), a);
      hexahedra->GetPoint(corners->GetId(ring[(i + 1) % 6]), b);
      volume += vtkTetra::ComputeVolume(first, a, b, last);
    }
  }
  return std::abs(volume);
}

void CheckSteps(Check& check, interlume::ExodusTimeSource* mug)
{
  mug->UpdateInformation();
  vtkInformation* information = mug->GetOutputInformation(0);
  const int steps = information->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  if (!check.That(steps == 11, "eleven time steps"))
  {
    return;
  }
  const double* times = information->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  double before = -1.0;
  // Requests the steps backward and then forward. The values of a step must not depend on the step
  // that was read before it.
  std::vector<double> means(11, 0.0);
  for (int i = 2 * steps - 1; i >= 0; --i)
  {
    const int step = i >= steps ? i - steps : steps - 1 - i;
    check.Near(times[step], 0.2 * step, 1e-6, "time of a step");
    mug->UpdateTimeStep(times[step]);
    vtkUnstructuredGrid* grid = mug->GetOutput();
    check.Equal(grid->GetNumberOfPoints(), 3774, "points");
    check.Equal(grid->GetNumberOfCells(), 2476, "cells");
    check.Equal(grid->GetCellData()->GetNumberOfArrays(), 0, "cell arrays");
    check.Near(grid->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), times[step], 0.0,
      "time of the output");
    vtkDataArray* diffused = grid->GetPointData()->GetArray("diffused");
    if (!diffused)
    {
      check.That(false, "the array diffused exists");
      return;
    }
    double mean = 0.0;
    for (vtkIdType point = 0; point < diffused->GetNumberOfTuples(); ++point)
    {
      mean += diffused->GetComponent(point, 0) / 3774.0;
    }
    if (i >= steps)
    {
      means[static_cast<std::size_t>(step)] = mean;
      continue;
    }
    check.Near(mean, means[static_cast<std::size_t>(step)], 0.0,
      "the second read of a step returns the same values");
    check.That(mean > before, "the mean of diffused grows from step to step");
    before = mean;
  }
  check.Near(means[0], 0.0, 0.0, "diffused is 0 at the first step");
  check.Near(
    means[10], 1.110668, 1e-5, "mean at the last step equals the mean of the original file");
}

/// Integrates over space the duration for which \a array is between \a lower and \a upper.
double HyperVolume(
  interlume::ExodusTimeSource* mug, const std::string& array, double lower, double upper)
{
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInputConnection(mug->GetOutputPort());
  interval->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, lower, upper);
  interval->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  interval->Update();
  vtkUnstructuredGrid* tetrahedra =
    vtkUnstructuredGrid::SafeDownCast(interval->GetOutputDataObject(0));
  vtkDataArray* deltaT = tetrahedra->GetPointData()->GetArray("DeltaT");
  double sum = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < tetrahedra->GetNumberOfCells(); ++cell)
  {
    tetrahedra->GetCellPoints(cell, corners);
    double p[4][3];
    double extent = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      tetrahedra->GetPoint(corners->GetId(i), p[i]);
      extent += deltaT->GetComponent(corners->GetId(i), 0);
    }
    sum += 0.25 * extent * vtkTetra::ComputeVolume(p[0], p[1], p[2], p[3]);
  }
  return sum;
}
}

int main()
{
  Check check;
  vtkNew<interlume::ExodusTimeSource> mug;
  mug->SetFileName(interlume::DataFile("mug.ex2"));
  CheckSteps(check, mug);
  mug->Update();
  const double all = DURATION * Volume(mug->GetOutput());
  for (const char* array : { "diffused", "convected" })
  {
    check.SetContext(array);
    const double low = HyperVolume(mug, array, -1.0, 0.3);
    const double mid = HyperVolume(mug, array, 0.3, 0.5);
    const double high = HyperVolume(mug, array, 0.5, 3.0);
    check.That(low > 0.0 && mid > 0.0 && high > 0.0,
      "each interval contains a part of the mug for some time");
    const double total = HyperVolume(mug, array, -1.0, 3.0);
    // Volume() splits nonplanar faces along other diagonals than the filter does.
    check.Near(total, all, 1e-6, "volume of the mug times duration");
    check.Near(low + mid + high, total, 1e-12, "the adjacent intervals sum up to the total");
  }
  return check.Result();
}
