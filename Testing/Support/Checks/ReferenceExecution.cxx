// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Checks/ReferenceExecution.h"

#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"

#include "vtkAlgorithm.h"
#include "vtkDataSet.h"

#include <thread> // for hardware_concurrency()

namespace reference
{

namespace
{

vtkDataSet* GetOutput(vtkAlgorithm* filter)
{
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

}

void ForEachThreadCount(const std::string& name, const std::function<void()>& run, Check& check)
{
  int backends = 0;
  for (const char* backend : GetBackends())
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      continue;
    }
    ++backends;
    for (const int threads : { 1, 2, 8 })
    {
      check.SetContext(name + ", " + backend + ", " + std::to_string(threads) + " threads");
      SetThreads(threads);
      const bool isSerial = threads == 1 || std::string(backend) == "Sequential" ||
        std::thread::hardware_concurrency() == 1;
      check.That(RunsConcurrently(isSerial) != isSerial,
        isSerial ? "a single thread runs" : "several threads run");
      run();
    }
  }
  check.That(backends >= 2, "at least one backend besides Sequential is available");
}

void CheckAborts(vtkAlgorithm* filter, std::size_t events, const std::vector<double>& times,
  const std::function<std::string()>& update, Check& check)
{
  ProgressWatch watch;
  const unsigned long observer = ObserveProgress(filter, watch);
  filter->Modified();
  const std::string expected = update();
  check.That(
    !expected.empty() && GetOutput(filter)->GetNumberOfPoints() > 0, "the output is not empty");
  CheckMonotonicProgress(watch, events, check);
  for (const double at : times)
  {
    watch = ProgressWatch();
    watch.AbortAt = at;
    filter->Modified();
    update();
    check.Equal(GetOutput(filter)->GetNumberOfPoints(), 0, "points after an abort");
    check.Equal(GetOutput(filter)->GetNumberOfCells(), 0, "cells after an abort");
    watch = ProgressWatch();
    filter->SetAbortExecute(0);
    filter->Modified();
    check.That(update() == expected, "an update after an abort returns the complete output");
  }
  filter->RemoveObserver(observer);
}

void CheckError(vtkAlgorithm* filter, const std::string& message, Check& check)
{
  const std::string found = UpdateAndGetErrors(filter);
  check.Contains(found, message);
  vtkDataSet* output = GetOutput(filter);
  check.That(!output || output->GetNumberOfPoints() == 0, "the output is empty after: " + message);
}

}
