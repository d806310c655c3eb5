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
 * @brief   composites a floating-point image over the viewport
 *
 * The image has RGBA channels, with colors premultiplied by opacity. Depth is neither tested nor
 * written, since the image was rendered with the scene's depth. With SELECTION, depth is both
 * tested and written. An image smaller than the viewport is stretched with the texture's filter.
 *
 * Features are words separated by spaces:
 * - SATURATE: each channel is clamped to 1
 * - SUM: the image's color is added to the background, regardless of opacity
 * - SELECTION: the fourth channel is the depth, in [0, 1]; pixels with a negative value are
 *   discarded
 */
class INTERLUMESCENE_EXPORT ImageQuad
{
public:
  ImageQuad();
  ~ImageQuad();
  ImageQuad(const ImageQuad&) = delete;
  ImageQuad& operator=(const ImageQuad&) = delete;

  /// Fraction of the image's columns and rows that the viewport shows, from the lower left. With 1,
  /// the viewport shows the whole image.
  using Fraction = std::array<double, 2>;

  /**
   * Uploads an RGBA image, row by row from the bottom. It is interpolated linearly if \a isSmooth.
   * Returns its size in bytes.
   */
  vtkIdType Upload(vtkOpenGLRenderWindow* window, int width, int height,
    const std::vector<float>& colors, bool isSmooth = true);

  ///@{
  /**
   * Draws the last uploaded image, or \a texture, into the bound framebuffer.
   */
  void Draw(vtkOpenGLRenderWindow* window, const std::string& features = {},
    const Fraction& fraction = Fraction{ { 1.0, 1.0 } });
  void Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
    const std::string& features = {}, const Fraction& fraction = Fraction{ { 1.0, 1.0 } });
  ///@}

  /**
   * Draws with a custom fragment shader. The shader samples \a texture as `image` at `texCoord`, in
   * [0, 1]. \a setUniforms sets any other uniforms.
   */
  void DrawWithShader(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
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
