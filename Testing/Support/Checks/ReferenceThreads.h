// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceThreads_h
#define ReferenceThreads_h

#include "Support/Checks/ReferenceCheck.h" // for the result

#include "vtkSmartPointer.h" // for the outputs

#include <functional> // for what is run
#include <string>     // for its name
#include <vector>     // for the outputs and backends

class vtkUnstructuredGrid;

namespace reference
{

/// The backend in use has \a threads threads from here on, or as many as it can have.
void SetThreads(int threads);

/// Whether two parts of a loop run at the same time, which one thread waits for: a moment where it
/// \a isUnlikely. The estimate of VTK 9.6 stays at the fewest threads that there have been.
bool HasThreads(bool isUnlikely);

/// Names of the backends of vtkSMPTools to compare: not all are there. Those of libraries that are
/// not built with ThreadSanitizer are left out under it, since it does not see their locks.
const std::vector<const char*>& GetBackends();

/// The outputs of \a run are the same bytes for 1, 2 and 8 threads and every backend, and none is
/// empty.
void CheckThreads(const std::string& name,
  const std::function<std::vector<vtkSmartPointer<vtkUnstructuredGrid>>()>& run, Check& check);

}

#endif
