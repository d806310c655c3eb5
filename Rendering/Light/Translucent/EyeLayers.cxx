// SPDX-License-Identifier: BSD-3-Clause
#include "Translucent/EyeLayers.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/FloatTexture.h"
#include "Translucent/LayerShader.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

namespace interlume
{

EyeLayers::EyeLayers() = default;

EyeLayers::~EyeLayers() = default;

bool EyeLayers::Clear(vtkOpenGLRenderWindow* window, int width, int height)
{
  if (FloatTexture::Allocate(window, this->Picture, width, height, 4, false) == 0)
  {
    return false;
  }
  this->Target.Draw(window, this->Picture, LayerTarget::OVER,
    [window]()
    {
      window->GetState()->vtkglClearColor(0.0F, 0.0F, 0.0F, 0.0F);
      glClear(GL_COLOR_BUFFER_BIT);
    });
  this->IsShown = false;
  return true;
}

void EyeLayers::Shade(vtkOpenGLRenderWindow* window, std::size_t layer, LayerShader& shader,
  const std::function<void()>& draw)
{
  const DepthLayers::Layer& shaded = this->Depths.Get()[layer];
  shader.Begin(shaded.HasRest ? LayerShader::SHADE_REST : LayerShader::SHADE, shaded.Texture);
  this->Target.Draw(window, this->Picture, LayerTarget::OVER, draw);
  shader.Begin(LayerShader::SHOW);
}

void EyeLayers::Lay(vtkOpenGLRenderWindow* window, const std::function<void()>& draw)
{
  this->Target.Draw(window, this->Picture, LayerTarget::OVER, draw);
}

void EyeLayers::Show(vtkOpenGLRenderWindow* window)
{
  if (!this->IsShown)
  {
    this->Quad.Draw(window, this->Picture);
    this->IsShown = true;
  }
}

vtkIdType EyeLayers::GetBytes() const
{
  return this->Depths.GetBytes() +
    (this->Picture->GetHandle() == 0 ? 0
                                     : static_cast<vtkIdType>(4 * sizeof(float)) *
          static_cast<vtkIdType>(this->Picture->GetWidth()) *
          static_cast<vtkIdType>(this->Picture->GetHeight()));
}

void EyeLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depths.ReleaseGraphicsResources(window);
  this->Target.ReleaseGraphicsResources(window);
  this->Picture->ReleaseGraphicsResources(window);
  this->Quad.ReleaseGraphicsResources(window);
  this->IsShown = true;
}

}
