// SPDX-License-Identifier: BSD-3-Clause
// Progress is reported and never decreases, an abort leaves empty outputs, and PrintSelf prints
// every public value.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{

using namespace reference;

void CheckData(vtkDataSet* data, Check& check)
{
  const TimeSteps steps = RepeatGrid(data, { 0, 1, 2, 3, 4 });
  AddRandomTimeField(steps, 2);
  vtkNew<TimeStepSource> source;
  source->SetSteps(steps);
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInputConnection(source->GetOutputPort());
  Apply({ { { 0.2, 0.4 } } }, filter);
  ProgressWatch watch;
  ObserveProgress(filter, watch);
  filter->Update();
  const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
  check.That(cells > 0, "the output is not empty");
  CheckMonotonicProgress(watch, steps.size(), check);
  check.That(std::any_of(watch.Progress.begin(), watch.Progress.end(),
               [](double at) { return at > 0.2 && at < 0.8; }),
    "intermediate progress is reported");
  for (double at : { 0.0, 0.3, 0.6, 0.9 })
  {
    watch = ProgressWatch();
    watch.AbortAt = at;
    source->ClearRequests();
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    for (int port = 0; port < 3; ++port)
    {
      auto* grid = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(port));
      check.Equal(grid->GetNumberOfCells(), 0, "cells when aborted at " + std::to_string(at));
    }
    check.That(at > 0.5 || source->GetRequests().size() < steps.size(),
      "no steps are requested after an abort");
  }
  watch = ProgressWatch();
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  check.Equal(
    filter->GetOutput()->GetNumberOfCells(), cells, "cells after the abort flag is cleared");
}

void CheckPrint(Check& check)
{
  check.SetContext("print");
  vtkNew<vtkTimeVaryingIntervalVolume> filter;
  filter->SetInterval(0, 1.25, 2.5);
  filter->SetInterval(1, 3.125, 4.75);
  filter->SetTimeStepRange(17, 4711);
  filter->SetProjectionDirection(0.375, 0.6875, 5.5, 6.25);
  CheckPrinted(Print(filter),
    { "1.25", "2.5", "3.125", "4.75", "TimeStepRange", "17", "4711", "ProjectionDirection", "0.375",
      "0.6875", "5.5", "6.25", "GenerateTetrahedra", "GenerateSimplices", "GenerateBoundar",
      "OutputPointsPrecision", "TimeSteps", "Slabs", "Simplices", "FlatSimplices",
      "InvertedSimplices", "TableLookups", "TableCasesComputed", "Cells", "CellsVisited",
      "NonFiniteCells", "BlankedCells", "CollapsedSimplices", "WorkingBytes" },
    check);
}

}

int TestTimeVaryingProgress(int, char*[])
{
  Check check;
  check.SetContext("image");
  CheckData(MakeImage({ 12, 12, 12 }), check);
  check.SetContext("mixed cells");
  CheckData(MakeMesh(MeshKind::Mixed, { 7, 7, 7 }), check);
  CheckPrint(check);
  return check.Result();
}
