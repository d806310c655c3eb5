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
 * the image as a part of a scene before it calls the mapper, which then only shows it.
 */
class VolumeImage
{
public:
  /// Begins an image, or reports the \a error of an invalid request. If the request has no scalars,
  /// nothing is rendered.
  void Begin(const VolumeResources::Request& request, const Error& error);

  /// Renders the volume separately, as a part of \a scene unless that is null.
  void Draw(vtkRenderer* renderer, SliceScene* scene);

  /**
   * Renders all volumes that have no errors as a part of \a scene, with the renderer \a together,
   * if there are at least two. Returns an error if that fails.
   */
  static Error DrawTogether(vtkRenderer* renderer, const std::vector<VolumeImage*>& images,
    const std::shared_ptr<SliceRenderer>& together, SliceScene& scene);

  /// Returns true, until End is called, if the image is a part of a scene.
  bool IsInScene() const { return this->Scene != nullptr; }
  /// Returns true if the volume was rendered together with other volumes.
  bool IsTogether() const { return this->Together != nullptr; }

  /// Finishes the image after Draw, or after the entire scene has been rendered, and updates the
  /// mapper's report.
  void End();

  /// Returns true if there is a volume or an error.
  bool HasContents() const { return this->IsValid() || this->GetResult().Error; }

  /// Composites the image over the bound framebuffer.
  void Show(vtkRenderer* renderer);

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
