// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMessages_h
#define ReferenceMessages_h

#include <functional> // for functions
#include <string>     // for the messages

class vtkAlgorithm;
class vtkObject;

namespace reference
{

/// Updates a filter and returns the errors of the filter and its executive.
std::string MessagesOf(vtkAlgorithm* filter);

/// Calls \a act and returns the errors of \a object on one line.
std::string ErrorsOf(vtkObject* object, const std::function<void()>& act);

/// Removes line breaks and the source location that VTK puts before a message.
std::string InOneLine(const std::string& message);

/// Updates a filter and returns its warnings.
std::string WarningsOf(vtkAlgorithm* filter);

/**
 * Updates a filter whose output is a mesh. The filter must warn of an empty output on port 0. Any
 * other warning is printed in the format of VTK's logger, which fails the test.
 */
void UpdateWatched(vtkAlgorithm* filter);

/// Suppresses the warnings of a filter whose output may be empty on purpose.
void ExpectWarnings(vtkAlgorithm* filter);

}

#endif
