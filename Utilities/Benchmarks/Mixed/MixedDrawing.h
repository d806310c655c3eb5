// SPDX-License-Identifier: BSD-3-Clause
#ifndef MixedDrawing_h
#define MixedDrawing_h

#include "Benchmarks/Measures/BenchTiming.h"
#include "Support/Pictures/MixedScene.h"
#include "Support/Pictures/RgbaPicture.h"
#include "Support/Pictures/VolumeStage.h"

#include "vtkShadowedScenePass.h"
#include "vtkShadowedSliceMapper.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkCamera;
class vtkLight;
class vtkRenderPass;

/**
 * What the suite `mixed` draws, and how.
 */
namespace mixed
{
enum class Method
{
  /// vtkShadowedScenePass.
  ScenePass,
  /// vtkShadowMapPass, which draws opaque actors alone, under spotlights and parallel light.
  ShadowMaps,
  /// What the renderer does without a pass: volumes have their own shadows, actors none.
  Plain
};

/**
 * A scene in a window of its own. Volumes are drawn by vtkShadowedSliceMapper at full quality.
 */
class Drawing
{
public:
  /// \a resolution is that of depth maps.
  Drawing(const reference::MixedScene& scene, Method method, int resolution = 1024);
  ~Drawing();
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  void SetCamera(vtkCamera* camera) { this->Stage.SetCamera(camera); }
  void SetLights(const std::vector<vtkSmartPointer<vtkLight>>& lights)
  {
    this->Stage.SetLights(lights);
  }

  /// The picture in floating point, by the camera and lights last set; at first the scene's.
  reference::RgbaPicture Capture();

  /// One frame until it is done, with so many threads of vtkSMPTools: the camera has moved on by
  /// half a degree, and where \a areLightsMoved the lights by a fifth of one around z, so that
  /// depth maps have to be drawn anew. The drawing must outlive the work.
  BenchWork GetFrame(int threads, bool areLightsMoved = false);

  /// Null where another method draws, and where there is no volume.
  vtkInterlumeReport* GetReport() const;
  vtkShadowedSliceMapper* GetSlices() const { return this->Slices; }

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
