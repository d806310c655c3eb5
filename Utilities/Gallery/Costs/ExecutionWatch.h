// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExecutionWatch_h
#define ExecutionWatch_h

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <map>
#include <string>
#include <vector>

namespace gallery
{
/// What the executions of a class made, and how long they took.
struct ExecutionCosts
{
  int Executions = 0;
  /// Point, cell and field arrays of all outputs, and the bytes of these.
  int Arrays = 0;
  vtkIdType Bytes = 0;
  double Seconds = 0.0;

  /// Adds what is in the outputs of an algorithm.
  void AddOutputs(vtkAlgorithm* algorithm);
};

/**
 * @class   ExecutionWatch
 * @brief   counts what every algorithm of VTK's pipeline executes, outside of the algorithms
 *
 * Algorithms that are made while one of these lives have executives that note each execution. So a
 * class that is not in GetClasses() has done nothing: no array, no byte, no time. There is one
 * watch at a time; algorithms may live longer.
 */
class ExecutionWatch
{
public:
  ExecutionWatch();
  ~ExecutionWatch();
  ExecutionWatch(const ExecutionWatch&) = delete;
  void operator=(const ExecutionWatch&) = delete;

  /// Returns what each class has executed since this was made.
  const std::map<std::string, ExecutionCosts>& GetClasses() const { return this->Classes; }
  /// Returns the algorithms that have executed, each once, in the order of their first execution.
  const std::vector<vtkSmartPointer<vtkAlgorithm>>& GetAlgorithms() const
  {
    return this->Algorithms;
  }

  /// For the executives.
  static void Note(vtkAlgorithm* algorithm, double seconds);

private:
  std::map<std::string, ExecutionCosts> Classes;
  std::vector<vtkSmartPointer<vtkAlgorithm>> Algorithms;
};
}

#endif
