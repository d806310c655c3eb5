// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceExecution_h
#define ReferenceExecution_h

#include "Support/Checks/ReferenceCheck.h"   // for the result
#include "Support/Checks/ReferenceThreads.h" // for the backends

#include "vtkSMPTools.h"

#include <cstddef>    // for event counts
#include <functional> // for functions
#include <string>     // for output bytes
#include <vector>     // for abort times

class vtkAlgorithm;

/**
 * Checks for all filters: results are independent of the number of threads, progress never
 * decreases, an abort or invalid input leaves the output empty, and invalid input raises an error.
 */
namespace reference
{

/// Calls \a run with 1, 2 and 8 threads of each available vtkSMPTools backend. The context of the
/// checks is \a name, the backend and the number of threads. At least one backend besides
/// Sequential must be available.
void ForEachThreadCount(const std::string& name, const std::function<void()>& run, Check& check);

/// Checks that \a run returns the same value for every backend and number of threads as with one
/// thread.
template <typename Run>
void CheckSame(const std::string& name, const Run& run, Check& check)
{
  vtkSMPTools::SetBackend("Sequential");
  SetThreads(1);
  const auto expected = run();
  ForEachThreadCount(
    name,
    [&]() { check.That(run() == expected, "the result is the same for any number of threads"); },
    check);
}

/// Checks that \a filter reports progress at least \a events times and that progress never
/// decreases. After an abort when progress reaches any of \a times, the output must be a dataset
/// without points or cells. The next update must return the complete output. \a update updates the
/// filter and returns the bytes of its output.
void CheckAborts(vtkAlgorithm* filter, std::size_t events, const std::vector<double>& times,
  const std::function<std::string()>& update, Check& check);

/// Checks that \a filter reports an error that contains \a message, and that its output is null or
/// has no points.
void CheckError(vtkAlgorithm* filter, const std::string& message, Check& check);

}

#endif
