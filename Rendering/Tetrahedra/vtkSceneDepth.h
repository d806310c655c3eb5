#ifndef vtkSceneDepth_h
#define vtkSceneDepth_h

#include "vtkTetrahedraView.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;

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

  /// Depths as vtkTetrahedraView has them, for each of its pixels; empty where nothing is drawn.
  const std::vector<float>& GetDepths() const { return this->Depths; }

private:
  bool ReadBuffer(vtkOpenGLRenderWindow* window, int left, int bottom, int width, int height);

  std::vector<float> Buffer;
  std::vector<float> Depths;
};

#endif
