// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpaqueProps.h"

#include "vtkPropCollection.h"
#include "vtkRenderer.h"

bool vtkOpaqueProps::MayOcclude(vtkRenderer* renderer, vtkProp* volume)
{
  // The depths that another renderer left in the depth buffer count too.
  if (renderer->GetPreserveDepthBuffer())
  {
    return true;
  }
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (prop != volume && prop->GetVisibility() && !prop->IsA("vtkVolume"))
    {
      return true;
    }
  }
  return false;
}
