// SPDX-License-Identifier: BSD-3-Clause
#include "Output/ProcessBalance.h"

#include "Output/ExtractionReport.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace interlume
{

void ProcessBalance::Gather(vtkAlgorithm* filter, ExtractionReport& report)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  vtkInformation* request = filter->GetOutputInformation(0);
  if (!controller || controller->GetNumberOfProcesses() < 2 ||
    request->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) != controller->GetNumberOfProcesses() ||
    request->Get(Pipeline::UPDATE_PIECE_NUMBER()) != controller->GetLocalProcessId())
  {
    return;
  }
  report.CellsPerProcess.resize(static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  controller->AllGather(&report.CellsWithOutput, report.CellsPerProcess.data(), 1);
  vtkDataObject* output = filter->GetOutputDataObject(0);
  if (!output)
  {
    return;
  }
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("CellsOfProcesses");
  cells->SetNumberOfValues(static_cast<vtkIdType>(report.CellsPerProcess.size()));
  std::copy(report.CellsPerProcess.begin(), report.CellsPerProcess.end(), cells->GetPointer(0));
  output->GetFieldData()->AddArray(cells);
  vtkNew<vtkDoubleArray> balance;
  balance->SetName("LoadBalance");
  balance->InsertNextValue(report.GetBalance());
  output->GetFieldData()->AddArray(balance);
}

}
