// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowSlices_h
#define interlume_FlowSlices_h

#include "Common/Error.h"

#include "vtkNew.h"
#include "vtkType.h"

class vtkImageData;
class vtkRenderer;
class vtkShadowedSliceMapper;
class vtkVolume;
class vtkWindow;

namespace interlume
{

class FlowTextures;
struct FlowPicture;
struct FlowScene;

/**
 * @class   FlowSlices
 * @brief   draws an implicit flow field in slices, with the shadows that its paint casts
 *
 * The medium of a vtkShadowedSliceMapper is what is painted; its scalars are 1 at voxels that
 * reached a surface and 0 elsewhere.
 */
class FlowSlices
{
public:
  FlowSlices();
  ~FlowSlices();

  /// Returns whether a light of the renderer casts shadows: it is switched on and has a
  /// ShadowAttenuation above 0.
  static bool IsAsked(vtkRenderer* renderer);

  /// Draws an image, whose textures have been sent. Returns the errors and warnings that the mapper
  /// of slices reports.
  Error Draw(FlowPicture& picture, const FlowScene& scene, FlowTextures& textures);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  class Medium;

  void MakeReached(const FlowPicture& picture, const FlowScene& scene);
  void Set(const FlowPicture& picture, const FlowScene& scene);

  vtkNew<vtkImageData> Reached;
  vtkMTimeType ReachedVersion = 0;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkShadowedSliceMapper> Mapper;
  vtkNew<Medium> Painted;
};

}

#endif
