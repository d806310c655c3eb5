// SPDX-License-Identifier: BSD-3-Clause
#include "Offscreen/FloatTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

namespace interlume
{

bool FloatTexture::Fits(vtkTextureObject* texture, int width, int height)
{
  return texture->GetHandle() != 0 && static_cast<int>(texture->GetWidth()) == width &&
    static_cast<int>(texture->GetHeight()) == height;
}

vtkIdType FloatTexture::Allocate(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  int width, int height, int channels, bool isSmooth)
{
  texture->SetContext(window);
  const int filter = isSmooth ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  texture->SetMinificationFilter(filter);
  texture->SetMagnificationFilter(filter);
  texture->SetWrapS(vtkTextureObject::ClampToEdge);
  texture->SetWrapT(vtkTextureObject::ClampToEdge);
  const bool fits = Fits(texture, width, height) && texture->GetComponents() == channels;
  if (!fits)
  {
    // Without this reset, the texture keeps its previous format.
    texture->ResetFormatAndType();
  }
  if (!fits &&
    !texture->Allocate2D(
      static_cast<unsigned int>(width), static_cast<unsigned int>(height), channels, VTK_FLOAT))
  {
    return 0;
  }
  return static_cast<vtkIdType>(sizeof(float)) * width * height * channels;
}

}
