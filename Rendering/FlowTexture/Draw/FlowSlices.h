// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_FlowSlices_h
#define interlume_FlowSlices_h

#include "Common/Error.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <tuple>

class vtkImageData;
class vtkRenderer;
class vtkShadowedSliceMapper;
class vtkVolume;
class vtkWindow;

namespace interlume
{

class FlowTextures;
struct FlowRenderFrame;
struct FlowRenderState;

/**
 * @class   FlowSlices
 * @brief   draws an implicit flow field in slices, with shadows
 *
 * A vtkShadowedSliceMapper draws the textured flow as its medium. The scalars of the mapper's input
 * are 1 at voxels whose streamline reached a surface, otherwise 0.
 */
class FlowSlices
{
public:
  FlowSlices();
  ~FlowSlices();

  /// Returns true if a light of the renderer is switched on and has ShadowAttenuation above 0.
  static bool HasShadowLight(vtkRenderer* renderer);

  /// Draws a frame. The textures must already be uploaded. Returns the errors and warnings of the
  /// slice mapper.
  Error Draw(FlowRenderFrame& pass, const FlowRenderState& scene, FlowTextures& textures);

  /// Returns true if the last frame was not final.
  bool IsRefinementPending() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  class Medium;

  void MakeReachedImage(const FlowRenderFrame& pass, const FlowRenderState& scene);
  void Set(const FlowRenderFrame& pass, const FlowRenderState& scene);

  vtkNew<vtkImageData> Reached;
  vtkMTimeType ReachedVersion = 0;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkShadowedSliceMapper> Mapper;
  vtkNew<Medium> Painted;
  /// Objects that define the medium, and their last modification time.
  std::tuple<const void*, const void*, vtkMTimeType> MediumState;
};

}

#endif
