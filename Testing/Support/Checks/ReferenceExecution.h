// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceExecution_h
#define ReferenceExecution_h

#include "Support/Checks/ReferenceCheck.h"   // for the result
#include "Support/Checks/ReferenceThreads.h" // for the backends

#include "vtkSMPTools.h"

#include <cstddef>    // for numbers of events
#include <functional> // for what is run
#include <string>     // for bytes
#include <vector>     // for times of aborts

class vtkAlgorithm;

/**
 * What every execution has to do, whatever it makes: the same for any number of threads, progress
 * that grows, nothing after an abort, an error and nothing for bad input.
 */
namespace reference
{

/// Calls \a run with 1, 2 and 8 threads of every backend, in a context that tells of them after \a
/// name. There is one that has threads.
void ForThreads(const std::string& name, const std::function<void()>& run, Check& check);

/// \a run gives the same for any number of threads as without any.
template <typename Run>
void CheckSame(const std::string& name, const Run& run, Check& check)
{
  vtkSMPTools::SetBackend("Sequential");
  SetThreads(1);
  const auto expected = run();
  ForThreads(
    name, [&]() { check.That(run() == expected, "the same for any number of threads"); }, check);
}

/// Progress of \a filter is told at least \a events times and grows. An abort at any of \a times,
/// parts of the work, leaves a dataset without points and cells, and no trace once it is taken
/// back: \a update brings the filter up to date and gives the bytes of its output.
void CheckAborts(vtkAlgorithm* filter, std::size_t events, const std::vector<double>& times,
  const std::function<std::string()>& update, Check& check);

/// \a filter tells of an error with \a message in it, and its output is a dataset without points.
void CheckError(vtkAlgorithm* filter, const std::string& message, Check& check);

}

#endif
