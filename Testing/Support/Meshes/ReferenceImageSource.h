// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceImageSource_h
#define ReferenceImageSource_h

#include "Support/Checks/ReferenceCheck.h" // for the result

#include <string> // for bytes

class vtkImageAlgorithm;
class vtkImageData;

namespace reference
{

/// Returns the bytes of the active point scalars. Without scalars, returns the bytes of the active
/// vectors, or an empty string if there are none.
std::string GetBytes(vtkImageData* image);

/// Checks that parts of the output are bit-identical to the complete output, that the bytes are the
/// same for 1, 2 and 8 threads, that progress never decreases, that the output is empty after an
/// abort, and that the next update is complete.
void CheckImageSource(vtkImageAlgorithm* source, Check& check);

}

#endif
