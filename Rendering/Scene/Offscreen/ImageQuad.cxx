// SPDX-License-Identifier: BSD-3-Clause
#include "Offscreen/ImageQuad.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/ShaderFeatures.h"

#include "InterlumeImageQuadFS.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace interlume
{

ImageQuad::ImageQuad() = default;

ImageQuad::~ImageQuad() = default;

vtkIdType ImageQuad::Upload(vtkOpenGLRenderWindow* window, int width, int height,
  const std::vector<float>& colors, bool isSmooth)
{
  this->Texture->SetContext(window);
  const int filter = isSmooth ? vtkTextureObject::Linear : vtkTextureObject::Nearest;
  this->Texture->SetMinificationFilter(filter);
  this->Texture->SetMagnificationFilter(filter);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->Create2DFromRaw(static_cast<unsigned int>(width),
    static_cast<unsigned int>(height), 4, VTK_FLOAT, const_cast<float*>(colors.data()));
  const std::size_t bytes = colors.size() * sizeof(float);
  return static_cast<vtkIdType>(bytes);
}

void ImageQuad::Draw(
  vtkOpenGLRenderWindow* window, const std::string& features, const Fraction& fraction)
{
  this->Draw(window, this->Texture, features, fraction);
}

void ImageQuad::Draw(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  const std::string& features, const Fraction& fraction)
{
  const std::array<float, 2> floats{ { static_cast<float>(fraction[0]),
    static_cast<float>(fraction[1]) } };
  this->Render(
    window, texture, ShaderFeatures::Insert(InterlumeImageQuadFS, features),
    [&floats](vtkShaderProgram* program) { program->SetUniform2f("share", floats.data()); },
    features.find("SELECTION") != std::string::npos);
}

void ImageQuad::DrawWithShader(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  const std::string& fragmentShader, const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  this->Render(window, texture, fragmentShader, setUniforms, false);
}

void ImageQuad::Render(vtkOpenGLRenderWindow* window, vtkTextureObject* texture,
  const std::string& fragmentShader, const std::function<void(vtkShaderProgram*)>& setUniforms,
  bool usesDepth)
{
  if (!this->Quad || this->FragmentShader != fragmentShader)
  {
    this->FragmentShader = fragmentShader;
    this->Quad =
      std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragmentShader.c_str(), nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  if (!this->Quad->Program)
  {
    return;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  if (usesDepth)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
  }
  else
  {
    state->vtkglDisable(GL_DEPTH_TEST);
  }
  state->vtkglDepthMask(usesDepth ? GL_TRUE : GL_FALSE);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  texture->Activate();
  this->Quad->Program->SetUniformi("image", texture->GetTextureUnit());
  if (setUniforms)
  {
    setUniforms(this->Quad->Program);
  }
  this->Quad->Render();
  texture->Deactivate();
}

void ImageQuad::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  if (this->Quad)
  {
    this->Quad->ReleaseGraphicsResources(window);
    this->Quad.reset();
  }
}

}
