// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeStage_h
#define VolumeStage_h

#include "Support/Pictures/RgbaPicture.h" // for pictures

#include "vtkNew.h"
#include "vtkSmartPointer.h" // for lights

#include <array>
#include <string>
#include <vector>

class vtkAbstractVolumeMapper;
class vtkActor;
class vtkCamera;
class vtkFramebufferPass;
class vtkLight;
class vtkRenderPass;
class vtkRenderer;
class vtkRenderWindow;
class vtkVolume;
class vtkVolumeProperty;

namespace reference
{

/**
 * @class   VolumeStage
 * @brief   a window out of sight with one volume in front of black and transparent nothing
 *
 * Capture() draws into a framebuffer of 32-bit floats, so that what a mapper gives is not rounded.
 * A mapper may have rounded before: vtkUnstructuredGridVolumeRayCastMapper and
 * vtkUnstructuredGridVolumeZSweepMapper make pictures of 8 bits a channel, 1/510 at best;
 * vtkProjectedTetrahedraMapper blends in a float framebuffer of its own, but interpolates colours
 * of 8 bits and takes opacity from a table.
 */
class VolumeStage
{
public:
  explicit VolumeStage(const std::array<int, 2>& size);
  ~VolumeStage();
  VolumeStage(const VolumeStage&) = delete;
  VolumeStage& operator=(const VolumeStage&) = delete;

  void SetVolume(vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property);
  vtkVolume* GetVolume();
  void AddActor(vtkActor* actor);
  /// Exactly these lights, and no other by itself. Headlights and camera lights follow the camera.
  void SetLights(const std::vector<vtkSmartPointer<vtkLight>>& lights);
  /// The camera is used as it is, its clipping range as well.
  void SetCamera(vtkCamera* camera);
  /// Has Capture() draw by this pass, instead of lights, opaque props and volumes one after
  /// another.
  void SetPass(vtkRenderPass* pass);
  vtkRenderer* GetRenderer();
  vtkRenderWindow* GetWindow();

  /// Draws into the window's own framebuffer and waits until it is done.
  void Render();
  /// Draws into a float framebuffer, so many frames, and returns the last. With two of them VTK's
  /// mappers are ready: vtkProjectedTetrahedraMapper leaves the first thousand cells of its first
  /// picture out. It draws over its last picture there where that was one of Render(): give it a
  /// stage and a mapper for Capture() alone.
  RgbaPicture Capture(int frames = 2);
  /// Who draws, as OpenGL names it. Renders once where nothing has been.
  std::string GetDevice();

private:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkFramebufferPass> Pass;
};

}

#endif
