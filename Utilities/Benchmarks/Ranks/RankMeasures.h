// SPDX-License-Identifier: BSD-3-Clause
#ifndef RankMeasures_h
#define RankMeasures_h

#include <functional>
#include <vector>

class vtkAlgorithm;
class vtkMultiProcessController;

/**
 * Measures of what all processes execute together; the numbers are those of process 0, and the
 * lists have one for each process there and are empty elsewhere.
 */
namespace ranks
{
struct Times
{
  /// Wall time of the slowest process, median of the runs.
  double Seconds = 0.0;
  int Runs = 0;
  /// Of each process, medians of its runs.
  std::vector<double> ProcessorSeconds;
  /// What each did, as getWork tells.
  std::vector<double> Work;
};

/// Times \a repeats executions of a filter whose input is there.
Times MeasureTimes(vtkMultiProcessController* controller, vtkAlgorithm* filter, int repeats,
  const std::function<double()>& getWork);

/// Returns how many KiB resident memory grows at most while a filter and its input are executed for
/// the first time; empty where the system cannot tell.
std::vector<double> MeasureMemory(vtkMultiProcessController* controller, vtkAlgorithm* filter);
}

#endif
