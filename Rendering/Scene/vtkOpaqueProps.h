// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkOpaqueProps_h
#define vtkOpaqueProps_h

#include "InterlumeSceneModule.h" // for the export macro

class vtkProp;
class vtkRenderer;

/**
 * @class   vtkOpaqueProps
 * @brief   whether the depth buffer can hold something that occludes a volume
 */
class INTERLUMESCENE_EXPORT vtkOpaqueProps
{
public:
  /**
   * Returns true if \a renderer has a visible prop besides \a volume that is not a volume itself,
   * or keeps the depth of another renderer.
   */
  static bool MayOcclude(vtkRenderer* renderer, vtkProp* volume);
};

#endif
