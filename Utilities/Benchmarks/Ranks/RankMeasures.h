// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankMeasures_h
#define RankMeasures_h

#include <functional>
#include <vector>

class vtkAlgorithm;
class vtkMultiProcessController;

/**
 * Measurements of filters that all processes execute together. Numbers are valid only in process 0.
 * Lists have one entry per process in process 0 and are empty in all other processes.
 */
namespace ranks
{
struct Times
{
  /// Wall time of the slowest process, median of all runs.
  double Seconds = 0.0;
  int Runs = 0;
  /// Median processor time of each process.
  std::vector<double> ProcessorSeconds;
  /// Result of getWork in each process.
  std::vector<double> Work;
};

/// Times \a repeats executions of a filter whose input is up to date.
Times MeasureTimes(vtkMultiProcessController* controller, vtkAlgorithm* filter, int repeats,
  const std::function<double()>& getWork);

/// Returns the largest growth of each process's resident memory, in KiB, during the first execution
/// of a filter and its input. Empty if the system does not report resident memory.
std::vector<double> MeasureMemory(vtkMultiProcessController* controller, vtkAlgorithm* filter);
}

#endif
