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
 * @brief   collects the algorithms of VTK's pipeline that execute, without their help
 *
 * Algorithms that are made while a watch lives have executives that report each execution to it.
 * There is one watch at a time; algorithms may live longer.
 */
class ExecutionWatch
{
public:
  ExecutionWatch();
  ~ExecutionWatch();
  ExecutionWatch(const ExecutionWatch&) = delete;
  void operator=(const ExecutionWatch&) = delete;

  /// Returns the algorithms that have executed, each once, in the order of their first execution.
  const std::vector<vtkSmartPointer<vtkAlgorithm>>& GetAlgorithms() const
  {
    return this->Algorithms;
  }

  /// For the executives.
  static void Note(vtkAlgorithm* algorithm);

private:
  std::vector<vtkSmartPointer<vtkAlgorithm>> Algorithms;
};
}

#endif
