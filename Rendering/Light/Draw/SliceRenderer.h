// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SliceRenderer_h
#define interlume_SliceRenderer_h

#include "Common/Error.h"
#include "Draw/ImageSample.h"
#include "Draw/ImageSettings.h"
#include "Plan/SlicePlan.h"
#include "Refinement/ImageRefinement.h"
#include "Refinement/PassTimes.h"
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
 * Multiple volumes share one unit space, the slice plan, the image and one buffer per light. Each
 * volume has its own samples, blocks, transfer functions, textures and programs. Shared settings
 * are documented in vtkShadowedScenePass.h. Volumes are sorted by their bounds, so that the image
 * does not depend on the order in which they are passed.
 */
class SliceRenderer
{
public:
  SliceRenderer();
  ~SliceRenderer();

  using Volumes = std::vector<VolumeResources*>;

  /**
   * Renders \a volumes and sets their results. Their requests must be set. If \a scene is not null,
   * the volumes are part of it. Volumes with errors are skipped. Returns an error if the remaining
   * volumes cannot be rendered together; the last image is then retained.
   */
  Error Draw(vtkRenderer* renderer, const Volumes& volumes, SliceScene* scene);

  /// Returns true if the last image was not final.
  bool IsRefinementPending() const { return this->Refinement.IsPending(); }

  /// Composites the image over the bound framebuffer. Repeated calls after one Draw have no effect.
  /// During a selection, draws the selector's color where the volumes are visible.
  void Show(vtkRenderer* renderer);

  /// Implements vtkShadowedSliceMapper::ReadLightBuffer.
  bool ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  /// Updates the volumes, sorts those without errors and transforms them to one unit space.
  Volumes UpdateVolumes(vtkOpenGLRenderWindow* window, const Volumes& volumes);
  void MoveToSharedSpace(const Volumes& volumes);
  /// Returns the coarseness for the time that the renderer allocates.
  double ChooseCoarseness(const Volumes& volumes) const;
  /// Begins a pass of a progressive image. Returns its time in seconds, as ImageRefinement::Begin.
  double BeginPass(vtkRenderer* renderer, const VolumeResources& volume);
  /// Updates a sample of the volume if the volume's own data are not up to date and would take
  /// longer than \a seconds. Returns the sample, or no volume if the sample is not needed or has an
  /// error.
  Volumes UpdateSample(
    vtkOpenGLRenderWindow* window, const VolumeResources& volume, double seconds);
  /// Updates and draws the volumes or, in the first pass of a progressive image, a sample.
  Error DrawPass(vtkRenderer* renderer, const Volumes& volumes, double seconds, SliceScene* scene);
  /// Draws volumes whose data are updated. \a start is the time at which the image began.
  Error DrawUpdated(vtkRenderer* renderer, const Volumes& volumes, double coarseness,
    SliceScene* scene, double start);
  /// Stores the time of a complete image. \a start and \a updated are the times at which the image
  /// began and its data were updated.
  void AddTimes(double coarseness, double start, double updated);
  /// Updates the camera, lights and image size.
  void UpdateView(vtkRenderer* renderer, const Volumes& volumes, double coarseness,
    SliceScene* scene, SliceReport& report);
  Error UpdateScattering(vtkRenderer* renderer, const Volumes& volumes);
  /// Plans the slices. Returns an error if there are too many slices or they need too much memory.
  Error MakePlan(const Volumes& volumes, double coarseness, SliceReport& report);
  bool HasTooManySlices(
    const std::vector<SlicePlan::SlicedVolume>& volumes, double coarseness) const;
  Error DrawSlices(vtkRenderer* renderer, const Volumes& volumes, SliceReport& report);
  SliceRasterizer* Find(vtkRenderer* renderer) const;

  ImageSettings Settings;
  ImageState Image;
  /// Unit space of the last image.
  UnitSpace Space;
  bool IsShown = false;
  /// If true, the current image is a pass of a progressive image.
  bool IsRefined = false;
  std::map<vtkWindow*, std::unique_ptr<SliceRasterizer>> Windows;
  /// Rendering time of the last image in seconds, and its coarseness.
  double LastSeconds = 0.0;
  double LastCoarseness = 1.0;
  /// Passes of progressive images, and their times after the data were updated.
  ImageRefinement Refinement;
  PassTimes Times;
  /// Sample of the volume, and its resources, which are null without a sample.
  ImageSample Sample;
  std::unique_ptr<VolumeResources> SampleVolume;
  /// Number of voxels along each axis that a voxel of the current image represents.
  int VoxelStride = 1;
};

}

#endif
