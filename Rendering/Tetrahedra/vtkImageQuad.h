#ifndef vtkImageQuad_h
#define vtkImageQuad_h

#include "vtkNew.h"
#include "vtkType.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
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
   * Draws what was uploaded last, or \a texture, into the framebuffer that is bound. \a features are
   * those of InterlumeResolveFS.glsl, which \a setUniforms may want more for.
   */
  void Draw(vtkOpenGLRenderWindow* window) { this->Draw(window, this->Texture, "COLORS"); }
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, const std::string& features,
    const std::function<void(vtkShaderProgram*)>& setUniforms = nullptr);

  void ReleaseGraphicsResources(vtkWindow* window);

  bool HasTexture() const;

private:
  vtkNew<vtkTextureObject> Texture;
  std::string Features;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

#endif
