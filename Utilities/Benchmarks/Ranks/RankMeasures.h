// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankMeasures_h
#define RankMeasures_h

#include <functional>
#include <vector>

class vtkAlgorithm;
class vtkMultiProcessController;

/**
 * Measurements of filters that all processes execute together. Process 0 gets vectors with one
 * number per process; all other processes get empty vectors.
 */
namespace ranks
{
struct Times
{
  /// Wall time of the slowest process: the median of all runs.
  double Seconds = 0.0;
  int Runs = 0;
  /// Median processor time of each process.
  std::vector<double> ProcessorSeconds;
  /// Amount of work in each process, from the \a getWork of MeasureTimes().
  std::vector<double> Work;
};

/// Updates a filter, and then measures the times of \a repeats further executions of this filter
/// alone. \a getWork returns the amount of work in this process.
Times MeasureTimes(vtkMultiProcessController* controller, vtkAlgorithm* filter, int repeats,
  const std::function<double()>& getWork);

/// Returns the peak growth of each process's resident memory, in KiB, during the first execution of
/// a filter and its input. The result is empty if the system does not report resident memory.
std::vector<double> MeasureMemory(vtkMultiProcessController* controller, vtkAlgorithm* filter);
}

#endif
