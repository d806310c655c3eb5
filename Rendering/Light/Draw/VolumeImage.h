// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_VolumeImage_h
#define interlume_VolumeImage_h

#include "Common/Error.h"
#include "Draw/SliceRenderer.h"
#include "Draw/VolumeResources.h"

#include <memory>
#include <vector>

class vtkImageData;
class vtkLight;
class vtkRenderer;
class vtkWindow;

namespace interlume
{

struct SliceScene;

/**
 * @class   VolumeImage
 * @brief   the rendered image of a mapper's volume, alone or together with other volumes
 *
 * Without a scene, the mapper renders and shows the image immediately. vtkShadowedScenePass renders
 * the image as part of a scene before it calls the mapper, which then only shows it.
 */
class VolumeImage
{
public:
  /// Begins an image. If \a error is set, the request is invalid and the image reports the error.
  /// If the request has no scalars, nothing is rendered.
  void Begin(const VolumeResources::Request& request, const Error& error);

  /// Renders the volume separately. If \a scene is not null, the volume is part of it.
  void Draw(vtkRenderer* renderer, SliceScene* scene);

  /**
   * Renders all volumes without errors in one image, as part of \a scene, using the renderer \a
   * together. Does nothing if there are fewer than two such volumes. Returns an error if rendering
   * fails.
   */
  static Error DrawTogether(vtkRenderer* renderer, const std::vector<VolumeImage*>& images,
    const std::shared_ptr<SliceRenderer>& together, SliceScene& scene);

  /// Returns true if the image is part of a scene and End has not been called yet.
  bool IsInScene() const { return this->Scene != nullptr; }
  /// Returns true if the last image was rendered together with other volumes.
  bool IsRenderedTogether() const { return this->Together != nullptr; }

  /// Finishes the image after Draw, or after the entire scene has been rendered, and updates the
  /// mapper's report.
  void End();

  /// Returns true if there is something to render or an error to report.
  bool HasContents() const { return this->IsValid() || this->GetResult().Error; }

  /// Composites the image over the bound framebuffer.
  void Show(vtkRenderer* renderer);

  /// Returns true if the last image was not final.
  bool IsRefinementPending() const
  {
    return this->IsValid() && !this->Together && this->OwnRenderer.IsRefinementPending();
  }

  const VolumeResources::Request& GetRequest() const { return this->Volume.GetRequest(); }
  const VolumeResources::Result& GetResult() const { return this->Volume.GetResult(); }
  const SliceReport& GetReport() const { return this->Volume.GetReport(); }

  /// Implements vtkShadowedSliceMapper::ReadLightBuffer.
  bool ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool IsValid() const { return this->GetRequest().Scalars && !this->GetResult().Error; }
  SliceRenderer& GetRenderer() { return this->Together ? *this->Together : this->OwnRenderer; }

  VolumeResources Volume;
  SliceRenderer OwnRenderer;
  /// Renderer that drew the last image together with other volumes, or null if the volume was
  /// rendered separately.
  std::shared_ptr<SliceRenderer> Together;
  SliceScene* Scene = nullptr;
};

}

#endif
