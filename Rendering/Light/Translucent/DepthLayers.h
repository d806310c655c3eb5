// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DepthLayers_h
#define interlume_DepthLayers_h

#include "Common/Error.h"
#include "Translucent/LayerTarget.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

class LayerShader;

/**
 * @class   DepthLayers
 * @brief   peels translucent surfaces: their depths from the nearest layer on, pixel by pixel
 *
 * Layer k of a pixel is the k-th different depth of a fragment there. Depths of pixels without one
 * are those of what is behind all.
 */
class DepthLayers
{
public:
  struct Layer
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    std::vector<float> Depths;
    /// Whether surfaces behind the layer count as in it, since there may be no more layers.
    bool HasRest = false;
  };

  DepthLayers();
  ~DepthLayers();

  /**
   * Peels what \a draw draws, in front of the depths \a behind, \a width times as many, into \a
   * most layers. Returns an error if there is no memory for them.
   */
  Error Peel(vtkOpenGLRenderWindow* window, int width, const std::vector<float>& behind,
    std::size_t most, LayerShader& shader, const std::function<void()>& draw);

  const std::vector<Layer>& Get() const { return this->Layers; }
  vtkIdType GetBytes() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::vector<Layer> Layers;
  LayerTarget Target;
};

}

#endif
