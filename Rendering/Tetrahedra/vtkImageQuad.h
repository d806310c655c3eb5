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
 * Colour is already multiplied by opacity. Depth is neither tested nor written, since the picture
 * was made with the scene's depth in hand; a selection's is both.
 */
class vtkImageQuad
{
public:
  vtkImageQuad();
  ~vtkImageQuad();

  /**
   * Uploads RGBA, row by row from below. Pixels of the viewport between those of the picture are
   * interpolated, if \a isSmooth. Returns the bytes.
   */
  vtkIdType Upload(vtkOpenGLRenderWindow* window, int width, int height,
    const std::vector<float>& colors, bool isSmooth = true);

  /**
   * Draws what was uploaded last, or \a texture, into the framebuffer that is bound. \a features
   * are those of InterlumeResolveFS.glsl, which \a setUniforms may want more for.
   */
  void Draw(vtkOpenGLRenderWindow* window, const std::string& features = "COLORS")
  {
    this->Draw(window, this->Texture, features);
  }
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* texture, const std::string& features,
    const std::function<void(vtkShaderProgram*)>& setUniforms = nullptr);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkTextureObject> Texture;
  std::string Features;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

#endif
