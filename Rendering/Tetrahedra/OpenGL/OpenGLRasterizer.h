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
 * Mesh and fields are uploaded as texture buffers, and only when they change. If only the view
 * changes, at most the drawing order is uploaded. Each tetrahedron is drawn either as one point,
 * from which a geometry shader creates the silhouette, or as four vertices, whose vertex shader
 * reads the tetrahedron from the buffers. The second method suits GPUs with slow geometry shaders.
 * Tetrahedra are drawn into a floating-point framebuffer, which is finally blended over the scene.
 */
class OpenGLRasterizer
{
public:
  OpenGLRasterizer();
  ~OpenGLRasterizer();

  /**
   * Returns an error if the context does not support OpenGL 3.2, or if the mesh has more tetrahedra
   * or points than a texture buffer can have texels.
   */
  Error FindError(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame) const;

  /**
   * Draws an image. \a hasOpaque is true if opaque surfaces or the far plane may cut the mesh.
   * Returns an error if OpenGL fails.
   */
  Error Draw(
    vtkRenderer* renderer, const TetrahedraFrame& frame, bool hasOpaque, TetrahedraReport& report);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string GetFeatures(const TetrahedraFrame& frame, bool hasOpaque) const;
  /// Uploads changed data.
  void Upload(
    vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame, TetrahedraReport& report);
  ///@{
  /// Upload one array, the arrays and texture of the boundary triangles, or the indices for vertex
  /// pulling. Return the number of bytes.
  template <typename Value>
  vtkIdType Upload(vtkOpenGLRenderWindow* window, const char* name, TextureBuffer::Formats format,
    const std::vector<Value>& values);
  vtkIdType UploadSurface(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame);
  vtkIdType UploadStrips();
  ///@}
  /// Binds the buffers that a program uses.
  void ActivateBuffers(vtkShaderProgram* program);
  void DeactivateBuffers();
  bool PrepareTarget(vtkOpenGLRenderWindow* window, int width, int height, bool hasLayers);
  void SetUniforms(vtkShaderProgram* program, const TetrahedraFrame& frame, bool hasOpaque);
  void SetSurfaceUniforms(vtkShaderProgram* program, const TetrahedraFrame& frame);
  /// Draws and composites layer by layer if Blend is PRIORITY; otherwise draws all tetrahedra at
  /// once. Returns false if the shaders cannot be compiled.
  bool DrawLayers(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
    const std::string& features, bool hasOpaque);
  bool DrawLayer(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
    const std::string& features, bool hasOpaque, std::size_t first, std::size_t number);
  /// Clears the framebuffer.
  static void Clear(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame);
  void DrawRange(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame, std::size_t first,
    std::size_t number);
  void Resolve(vtkOpenGLRenderWindow* window, const TetrahedraFrame& frame,
    vtkTextureObject* texture, bool isResolved);
  void ReportBuffers(const TetrahedraFrame& frame, bool hasOpaque, TetrahedraReport& report);

  static constexpr TetrahedraFrame::Changes NONE{ -1, -1, -1, -1, -1, -1 };
  /// Versions of the uploaded data, and the planes that cut the uploaded mesh.
  TetrahedraFrame::Changes Uploaded = NONE;
  std::vector<glm::dvec4> Planes;
  /// Texture buffers by uniform name.
  std::map<std::string, TextureBuffer> Buffers;
  vtkNew<vtkTextureObject> Sums;
  /// The composite of the layers drawn so far (PRIORITY).
  vtkNew<vtkTextureObject> Layers;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLVertexArrayObject> Vertices;
  /// OpenGL index buffer for vertex pulling: two triangles for each of STRIPS tetrahedra.
  unsigned int Strips = 0;
  ImageQuad Quad;
  ImageQuad ResolveQuad;
};

}

#endif
