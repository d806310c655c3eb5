// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceProgress_h
#define ReferenceProgress_h

#include "Support/Checks/ReferenceCheck.h" // for the result

#include <cstddef> // for numbers of events
#include <string>  // for what is printed
#include <vector>  // for what is expected

class vtkAlgorithm;
class vtkDataObject;
class vtkObject;
class vtkUnstructuredGridAlgorithm;

namespace reference
{

/// The progress that a filter tells, and when to abort it.
struct ProgressWatch
{
  std::vector<double> Progress;
  /// From which progress on.
  double AbortAt = 2;
  /// After how many events.
  std::size_t AbortAfter = 1000000;
};

/// \a watch is kept by the caller for as long as the filter. The observer's tag.
unsigned long Observe(vtkAlgorithm* filter, ProgressWatch& watch);

/// Progress was told at least \a times times, never ran backwards and was between 0 and 1.
void CheckGrowth(const ProgressWatch& watch, std::size_t times, Check& check);

/// Progress of \a filter over \a data is told and never runs backwards; an abort leaves nothing or
/// the whole output, of cells of \a type, and no trace once it is taken back.
void CheckProgress(
  vtkUnstructuredGridAlgorithm* filter, vtkDataObject* data, int type, Check& check);

/// What an object prints of itself.
std::string Print(vtkObject* object);

/// Every one of \a expected is in \a text.
void CheckPrinted(const std::string& text, const std::vector<std::string>& expected, Check& check);

}

#endif
