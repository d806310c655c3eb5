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
 * @brief   shader program that draws the triangles of slices
 */
class SlicePass
{
public:
  SlicePass();
  ~SlicePass();

  /**
   * Compiles the fragment shader \a source for triangles in \a vertices. If \a isMarked is true,
   * each slice has a separate depth, which decreases from slab to slab and from volume to volume.
   * Returns an error if the program cannot be compiled.
   */
  Error Prepare(vtkOpenGLRenderWindow* window, const std::string& source,
    vtkOpenGLBufferObject* vertices, bool isMarked = false);
  vtkShaderProgram* GetProgram() const { return this->Program; }

  /// Draws the triangles of a slab into the bound framebuffer. The slab begins at \a entrance along
  /// the normal. \a starts contains the first vertex of each slab, followed by the number of
  /// vertices. \a number is the index of this volume among the \a volumes that draw each slab in
  /// turn. It determines the depth of marked slices.
  void Draw(vtkOpenGLRenderWindow* window, const std::vector<std::size_t>& starts, int slab,
    double entrance, int number = 0, int volumes = 1);

  /// Draws \a count vertices as points, for a slab that begins at \a entrance.
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
