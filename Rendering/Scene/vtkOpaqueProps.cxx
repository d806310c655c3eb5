#include "vtkOpaqueProps.h"

#include "vtkPropCollection.h"
#include "vtkRenderer.h"

bool vtkOpaqueProps::MayOcclude(vtkRenderer* renderer, vtkProp* volume)
{
  // What another renderer left in the depth buffer counts too.
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
