// SPDX-License-Identifier: BSD-3-Clause
// Implicit flow of a distributed field is aborted in one process: all processes stop without
// results. After the abort flag is cleared, all processes compute complete results.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationSphere.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <string>
#include <vector>

namespace
{

using namespace reference;

/// Returns the advection times of this process's samples, or an empty vector if there is no output.
std::vector<double> GetTimes(vtkImplicitFlowField* filter)
{
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* array = output->GetPointData()->GetArray(vtkFlowStatus::TimeArray());
  std::vector<double> times;
  for (vtkIdType id = 0; array && id < array->GetNumberOfTuples(); ++id)
  {
    times.push_back(array->GetComponent(id, 0));
  }
  return times;
}

void TestAbort(Check& check, vtkMultiProcessController* controller, int aborting, double at)
{
  const int rank = controller->GetLocalProcessId();
  check.SetContext("process " + std::to_string(rank) + ", aborted in " + std::to_string(aborting) +
    " from " + std::to_string(at) + " of the progress");
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::TORNADO);
  source->SetDimensions(25, 25, 25);
  source->SetBounds(-1.5, 1.5, -1.5, 1.5, -1.5, 1.5);
  vtkNew<vtkTerminationSphere> sphere;
  sphere->SetRadius(0.7);
  const auto set = [&](vtkImplicitFlowField* filter)
  {
    filter->SetInputConnection(source->GetOutputPort());
    filter->AddTerminationSurface(sphere);
    filter->UpdateInformation();
  };
  const auto update = [&](vtkImplicitFlowField* filter)
  { filter->UpdatePiece(rank, controller->GetNumberOfProcesses(), 0); };
  vtkNew<vtkImplicitFlowField> complete;
  set(complete);
  update(complete);
  check.That(
    complete->GetReport()->GetText("WholeFieldReason").empty(), "the field is distributed");
  const std::vector<double> expected = GetTimes(complete);
  check.That(!expected.empty(), "there are results");

  vtkNew<vtkImplicitFlowField> filter;
  set(filter);
  ProgressWatch watch;
  watch.AbortAt = rank == aborting ? at : 2.0;
  const unsigned long tag = ObserveProgress(filter, watch);
  update(filter);
  check.Equal(
    static_cast<long long>(GetTimes(filter).size()), 0, "number of results after the abort");
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  update(filter);
  check.That(GetTimes(filter) == expected, "results after the flag is cleared");
}

}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  Check check;
  for (const int aborting : { 0, controller->GetNumberOfProcesses() - 1 })
  {
    for (const double at : { 0.0, 0.3 })
    {
      TestAbort(check, controller, aborting, at);
    }
  }
  const int own = check.Result() == EXIT_SUCCESS ? 0 : 1;
  int failures = own;
  controller->AllReduce(&own, &failures, 1, vtkCommunicator::SUM_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
