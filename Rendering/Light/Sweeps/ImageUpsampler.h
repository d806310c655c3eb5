// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ImageUpsampler_h
#define interlume_ImageUpsampler_h

#include "Offscreen/ImageQuad.h"

#include "vtkSmartPointer.h"

#include <glm/mat4x4.hpp>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace interlume
{

/**
 * @class   ImageUpsampler
 * @brief   upsamples an image to the viewport and preserves the edges of surfaces
 *
 * Each pixel of the image ends at the surface seen at its center. Neighbors with very different
 * depths are not interpolated. Instead, a pixel of the viewport uses those neighbors that end at
 * its own surface. Surfaces narrower than a pixel of the image may be lost.
 */
class ImageUpsampler
{
public:
  ImageUpsampler();
  ~ImageUpsampler();

  /// Sets the depths at which the next image ends and begins, in textures of the viewport's size.
  /// \a front is null if the image begins at the camera. Both are null if there are no surfaces.
  void SetDepths(
    vtkTextureObject* surfaces, vtkTextureObject* front, const glm::dmat4& unitFromClip);

  /// Shows the image. Returns false if there are no depths, or if they are no finer than the image.
  bool Show(vtkOpenGLRenderWindow* window, vtkTextureObject* image);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkSmartPointer<vtkTextureObject> Surfaces;
  vtkSmartPointer<vtkTextureObject> Front;
  glm::dmat4 UnitFromClip{ 1.0 };
  ImageQuad Quad;
};

}

#endif
