// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDrawingPass.h"

#include "vtkCameraPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkRenderer.h"

#ifdef INTERLUME_PARAVIEW_HAS_ICET
#include "vtkIceTCompositePass.h"
#endif

vtkDrawingPass::vtkDrawingPass(vtkRenderer* renderer)
{
  vtkRenderPass* pass = renderer->GetPass();
  while (auto* processing = vtkImageProcessingPass::SafeDownCast(pass))
  {
    pass = processing->GetDelegatePass();
  }
  this->Camera = vtkCameraPass::SafeDownCast(pass);
#ifdef INTERLUME_PARAVIEW_HAS_ICET
  this->Composite =
    vtkIceTCompositePass::SafeDownCast(this->Camera ? this->Camera->GetDelegatePass() : nullptr);
#endif
}

vtkRenderPass* vtkDrawingPass::Get()
{
#ifdef INTERLUME_PARAVIEW_HAS_ICET
  if (this->Composite)
  {
    return this->Composite->GetRenderPass();
  }
#endif
  return this->Camera ? this->Camera->GetDelegatePass() : nullptr;
}

void vtkDrawingPass::Set(vtkRenderPass* pass)
{
#ifdef INTERLUME_PARAVIEW_HAS_ICET
  if (this->Composite)
  {
    this->Composite->SetRenderPass(pass);
    return;
  }
#endif
  this->Camera->SetDelegatePass(pass);
}

void vtkDrawingPass::RenderOnAllProcesses()
{
#ifdef INTERLUME_PARAVIEW_HAS_ICET
  if (this->Composite)
  {
    this->Composite->SetRenderEmptyImages(true);
  }
#endif
}
