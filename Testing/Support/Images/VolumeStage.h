// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeStage_h
#define VolumeStage_h

#include "Support/Images/RgbaImage.h" // for images

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

/// Renders the window and returns its 8-bit pixels, with alpha 1.
RgbaImage ReadWindow(vtkRenderWindow* window);

/**
 * @class   VolumeStage
 * @brief   off-screen window with one volume on a black, transparent background
 *
 * Capture() renders to a framebuffer of 32-bit floats, so the output of a mapper is not rounded.
 * Mappers may round internally: vtkUnstructuredGridVolumeRayCastMapper and
 * vtkUnstructuredGridVolumeZSweepMapper compute 8-bit images with an error of 1/510 at best.
 * vtkProjectedTetrahedraMapper blends in a floating-point framebuffer, but interpolates 8-bit
 * colors and samples the opacity from a table.
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
  /// Sets the lights. No default light is created. Headlights and camera lights follow the camera.
  void SetLights(const std::vector<vtkSmartPointer<vtkLight>>& lights);
  /// Sets the camera, including its clipping range.
  void SetCamera(vtkCamera* camera);
  /// Sets the pass that Capture() renders with. The default renders lights, opaque props and
  /// volumes in sequence.
  void SetPass(vtkRenderPass* pass);
  /// Releases the OpenGL objects of a pass that SetPass() replaced.
  void Release(vtkRenderPass* pass);
  vtkRenderer* GetRenderer();
  /// Returns the window, which no other stage uses afterwards, since the caller can change it. The
  /// windows of other stages are used again, since a shader is compiled once for a window.
  vtkRenderWindow* GetWindow();

  /// Renders to the window's framebuffer and waits until the frame is complete.
  void Render();
  /// Renders \a frames frames to a floating-point framebuffer and returns the last one. Some VTK
  /// mappers require two frames: vtkProjectedTetrahedraMapper omits the first thousand cells of its
  /// first frame. After Render(), that mapper draws over its previous frame, so use a separate
  /// stage and mapper for Capture().
  RgbaImage Capture(int frames = 1);
  /// Renders to the window's framebuffer and returns its 8-bit pixels, with alpha 1.
  RgbaImage CaptureBytes();
  /// Renders a frame and returns the OpenGL renderer string.
  std::string GetDevice();

private:
  vtkSmartPointer<vtkRenderWindow> Window;
  /// False once a caller, who can change it, has the window.
  bool CanReuseWindow = true;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkFramebufferPass> Pass;
};

}

#endif
