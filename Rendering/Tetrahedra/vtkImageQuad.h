#ifndef vtkImageQuad_h
#define vtkImageQuad_h

#include "vtkNew.h"
#include "vtkType.h"

#include <memory>
#include <vector>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

/**
 * @class   vtkImageQuad
 * @brief   lays a picture of floats over the viewport
 *
 * Colour is already multiplied by opacity. Depth is neither tested nor written: the picture was made
 * with the scene's depth in hand.
 */
class vtkImageQuad
{
public:
  vtkImageQuad();
  ~vtkImageQuad();

  /**
   * Uploads RGBA, row by row from below. Returns the bytes.
   */
  vtkIdType Upload(
    vtkOpenGLRenderWindow* window, int width, int height, const std::vector<float>& colors);

  /**
   * Draws what was uploaded last, or \a texture.
   */
  void Draw(vtkOpenGLRenderWindow* window) { this->Draw(window, this->Texture); }
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* texture);

  void ReleaseGraphicsResources(vtkWindow* window);

  bool HasTexture() const;

private:
  vtkNew<vtkTextureObject> Texture;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

#endif
