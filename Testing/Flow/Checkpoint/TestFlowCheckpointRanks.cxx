// SPDX-License-Identifier: BSD-3-Clause
// A distributed field under MPI, stopped in one process and resumed in all: the result is
// bit-identical to an uninterrupted run.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceProgress.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <filesystem>
#include <string>

namespace
{

using namespace reference;

/// Returns the results of this process's samples as bytes.
std::string GetBytes(vtkImplicitFlowField* filter)
{
  std::string bytes;
  vtkPointData* data = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetPointData();
  for (const char* name : { vtkFlowStatus::StatusArray(), vtkFlowStatus::IdArray(),
         vtkFlowStatus::ParametersArray(), vtkFlowStatus::TimeArray() })
  {
    if (vtkDataArray* array = data->GetArray(name))
    {
      bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetNumberOfValues()) * array->GetDataTypeSize());
    }
  }
  return bytes;
}

void Update(vtkImplicitFlowField* filter, vtkMultiProcessController* controller)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::ABC);
  source->SetDimensions(25, 23, 20);
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  filter->SetMaximumError(1e-3);
  filter->DomainFacesOn();
  filter->UpdateInformation();
  filter->UpdatePiece(controller->GetLocalProcessId(), controller->GetNumberOfProcesses(), 0);
}

void TestRanks(Check& check, vtkMultiProcessController* controller)
{
  const int rank = controller->GetLocalProcessId();
  check.SetContext("process " + std::to_string(rank));
  vtkNew<vtkImplicitFlowField> filter;
  Update(filter, controller);
  const std::string whole = GetBytes(filter);
  check.That(filter->GetReport()->GetText("WholeFieldReason").empty(), "the field is distributed");

  const std::string name =
    (std::filesystem::temp_directory_path() / "TestFlowCheckpointRanks.vtt").string();
  const std::string own = name.substr(0, name.size() - 4) + "_" + std::to_string(rank) + ".vtt";
  std::filesystem::remove(own);
  controller->Barrier();
  vtkNew<vtkImplicitFlowField> stopped;
  stopped->SetCheckpointFileName(name.c_str());
  ProgressWatch watch;
  // Only process 1 aborts. The progress of the others never reaches 2.
  watch.AbortAt = rank == 1 ? 0.7 : 2.0;
  ObserveProgress(stopped, watch);
  Update(stopped, controller);
  check.That(GetBytes(stopped).empty(), "no output after an abort in one process");
  check.That(std::filesystem::exists(own), "one file per process");

  vtkNew<vtkImplicitFlowField> resumed;
  resumed->SetCheckpointFileName(name.c_str());
  Update(resumed, controller);
  check.That(GetBytes(resumed) == whole, "the result is bit-identical to an uninterrupted run");
  check.That(resumed->GetReport()->GetNumber("ResumedStreamlines") > 0, "streamlines resumed");
  check.That(!std::filesystem::exists(own), "the file is removed on completion");
}

}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  Check check;
  TestRanks(check, controller);
  int failures = check.Result();
  int all = failures;
  controller->AllReduce(&failures, &all, 1, vtkCommunicator::MAX_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return all;
}
