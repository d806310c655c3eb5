// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Checks/ReferenceThreads.h"

#include "Support/Checks/ReferenceExecution.h"
#include "Support/Meshes/ReferenceGrid.h"

#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <atomic> // for counters
#include <chrono> // for time limits
#include <thread> // for hardware_concurrency() and yield()

namespace reference
{

void SetThreads(int threads)
{
  // With TBB, VTK 9.6 raises the number of threads only after Initialize() with the number of
  // processors. VTK 9.5 and earlier ignore a call with the same number as the previous call.
  vtkSMPTools::Initialize();
  vtkSMPTools::Initialize(static_cast<int>(std::thread::hardware_concurrency()));
  vtkSMPTools::Initialize(threads);
}

bool RunsConcurrently(bool isUnlikely)
{
  const std::chrono::milliseconds wait(isUnlikely ? 5 : 20000);
  std::atomic<int> begun(0);
  std::atomic<int> timeouts(0);
  vtkSMPTools::For(0, 2, 1,
    [&](vtkIdType, vtkIdType)
    {
      ++begun;
      const auto end = std::chrono::steady_clock::now() + wait;
      while (begun < 2)
      {
        if (std::chrono::steady_clock::now() > end)
        {
          ++timeouts;
          return;
        }
        std::this_thread::yield();
      }
    });
  return timeouts == 0;
}

const std::vector<const char*>& GetBackends()
{
#ifdef __SANITIZE_THREAD__
  static const std::vector<const char*> backends = { "Sequential", "STDThread" };
#else
  static const std::vector<const char*> backends = { "Sequential", "STDThread", "TBB", "OpenMP" };
#endif
  return backends;
}

void CheckThreads(const std::string& name,
  const std::function<std::vector<vtkSmartPointer<vtkUnstructuredGrid>>()>& run, Check& check)
{
  vtkSMPTools::SetBackend("Sequential");
  SetThreads(1);
  const auto expected = run();
  for (const auto& grid : expected)
  {
    check.That(grid->GetNumberOfCells() > 0, "the output is not empty");
  }
  const auto compare = [&]()
  {
    const auto found = run();
    for (size_t i = 0; i < expected.size(); ++i)
    {
      const std::string difference = FindDifference(found[i], expected[i]);
      check.That(difference.empty(), difference);
    }
  };
  ForEachThreadCount(name, compare, check);
}

}
