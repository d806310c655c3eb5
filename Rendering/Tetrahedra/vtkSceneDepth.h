#ifndef vtkSceneDepth_h
#define vtkSceneDepth_h

#include "vtkTetrahedraView.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;

/**
 * @class   vtkSceneDepth
 * @brief   the depth of what is already in the picture
 */
class vtkSceneDepth
{
public:
  /**
   * Reads the depth buffer of the renderer's viewport, from the framebuffer that is being drawn to,
   * with one sample a pixel or more. Returns false where it could not be read.
   */
  bool Read(vtkRenderer* renderer, const vtkTetrahedraView& view, int stride);

  /**
   * Copies the depth buffer of the renderer's viewport to a texture. Returns false where there is
   * none.
   */
  static bool CopyTo(vtkRenderer* renderer, vtkTextureObject* texture);

  /// Depths as vtkTetrahedraView has them, for each of its pixels; empty where nothing is drawn.
  const std::vector<float>& GetDepths() const { return this->Depths; }

private:
  std::vector<float> Buffer;
  std::vector<float> Depths;
};

#endif
