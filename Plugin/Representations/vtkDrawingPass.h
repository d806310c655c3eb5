// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkDrawingPass_h
#define vtkDrawingPass_h

class vtkCameraPass;
class vtkIceTCompositePass;
class vtkRenderPass;
class vtkRenderer;

/**
 * @class   vtkDrawingPass
 * @brief   the place of the pass that draws props, in the passes of a renderer of ParaView
 *
 * ParaView makes its passes anew whenever a setting of the view changes, so a place is looked for
 * before each picture.
 */
class vtkDrawingPass
{
public:
  explicit vtkDrawingPass(vtkRenderer* renderer);

  /// Returns null where ParaView has no such place.
  vtkRenderPass* Get();
  void Set(vtkRenderPass* pass);

  /**
   * Has every process draw, also those that have nothing in view: what processes exchange while
   * they draw needs all of them.
   */
  void DrawEverywhere();

private:
  vtkCameraPass* Camera = nullptr;
  /// Null where ParaView is built without IceT.
  vtkIceTCompositePass* Composite = nullptr;
};

#endif
