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
 * @brief   depth peeling of translucent surfaces
 *
 * Layer k contains the k-th smallest fragment depth of each pixel, counting equal depths once. For
 * pixels with fewer depths, it contains the depth of the background.
 */
class DepthLayers
{
public:
  struct Layer
  {
    vtkSmartPointer<vtkTextureObject> Texture;
    std::vector<float> Depths;
    /// If true, this is the last layer and includes all surfaces behind it, because the maximum
    /// number of layers was reached.
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
