// SPDX-License-Identifier: BSD-3-Clause
#include "Receivers/LightTransmittance.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/FloatTexture.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

LightTransmittance::LightTransmittance() = default;

LightTransmittance::~LightTransmittance() = default;

void LightTransmittance::Clear(
  int width, int height, int channels, const std::vector<vtkLight*>& lights)
{
  this->Width = width;
  this->Height = height;
  this->Channels = channels;
  this->Lights = lights;
  this->Columns =
    std::max(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(lights.size())))), 1);
  this->HasContents = false;
}

int LightTransmittance::GetTile(vtkLight* light) const
{
  const auto found = std::find(this->Lights.begin(), this->Lights.end(), light);
  return found == this->Lights.end() ? -1 : static_cast<int>(found - this->Lights.begin());
}

std::array<int, 2> LightTransmittance::GetOrigin(int tile) const
{
  return { { tile % this->Columns * this->Width, tile / this->Columns * this->Height } };
}

bool LightTransmittance::Bind(vtkOpenGLRenderWindow* window)
{
  const int rows = (static_cast<int>(this->Lights.size()) + this->Columns - 1) / this->Columns;
  if (!this->HasContents)
  {
    this->Bytes = FloatTexture::Allocate(window, this->Texture, this->Columns * this->Width,
      rows * this->Height, this->Channels, false);
    if (this->Bytes == 0)
    {
      return false;
    }
  }
  this->Framebuffer->SetContext(window);
  this->Framebuffer->Bind(GL_DRAW_FRAMEBUFFER);
  this->Framebuffer->AddColorAttachment(0, this->Texture);
  this->Framebuffer->ActivateDrawBuffer(0);
  if (!this->HasContents)
  {
    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglClearColor color(state);
    vtkOpenGLState::ScopedglColorMask mask(state);
    vtkOpenGLState::ScopedglEnableDisable scissor(state, GL_SCISSOR_TEST);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglClearColor(1.0F, 1.0F, 1.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    this->HasContents = true;
  }
  return true;
}

bool LightTransmittance::Make(vtkOpenGLRenderWindow* window)
{
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  const bool isMade = this->Bind(window);
  state->PopFramebufferBindings();
  return isMade;
}

void LightTransmittance::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->HasContents = false;
}

}
