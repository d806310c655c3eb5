// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzRun_h
#define FuzzRun_h

#include "vtkSmartPointer.h" // for the output window

#include <functional> // for the tested filter
#include <string>     // for bytes and messages

class vtkAlgorithm;
class vtkDataObject;

namespace reference
{
class Check;
}

/**
 * Checks that every execution of a filter must pass.
 */
namespace fuzz
{

/**
 * @class   Messages
 * @brief   collects errors and warnings during its lifetime instead of showing them
 */
class Messages
{
public:
  Messages();
  ~Messages();
  const std::string& GetText() const;

private:
  class Window;
  vtkSmartPointer<Window> Collected;
};

/// Serializes a dataset, which may be composite, with all its arrays.
std::string BytesOf(vtkDataObject* data);

/// Serializes all outputs of a filter.
std::string BytesOf(vtkAlgorithm* filter);

/**
 * Executes a new filter with one thread and another with three threads. The outputs must be
 * identical. Every array must have a tuple per point or cell, and all point ids must be valid. If
 * \a isExplained is true, an output without cells requires an error or a warning. Returns the
 * messages.
 */
std::string CheckRun(const std::function<vtkSmartPointer<vtkAlgorithm>()>& make, bool isExplained,
  reference::Check& check);

}

#endif
