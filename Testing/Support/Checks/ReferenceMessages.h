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
std::string UpdateAndGetErrors(vtkAlgorithm* filter);

/// Calls \a act and returns the errors of \a object as a single line.
std::string CaptureErrors(vtkObject* object, const std::function<void()>& act);

/// Removes the source location that VTK puts before a message, and replaces line breaks with
/// spaces.
std::string ToSingleLine(const std::string& message);

/// Updates a filter and returns its warnings.
std::string WarningsOf(vtkAlgorithm* filter);

/**
 * Updates a filter whose output on port 0 is a mesh. The filter must warn if and only if the mesh
 * has no cells. If a warning is missing or unexpected, prints a line in the format of VTK's logger,
 * which fails the test.
 */
void UpdateAndCheckWarnings(vtkAlgorithm* filter);

/// Suppresses the warnings of a filter whose output may be empty on purpose.
void AllowWarnings(vtkAlgorithm* filter);

}

#endif
