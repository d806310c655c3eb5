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
 * @brief   peels translucent surfaces: depth of each layer per pixel, starting with the nearest
 *
 * Layer k of a pixel has the k-th distinct fragment depth. If there are fewer fragments, its depth
 * is the background depth.
 */
class DepthLayers
{
public:
  struct Layer
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    std::vector<float> Depths;
    /// If true, surfaces behind the layer belong to it because the maximum number of layers is
    /// reached.
    bool HasRest = false;
  };

  DepthLayers();
  ~DepthLayers();

  /**
   * Peels the surfaces drawn by \a draw that are in front of the depths \a behind, which are stored
   * in rows of \a width pixels. Creates at most \a maximum layers. Returns an error if the GPU runs
   * out of memory.
   */
  Error Peel(vtkOpenGLRenderWindow* window, int width, const std::vector<float>& behind,
    std::size_t maximum, LayerShader& shader, const std::function<void()>& draw);

  const std::vector<Layer>& Get() const { return this->Layers; }
  vtkIdType GetBytes() const;

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::vector<Layer> Layers;
  LayerTarget Target;
};

}

#endif
