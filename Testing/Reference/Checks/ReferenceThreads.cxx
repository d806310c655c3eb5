// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/Checks/ReferenceThreads.h"

#include "Reference/Checks/ReferenceExecution.h"
#include "Reference/Meshes/ReferenceGrid.h"

#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

namespace reference
{

void SetThreads(int threads)
{
  // VTK 9.6 takes no more threads than it had, unless all of them were asked for in between.
  vtkSMPTools::Initialize();
  vtkSMPTools::Initialize(threads);
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
    check.That(grid->GetNumberOfCells() > 0, "there is output");
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
  ForThreads(name, compare, check);
}

}
