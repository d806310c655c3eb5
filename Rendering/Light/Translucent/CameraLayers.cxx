// SPDX-License-Identifier: BSD-3-Clause
#include "Translucent/CameraLayers.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/FloatTexture.h"
#include "Translucent/LayerShader.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

namespace interlume
{

CameraLayers::CameraLayers() = default;

CameraLayers::~CameraLayers() = default;

bool CameraLayers::Clear(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (FloatTexture::Allocate(window, this->Image, width, height, 4, false) == 0)
  {
    return false;
  }
  this->Target.Draw(window, this->Image, LayerTarget::OVER,
    [window]()
    {
      window->GetState()->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
      glClear(GL_COLOR_BUFFER_BIT);
    });
  this->IsShown = false;
  return true;
}

void CameraLayers::Shade(vtkOpenGLRenderWindow* window, std::size_t layer, LayerShader& shader,
  const std::function<void()>& draw)
{
  const DepthLayers::Layer& shaded = this->Depths.Get()[layer];
  shader.Begin(shaded.HasRest ? LayerShader::SHADE_REST : LayerShader::SHADE, shaded.Texture);
  this->Target.Draw(window, this->Image, LayerTarget::OVER, draw);
  shader.Begin(LayerShader::SHOW);
}

void CameraLayers::Composite(vtkOpenGLRenderWindow* window, const std::function<void()>& draw)
{
  this->Target.Draw(window, this->Image, LayerTarget::OVER, draw);
}

void CameraLayers::Show(vtkOpenGLRenderWindow* window)
{
  if (!this->IsShown)
  {
    this->Quad.Draw(window, this->Image);
    this->IsShown = true;
  }
}

vtkIdType CameraLayers::GetBytes() const
{
  return this->Depths.GetBytes() +
    (this->Image->GetHandle() == 0 ? 0
                                   : static_cast<vtkIdType>(4 * sizeof(float)) *
          static_cast<vtkIdType>(this->Image->GetWidth()) *
          static_cast<vtkIdType>(this->Image->GetHeight()));
}

void CameraLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depths.ReleaseGraphicsResources(window);
  this->Target.ReleaseGraphicsResources(window);
  this->Image->ReleaseGraphicsResources(window);
  this->Quad.ReleaseGraphicsResources(window);
  this->IsShown = true;
}

}
