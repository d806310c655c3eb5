// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Checks/ReferenceProgress.h"

#include "Support/Meshes/ReferenceGrid.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridAlgorithm.h"

#include <algorithm>
#include <sstream>

namespace reference
{

namespace
{

void OnProgress(vtkObject* caller, unsigned long, void* client, void* data)
{
  auto* watch = static_cast<ProgressWatch*>(client);
  watch->Progress.push_back(*static_cast<double*>(data));
  if (watch->Progress.back() >= watch->AbortAt || watch->Progress.size() > watch->AbortAfter)
  {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  }
}

}

unsigned long ObserveProgress(vtkAlgorithm* filter, ProgressWatch& watch)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnProgress);
  command->SetClientData(&watch);
  return filter->AddObserver(vtkCommand::ProgressEvent, command);
}

void CheckMonotonicProgress(const ProgressWatch& watch, std::size_t times, Check& check)
{
  const std::vector<double>& progress = watch.Progress;
  check.That(
    progress.size() >= times, "progress is reported at least " + std::to_string(times) + " times");
  check.That(std::is_sorted(progress.begin(), progress.end()), "progress never decreases");
  check.That(!progress.empty() && progress.front() >= 0 && progress.back() <= 1,
    "progress is between 0 and 1");
}

void CheckProgress(
  vtkUnstructuredGridAlgorithm* filter, vtkDataObject* data, int type, Check& check)
{
  filter->SetInputDataObject(data);
  ProgressWatch watch;
  ObserveProgress(filter, watch);
  filter->Update();
  vtkNew<vtkUnstructuredGrid> complete;
  complete->DeepCopy(filter->GetOutput());
  check.That(complete->GetNumberOfCells() > 0, "the output is not empty");
  CheckMonotonicProgress(watch, 3, check);

  for (double at : { 0.0, 0.3, 0.6, 0.9 })
  {
    watch = ProgressWatch();
    watch.AbortAt = at;
    filter->Modified();
    filter->Update();
    check.That(IsValid(filter->GetOutput(), type), "an aborted output is valid");
    const bool isEmpty = filter->GetOutput()->GetNumberOfCells() == 0;
    check.That(isEmpty || FindDifference(filter->GetOutput(), complete).empty(),
      "an aborted output is empty or complete");
    check.That(at > 0 || isEmpty, "the output after an immediate abort is empty");
  }
  watch = ProgressWatch();
  filter->SetAbortExecute(0);
  filter->Modified();
  filter->Update();
  check.That(FindDifference(filter->GetOutput(), complete).empty(),
    "an update after an abort returns the complete output");
}

std::string Print(vtkObject* object)
{
  std::ostringstream text;
  object->Print(text);
  return text.str();
}

void CheckPrinted(const std::string& text, const std::vector<std::string>& expected, Check& check)
{
  for (const std::string& part : expected)
  {
    check.Contains(text, part);
  }
}

}
