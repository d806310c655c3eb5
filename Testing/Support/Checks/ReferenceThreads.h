// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceThreads_h
#define ReferenceThreads_h

#include "Support/Checks/ReferenceCheck.h" // for the result

#include "vtkSmartPointer.h" // for the outputs

#include <functional> // for functions
#include <string>     // for names
#include <vector>     // for the outputs and backends

class vtkUnstructuredGrid;

namespace reference
{

/// Sets the number of threads of the current backend, as far as the backend allows.
void SetThreads(int threads);

/// Returns whether two iterations of a loop run concurrently. Each iteration waits for the other,
/// but only for a few milliseconds if \a isUnlikely. vtkSMPTools::GetEstimatedNumberOfThreads()
/// cannot be used: in VTK 9.6 it returns the lowest number of threads that was ever set.
bool RunsConcurrently(bool isUnlikely);

/// Returns the names of the vtkSMPTools backends to compare. Some may be unavailable. With
/// ThreadSanitizer, backends whose libraries are not instrumented are excluded, since
/// ThreadSanitizer does not see their locks.
const std::vector<const char*>& GetBackends();

/// Checks that the outputs of \a run are bit-identical for 1, 2 and 8 threads of every vtkSMPTools
/// backend, and not empty.
void CheckThreads(const std::string& name,
  const std::function<std::vector<vtkSmartPointer<vtkUnstructuredGrid>>()>& run, Check& check);

}

#endif
