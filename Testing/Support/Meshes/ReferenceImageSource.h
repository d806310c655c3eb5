// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceImageSource_h
#define ReferenceImageSource_h

#include "Support/Checks/ReferenceCheck.h" // for the result

#include <string> // for bytes

class vtkImageAlgorithm;
class vtkImageData;

namespace reference
{

/// The bytes of the active point scalars, or vectors without them; none without both.
std::string GetBytes(vtkImageData* image);

/// Parts of the output have the bytes that they have in the whole; the bytes are the same for 1, 2
/// and 8 threads; progress grows; an abort leaves nothing, and no trace once it is taken back.
void CheckImageSource(vtkImageAlgorithm* source, Check& check);

}

#endif
