// SPDX-License-Identifier: BSD-3-Clause
#include "Gallery/SurfacesPass.h"

#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace gallery
{
vtkStandardNewMacro(SurfacesPass);

void SurfacesPass::Render(const vtkRenderState* state)
{
  vtkProp** const props = state->GetPropArray();
  std::vector<vtkProp*> surfaces;
  std::copy_if(props, props + state->GetPropArrayCount(), std::back_inserter(surfaces),
    [](vtkProp* prop) { return !prop->IsA("vtkVolume"); });
  vtkRenderState part(state->GetRenderer());
  part.SetFrameBuffer(state->GetFrameBuffer());
  part.SetRequiredKeys(state->GetRequiredKeys());
  part.SetPropArrayAndCount(surfaces.data(), static_cast<int>(surfaces.size()));
  this->Delegate->Render(&part);
  this->NumberOfRenderedProps = this->Delegate->GetNumberOfRenderedProps();
}

void SurfacesPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Delegate->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}
}
