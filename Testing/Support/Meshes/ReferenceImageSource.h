// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceImageSource_h
#define ReferenceImageSource_h

#include "Support/Checks/ReferenceCheck.h" // for the result

#include <functional> // for what fails
#include <string>     // for bytes and messages

class vtkImageAlgorithm;
class vtkImageData;
class vtkObject;

namespace reference
{

/// The bytes of the active point scalars, or vectors without them; none without both.
std::string GetBytes(vtkImageData* image);

/// Parts of the output have the bytes that they have in the whole; the bytes are the same for 1, 2
/// and 8 threads; progress grows; an abort leaves nothing, and no trace once it is taken back.
void CheckImageSource(vtkImageAlgorithm* source, Check& check);

/// The errors that an object tells while \a act runs.
std::string ErrorsOf(vtkObject* object, const std::function<void()>& act);

}

#endif
