// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfacesPass_h
#define SurfacesPass_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

namespace gallery
{
/**
 * Lets another pass see the props that are no volumes. vtkSSAOPass knows volumes in newer versions
 * of VTK, and calls those an error that are not shaded.
 */
class SurfacesPass : public vtkRenderPass
{
public:
  static SurfacesPass* New();
  vtkTypeMacro(SurfacesPass, vtkRenderPass);

  void SetDelegatePass(vtkRenderPass* pass) { this->Delegate = pass; }

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

private:
  vtkSmartPointer<vtkRenderPass> Delegate;
};
}

#endif
