// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceProgress_h
#define ReferenceProgress_h

#include "Support/Checks/ReferenceCheck.h" // for the result

#include <cstddef> // for event counts
#include <string>  // for printed text
#include <vector>  // for the expected text

class vtkAlgorithm;
class vtkDataObject;
class vtkObject;
class vtkUnstructuredGridAlgorithm;

namespace reference
{

/// Records the progress of a filter and aborts it.
struct ProgressWatch
{
  std::vector<double> Progress;
  /// Aborts the filter at this progress. The default is never reached.
  double AbortAt = 2;
  /// Aborts the filter at the first progress event after this number of events.
  std::size_t AbortAfter = 1000000;
};

/// Adds an observer and returns its tag. \a watch must outlive the observer.
unsigned long ObserveProgress(vtkAlgorithm* filter, ProgressWatch& watch);

/// Checks that there were at least \a times progress events, and that progress never decreased and
/// was between 0 and 1.
void CheckMonotonicProgress(const ProgressWatch& watch, std::size_t times, Check& check);

/// Checks that the progress of \a filter with the input \a data never decreases. After an abort,
/// the output must be empty or complete, with cells of \a type. An update after the abort must
/// return the complete output.
void CheckProgress(
  vtkUnstructuredGridAlgorithm* filter, vtkDataObject* data, int type, Check& check);

/// Returns the output of vtkObject::Print().
std::string Print(vtkObject* object);

/// Checks that \a text contains each string of \a expected.
void CheckPrinted(const std::string& text, const std::vector<std::string>& expected, Check& check);

}

#endif
