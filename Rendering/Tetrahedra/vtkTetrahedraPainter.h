#ifndef vtkTetrahedraPainter_h
#define vtkTetrahedraPainter_h

#include "vtkImageQuad.h"
#include "vtkNew.h"
#include "vtkTetrahedraPicture.h"
#include "vtkTetrahedraRenderReport.h"
#include "vtkTextureBuffer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

/**
 * @class   vtkTetrahedraPainter
 * @brief   draws tetrahedra with OpenGL 3.2
 *
 * Mesh and fields are uploaded once, as texture buffers; a tetrahedron is drawn as one point, by
 * its number, and a geometry shader makes its silhouette. A new view uploads an order at most. Sums
 * are kept in a framebuffer of floats, laid over the scene at the end.
 */
class vtkTetrahedraPainter
{
public:
  vtkTetrahedraPainter();
  ~vtkTetrahedraPainter();

  /**
   * Why this context cannot draw that many tetrahedra and points, or nothing.
   */
  std::string GetObstacle(vtkOpenGLRenderWindow* window, const vtkTetrahedraPicture& picture) const;

  /// What is new since the last picture.
  struct Changes
  {
    bool Mesh = true;
    bool Colors = true;
    bool Order = true;
    bool Surface = true;
  };

  /**
   * Draws. \a hasOpaque: whether the scene has opaque surfaces. Returns what is wrong, or nothing.
   */
  std::string Draw(vtkRenderer* renderer, const vtkTetrahedraPicture& picture,
    const Changes& changes, bool hasOpaque, vtkTetrahedraRenderReport& report);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::string GetFeatures(const vtkTetrahedraPicture& picture, bool hasOpaque) const;
  void Upload(vtkOpenGLRenderWindow* window, const vtkTetrahedraPicture& picture,
    const Changes& changes, vtkTetrahedraRenderReport& report);
  void UploadSurface(vtkOpenGLRenderWindow* window, const vtkTetrahedraPicture& picture,
    vtkTetrahedraRenderReport& report);
  void UploadOrder(const vtkTetrahedraPicture& picture, vtkTetrahedraRenderReport& report);
  bool PrepareTarget(vtkOpenGLRenderWindow* window, int width, int height, bool hasLayers);
  void SetUniforms(vtkShaderProgram* program, const vtkTetrahedraPicture& picture, bool hasOpaque);
  void SetSurfaceUniforms(vtkShaderProgram* program, const vtkTetrahedraPicture& picture);
  void DrawRange(vtkOpenGLRenderWindow* window, const vtkTetrahedraPicture& picture,
    std::size_t first, std::size_t number);
  void Resolve(vtkOpenGLRenderWindow* window, const vtkTetrahedraPicture& picture,
    vtkTextureObject* texture, bool isResolved);

  vtkTextureBuffer Points;
  vtkTextureBuffer Corners;
  vtkTextureBuffer Volumes;
  vtkTextureBuffer DeltaTs;
  vtkTextureBuffer Colors;
  vtkTextureBuffer Faces;
  vtkTextureBuffer SurfacePoints;
  vtkNew<vtkTextureObject> SurfaceTexture;
  vtkTextureBuffer Pieces;
  vtkTextureBuffer Starts;
  vtkTextureBuffer Buckets;
  vtkNew<vtkTextureObject> Sums;
  /// The layers drawn so far (PRIORITY).
  vtkNew<vtkTextureObject> Layers;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLVertexArrayObject> Vertices;
  unsigned int Order = 0;
  std::size_t OrderSize = 0;
  vtkImageQuad Quad;
  vtkImageQuad ResolveQuad;
};

#endif
