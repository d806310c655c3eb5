// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkProgressiveVolumes_h
#define vtkProgressiveVolumes_h

#include "InterlumeRepresentationsModule.h" // for the export macro

class vtkRenderer;

/**
 * @class   vtkProgressiveVolumes
 * @brief   controls the progressive images of all of Interlume's volumes in a renderer
 */
namespace vtkProgressiveVolumes
{
/// Turns progressive rendering of all volumes on or off.
INTERLUMEREPRESENTATIONS_EXPORT void Set(vtkRenderer* renderer, bool isProgressive);
/// Restarts images that are not final, so that the next rendering is as fast as the first one.
INTERLUMEREPRESENTATIONS_EXPORT void Restart(vtkRenderer* renderer);
/// Returns true if the last image of a visible volume was not final.
INTERLUMEREPRESENTATIONS_EXPORT bool IsPending(vtkRenderer* renderer);
}

#endif
