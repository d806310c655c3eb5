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
 * @brief   shows a picture that is coarser than the viewport, up to the edges of surfaces
 *
 * Pixels of the picture end at surfaces as their middles see them. Where neighbours end at depths
 * that are far apart they are not mixed: a pixel of the viewport is that of those around it that
 * end where its own surface is. Surfaces narrower than a pixel of the picture may be in none of
 * them.
 */
class ImageUpsampler
{
public:
  ImageUpsampler();
  ~ImageUpsampler();

  /// Sets the depths at which the next picture ends and, null for those of the eye, begins; without
  /// any surfaces both are null. They are as large as the viewport.
  void SetDepths(
    vtkTextureObject* surfaces, vtkTextureObject* front, const glm::dmat4& unitFromClip);

  /// Shows the picture. Returns false where it is as fine as the depths, or where there are none.
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
