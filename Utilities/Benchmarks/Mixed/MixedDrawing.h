// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedDrawing_h
#define MixedDrawing_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Support/Images/MixedScene.h"
#include "Support/Images/RgbaImage.h"
#include "Support/Images/VolumeStage.h"

#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkCamera;
class vtkLight;
class vtkRenderPass;

/**
 * Rendering of the scenes of the suite `mixed`.
 */
namespace mixed
{
enum class Method
{
  /// vtkShadowedScenePass.
  ScenePass,
  /// vtkShadowMapPass, which renders only opaque actors, under spotlights and directional lights.
  ShadowMaps,
  /// vtkRenderStepsPass, which renders like a renderer without a pass: volumes shadow themselves,
  /// and actors cast no shadows.
  Plain
};

/**
 * A scene in its own window. Volumes are rendered by vtkShadowedSliceMapper at full quality.
 */
class Drawing
{
public:
  /// \a resolution is the resolution of the shadow maps.
  Drawing(const reference::MixedScene& scene, Method method, int resolution = 1024);
  ~Drawing();
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  void SetCamera(vtkCamera* camera) { this->Stage.SetCamera(camera); }
  void SetLights(const std::vector<vtkSmartPointer<vtkLight>>& lights)
  {
    this->Stage.SetLights(lights);
  }

  /// Renders with the current camera and lights, which are initially those of the scene, and
  /// returns the floating-point image.
  reference::RgbaImage Capture();

  /// Returns work that renders one frame with \a threads threads of vtkSMPTools, and waits until
  /// the frame is complete. The camera rotates by half a degree per frame. If \a areLightsMoved is
  /// true, the lights rotate by a fifth of a degree around z, so that shadow maps are rendered
  /// again. The drawing must outlive the work.
  BenchWork GetFrame(int threads, bool areLightsMoved = false);

  /// Returns the report of the pass, or null for methods other than ScenePass.
  vtkInterlumeReport* GetReport() const;
  /// Returns the mapper of the first volume, or null if there is no volume.
  vtkShadowedSliceMapper* GetSliceMapper() const { return this->Slices; }

private:
  void MoveLights();

  reference::MixedScene Scene;
  reference::VolumeStage Stage;
  vtkSmartPointer<vtkRenderPass> Pass;
  vtkSmartPointer<vtkShadowedScenePass> ScenePass;
  vtkSmartPointer<vtkShadowedSliceMapper> Slices;
  std::vector<reference::Double3> Positions;
  int Frames = 0;
};
}

#endif
