// SPDX-License-Identifier: BSD-3-Clause
// Tests that timed work uses the requested number of threads, regardless of earlier settings.
#include "Benchmarks/Measures/BenchTiming.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"

#include "vtkSMPTools.h"

#include <thread>

int main()
{
  reference::Check check;
  for (const char* backend : reference::GetBackends())
  {
    if (std::string(backend) == "Sequential" || !vtkSMPTools::SetBackend(backend))
    {
      continue;
    }
    for (const int threads : { 1, 1, 2, 2, 1, 2, 1 })
    {
      check.SetContext(backend + std::string(", ") + ThreadsParameter(threads));
      const bool isSingle = threads == 1 || std::thread::hardware_concurrency() == 1;
      TimeOnce(WithThreads(threads,
        [&]()
        {
          check.That(reference::RunsConcurrently(isSingle) != isSingle,
            "the requested number of threads is used");
          return vtkSmartPointer<vtkObjectBase>();
        }));
    }
  }
  return check.Result();
}
