// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_OpenGLRasterizer_h
#define interlume_OpenGLRasterizer_h

#include "Common/Error.h"
#include "Frame/TetrahedraFrame.h"
#include "Frame/TetrahedraReport.h"
#include "Offscreen/ImageQuad.h"
#include "OpenGL/TextureBuffer.h"

#include "vtkNew.h"

#include <map>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   OpenGLRasterizer
 * @brief   draws tetrahedra with OpenGL 3.2
 *
 * Mesh and fields are uploaded once, as texture buffers. A tetrahedron is drawn as one point of
 * which a geometry shader makes the silhouette, or as four vertices that each pull it from the
 * buffers, which suits graphics cards whose geometry shaders are slow. A new view uploads an order
 * at most. Sums are kept in a framebuffer of floats, laid over the scene at the end.
 */
class OpenGLRasterizer
{
public:
  OpenGLRasterizer();
  ~OpenGLRasterizer();

  /**
   * Returns an error if this context cannot draw that many tetrahedra and points.
   */
  Error FindError(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame) const;

  /**
   * Draws an image. \a hasOpaque is true if the scene has opaque surfaces. Returns an error if
   * OpenGL fails.
   */
  Error Draw(
    vtkRenderer* renderer, const TetrahedraFrame& frame, bool hasOpaque, TetrahedraReport& report);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string GetFeatures(const TetrahedraFrame& frame, bool hasOpaque) const;
  /// Uploads what has changed.
  void Upload(
    vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame, TetrahedraReport& report);
  ///@{
  /// Upload an array, the arrays and the image of boundary triangles, and indices. Return the
  /// bytes.
  template <typename Value>
  vtkIdType Upload(vtkOpenGLRenderWindow* window, const char* name, TextureBuffer::Formats format,
    const std::vector<Value>& values);
  vtkIdType UploadSurface(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame);
  vtkIdType UploadStrips();
  ///@}
  /// Binds the arrays that a program uses.
  void ActivateBuffers(vtkShaderProgram* program);
  void DeactivateBuffers();
  bool PrepareTarget(vtkOpenGLRenderWindow* window, int width, int height, bool hasLayers);
  void SetUniforms(vtkShaderProgram* program, const TetrahedraFrame& frame, bool hasOpaque);
  void SetSurfaceUniforms(vtkShaderProgram* program, const TetrahedraFrame& frame);
  /// Draws all layers of PRIORITY one over the other, or everything at once. Returns whether the
  /// shaders could be compiled, as DrawLayer does.
  bool DrawLayers(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
    const std::string& features, bool hasOpaque);
  bool DrawLayer(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
    const std::string& features, bool hasOpaque, std::size_t first, std::size_t number);
  /// Clears what is drawn to.
  static void Clear(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame);
  void DrawRange(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame, std::size_t first,
    std::size_t number);
  void Resolve(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
    vtkTextureObject* texture, bool isResolved);
  void ReportBuffers(const TetrahedraFrame& frame, bool hasOpaque, TetrahedraReport& report);

  static constexpr TetrahedraFrame::Changes NONE{ -1, -1, -1, -1, -1, -1 };
  /// The versions of what was uploaded, and the planes that cut it.
  TetrahedraFrame::Changes Uploaded = NONE;
  std::vector<glm::dvec4> Planes;
  /// The arrays that shaders read, by their names there.
  std::map<std::string, TextureBuffer> Buffers;
  vtkNew<vtkTextureObject> SurfaceTexture;
  vtkNew<vtkTextureObject> Sums;
  /// The layers drawn so far (PRIORITY).
  vtkNew<vtkTextureObject> Layers;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLVertexArrayObject> Vertices;
  /// The indices of two triangles for each of STRIPS tetrahedra, where their vertices are pulled.
  unsigned int Strips = 0;
  ImageQuad Quad;
  ImageQuad ResolveQuad;
};

}

#endif
