// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkDrawingPass_h
#define vtkDrawingPass_h

class vtkCameraPass;
class vtkIceTCompositePass;
class vtkRenderPass;
class vtkRenderer;

/**
 * @class   vtkDrawingPass
 * @brief   gets and replaces the render pass that draws props in a ParaView renderer
 *
 * ParaView nests this pass in image-processing, camera and compositing passes. It recreates all
 * passes when a setting of the view changes. Therefore, construct a new vtkDrawingPass for each
 * rendering.
 */
class vtkDrawingPass
{
public:
  explicit vtkDrawingPass(vtkRenderer* renderer);

  /// Returns the pass, or null if the renderer has no camera pass.
  vtkRenderPass* Get();
  /// Replaces the pass. Call it only if Get returned a pass.
  void Set(vtkRenderPass* pass);

  /**
   * Makes every process render, even if it has no visible data. Use it if the processes exchange
   * data while they render.
   */
  void RenderOnAllProcesses();

private:
  vtkCameraPass* Camera = nullptr;
  /// Null if there is no compositing pass, or ParaView was built without IceT.
  vtkIceTCompositePass* Composite = nullptr;
};

#endif
