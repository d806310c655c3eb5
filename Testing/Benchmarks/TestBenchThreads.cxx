// SPDX-License-Identifier: BSD-3-Clause
// What is timed with one thread has one, and with two two, whatever came before.
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
      const bool isAlone = threads == 1 || std::thread::hardware_concurrency() == 1;
      TimeOnce(WithThreads(threads,
        [&]()
        {
          check.That(reference::HasThreads(isAlone) != isAlone, "that many threads");
          return vtkSmartPointer<vtkObjectBase>();
        }));
    }
  }
  return check.Result();
}
