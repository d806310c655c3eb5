// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageQuad_h
#define interlume_ImageQuad_h

#include "InterlumeSceneModule.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   ImageQuad
 * @brief   lays a picture of floats over the viewport
 *
 * The picture holds red, green and blue, already multiplied by opacity, and opacity. Depth is
 * neither tested nor written, since the picture was made with the scene's depth in hand; the depth
 * of a selection is both tested and written. Where the picture is smaller than the viewport it is
 * stretched, by the texture's own filter.
 *
 * Features are words separated by spaces:
 * - SATURATE: each channel is at most 1;
 * - SUM: the picture's colour is added to what is behind, whatever its opacity;
 * - SELECTION: the fourth channel is the depth, 0 to 1; below 0 nothing is drawn.
 */
class INTERLUMESCENE_EXPORT ImageQuad
{
public:
  ImageQuad();
  ~ImageQuad();
  ImageQuad(const ImageQuad&) = delete;
  ImageQuad& operator=(const ImageQuad&) = delete;

  /// The columns and rows that the viewport shows, from the lower left, as a share of the
  /// picture's: 1 where its last pixels end with the viewport.
  using Share = std::array<double, 2>;

  /**
   * Uploads a picture of RGBA, row by row from below. Pixels of the viewport between those of the
   * picture are interpolated if \a isSmooth. Returns the bytes.
   */
  vtkIdType Upload(vtkOpenGLRenderWindow* window, int width, int height,
    const std::vector<float>& colors, bool isSmooth = true);

  ///@{
  /**
   * Draws what was uploaded last, or \a texture, into the framebuffer that is bound.
   */
  void Draw(vtkOpenGLRenderWindow* window, const std::string& features = {},
    const Share& share = Share{ { 1.0, 1.0 } });
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
    const std::string& features = {}, const Share& share = Share{ { 1.0, 1.0 } });
  ///@}

  /**
   * Draws with a fragment shader of the caller's, which finds \a texture as `image`, and the
   * fragment's place in it as `texCoord`, 0 to 1; \a setUniforms sets its other uniforms.
   */
  void DrawWith(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
    const std::string& fragmentShader,
    const std::function<void(vtkShaderProgram*)>& setUniforms = nullptr);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void Render(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
    const std::string& fragmentShader, const std::function<void(vtkShaderProgram*)>& setUniforms,
    bool usesDepth);

  vtkNew<vtkTextureObject> Texture;
  std::string FragmentShader;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

}

#endif
