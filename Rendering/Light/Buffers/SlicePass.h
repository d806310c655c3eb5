// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SlicePass_h
#define interlume_SlicePass_h

#include "Common/Error.h"

#include "vtkNew.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;

namespace interlume
{

/**
 * @class   SlicePass
 * @brief   a shader program that draws the triangles of slices
 */
class SlicePass
{
public:
  SlicePass();
  ~SlicePass();

  /**
   * Compiles the fragments' source, for triangles in \a vertices. Slices that are \a isMarked have
   * one depth each, nearer from slab to slab and volume to volume. Returns an error if that fails.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, const std::string& source,
    vtkOpenGLBufferObject* vertices, bool isMarked = false);
  vtkShaderProgram* GetProgram() const { return this->Program; }

  /// Draws the triangles of a slab that begins at \a entrance into the framebuffer that is bound.
  /// \a starts are the first vertex of each slab, and their number. So many volumes draw each slab
  /// one after the other; slices that are marked are those of the volume with this \a number.
  void Draw(vtkOpenGLRenderWindow* window, const std::vector<std::size_t>& starts, int slab,
    double entrance, int number = 0, int volumes = 1);

  /// Draws so many vertices as points, of a slab that begins at \a entrance.
  void DrawPoints(
    vtkOpenGLRenderWindow* window, std::size_t first, std::size_t count, double entrance);

  void ReleaseGraphicsResources();

private:
  vtkShaderProgram* Program = nullptr;
  bool IsMarked = false;
  vtkNew<vtkOpenGLVertexArrayObject> Vertices;
};

}

#endif
