// SPDX-License-Identifier: BSD-3-Clause
#ifndef ExecutionWatch_h
#define ExecutionWatch_h

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace gallery
{
/**
 * @class   ExecutionWatch
 * @brief   records the VTK algorithms that execute
 *
 * Algorithms created during the lifetime of a watch get executives that report each execution to
 * the watch. Only one watch may exist at a time. Algorithms may outlive the watch.
 */
class ExecutionWatch
{
public:
  ExecutionWatch();
  ~ExecutionWatch();
  ExecutionWatch(const ExecutionWatch&) = delete;
  void operator=(const ExecutionWatch&) = delete;

  /// Returns the algorithms that have executed, without duplicates, in the order of their first
  /// execution.
  const std::vector<vtkSmartPointer<vtkAlgorithm>>& GetAlgorithms() const
  {
    return this->Algorithms;
  }

  /// Called by the executives.
  static void RecordExecution(vtkAlgorithm* algorithm);

private:
  std::vector<vtkSmartPointer<vtkAlgorithm>> Algorithms;
};
}

#endif
