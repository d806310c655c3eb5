// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceRenderer_h
#define interlume_SliceRenderer_h

#include "Common/Error.h"
#include "Draw/ImageSettings.h"
#include "Plan/SlicePlan.h"
#include "Shaders/ImageState.h"
#include "Space/UnitSpace.h"

#include <map>
#include <memory>
#include <vector>

class vtkImageData;
class vtkLight;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkWindow;

namespace interlume
{

class SliceRasterizer;
class VolumeResources;
struct SliceReport;
struct SliceScene;
struct VolumeRenderState;

/**
 * @class   SliceRenderer
 * @brief   renders one or more volumes in one shared set of slices
 *
 * Several volumes move to one unit space. All share the slice plan, the image and one buffer per
 * light. Each has its own samples, blocks, transfer functions, textures and programs.
 * vtkShadowedScenePass.h documents the shared settings. Volumes are sorted by their bounds, so the
 * image does not depend on the order in which they are given.
 */
class SliceRenderer
{
public:
  SliceRenderer();
  ~SliceRenderer();

  using Volumes = std::vector<VolumeResources*>;

  /**
   * Renders volumes that have requests, as a part of \a scene unless that is null, and sets their
   * results. Volumes with errors are skipped. Returns an error if the others cannot be rendered
   * together; the last image stays then.
   */
  Error Draw(vtkRenderer* renderer, const Volumes& volumes, SliceScene* scene);

  /// Lays the image over the framebuffer that is bound, once after Draw, or shows to the renderer's
  /// selector where it has something.
  void Show(vtkRenderer* renderer);

  /// Implements vtkShadowedSliceMapper::ReadLightBuffer.
  bool ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Updates the volumes, sorts those without errors and moves them to one unit space.
  Volumes UpdateVolumes(vtkOpenGLRenderWindow* window, const Volumes& volumes);
  void ShareSpace(const Volumes& volumes);
  double ChooseCoarseness(const Volumes& volumes) const;
  /// Finds how the volumes are seen and lit.
  void UpdateView(vtkRenderer* renderer, const Volumes& volumes, double coarseness,
    SliceScene* scene, SliceReport& report);
  Error UpdateScattering(vtkRenderer* renderer, const Volumes& volumes);
  /// Plans the slices. Returns an error if they cannot be drawn.
  Error MakePlan(const Volumes& volumes, double coarseness, SliceReport& report);
  bool HasTooManySlices(const std::vector<SlicePlan::Matter>& volumes, double coarseness) const;
  Error DrawSlices(vtkRenderer* renderer, const Volumes& volumes, SliceReport& report);
  SliceRasterizer* Find(vtkRenderer* renderer) const;

  ImageSettings Settings;
  ImageState Image;
  /// The unit space of the last image.
  UnitSpace Space;
  bool IsShown = false;
  std::map<vtkWindow*, std::unique_ptr<SliceRasterizer>> Windows;
  /// The duration of the last image in seconds, and its coarseness.
  double LastSeconds = 0.0;
  double LastCoarseness = 1.0;
};

}

#endif
