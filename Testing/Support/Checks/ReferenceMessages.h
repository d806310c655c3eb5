// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMessages_h
#define ReferenceMessages_h

#include <functional> // for what is watched
#include <string>     // for the messages

class vtkAlgorithm;
class vtkObject;

namespace reference
{

/// The errors of a filter and its executive while it is updated.
std::string MessagesOf(vtkAlgorithm* filter);

/// The errors that \a act makes \a object give, in one line.
std::string ErrorsOf(vtkObject* object, const std::function<void()>& act);

/// A message without the place in the source that VTK puts before it, and without line ends.
std::string InOneLine(const std::string& message);

/// The warnings of a filter while it is updated.
std::string WarningsOf(vtkAlgorithm* filter);

/**
 * Updates a filter that makes meshes of one dataset. It has to warn of an empty output on port 0,
 * and of that alone: anything else is printed as VTK's logger prints a warning, which fails a test.
 */
void UpdateWatched(vtkAlgorithm* filter);

/// A filter that may give nothing, as this test means it to: it does not warn of that.
void ExpectWarnings(vtkAlgorithm* filter);

}

#endif
