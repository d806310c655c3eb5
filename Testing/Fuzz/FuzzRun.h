// SPDX-License-Identifier: BSD-3-Clause
#ifndef FuzzRun_h
#define FuzzRun_h

#include "vtkSmartPointer.h" // for the output window

#include <functional> // for what is run
#include <string>     // for bytes and messages

class vtkAlgorithm;
class vtkDataObject;

namespace reference
{
class Check;
}

/**
 * What is expected of any execution, whatever comes in.
 */
namespace fuzz
{

/**
 * @class   Messages
 * @brief   collects errors and warnings, instead of showing them, for as long as it lives
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

/// The bytes of a dataset, composite or not, with all of its arrays.
std::string BytesOf(vtkDataObject* data);

/// The bytes of all outputs of a filter.
std::string BytesOf(vtkAlgorithm* filter);

/**
 * Updates a filter with one and with three threads, each from the start. The outputs are the same
 * bytes; every array has a value for each point, or cell; ids of cells are those of points; an
 * output without cells, where \a isExplained, comes with an error or a warning. Returns the
 * messages.
 */
std::string CheckRun(const std::function<vtkSmartPointer<vtkAlgorithm>()>& make, bool isExplained,
  reference::Check& check);

}

#endif
