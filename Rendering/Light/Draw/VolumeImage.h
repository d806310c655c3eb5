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
 * @brief   the image of a mapper's volume, rendered alone or together with others
 *
 * Without a scene the mapper renders the image and shows it at once. vtkShadowedScenePass renders
 * it as a part of a scene before the mapper is called, which then only shows it.
 */
class VolumeImage
{
public:
  /// Begins an image, or reports the \a error of a request that cannot be rendered. Without scalars
  /// there is nothing to render.
  void Begin(const VolumeResources::Request& request, const Error& error);

  /// Renders the volume alone, as a part of \a scene unless that is null.
  void Draw(vtkRenderer* renderer, SliceScene* scene);

  /**
   * Renders all volumes without errors by \a together, as a part of \a scene, if there are two or
   * more. Returns an error if that is impossible.
   */
  static Error DrawTogether(vtkRenderer* renderer, const std::vector<VolumeImage*>& images,
    const std::shared_ptr<SliceRenderer>& together, SliceScene& scene);

  /// Returns whether the image is a part of a scene, until End, and was rendered together with
  /// others.
  bool IsInScene() const { return this->Scene != nullptr; }
  bool IsTogether() const { return this->Together != nullptr; }

  /// Ends the image after Draw, or after the scene, and replaces the values of the mapper's report.
  void End();

  /// Returns whether there is a volume, or an error.
  bool HasContents() const { return this->IsValid() || this->GetResult().Error; }

  /// Lays the image over the framebuffer that is bound.
  void Show(vtkRenderer* renderer);

  const VolumeResources::Request& GetRequest() const { return this->Volume.GetRequest(); }
  const VolumeResources::Result& GetResult() const { return this->Volume.GetResult(); }
  const SliceReport& GetReport() const { return this->Volume.GetReport(); }

  /// Implements vtkShadowedSliceMapper::ReadLightBuffer.
  bool ReadLightBuffer(vtkRenderer* renderer, vtkLight* light, vtkImageData* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool IsValid() const { return this->GetRequest().Scalars && !this->GetResult().Error; }
  SliceRenderer& GetRenderer() { return this->Together ? *this->Together : this->Alone; }

  VolumeResources Volume;
  SliceRenderer Alone;
  /// The renderer of the last image, with other volumes; null if the volume was rendered alone.
  std::shared_ptr<SliceRenderer> Together;
  SliceScene* Scene = nullptr;
};

}

#endif
