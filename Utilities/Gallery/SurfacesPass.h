// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfacesPass_h
#define SurfacesPass_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

namespace gallery
{
/**
 * Passes all props except volumes to another render pass. Newer versions of vtkSSAOPass process
 * volumes, and report an error for volumes without shading.
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
