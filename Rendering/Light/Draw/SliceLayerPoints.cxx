// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SliceLayerPoints.h"

#include "Draw/SliceFrame.h"
#include "Draw/SliceSampleLayers.h"
#include "Draw/SliceShader.h"

#include "InterlumeSliceLayerPointFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderFeatures.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace interlume
{

namespace
{
std::string GetStackName(std::size_t stack)
{
  return "stack_" + std::to_string(stack);
}
}

std::string SliceLayerPoints::Prepare(
  vtkOpenGLRenderWindow* window, const SliceSampleLayers& layers, vtkOpenGLBufferObject* vertices)
{
  std::string declarations;
  std::string sum;
  for (std::size_t i = 0; i < layers.GetStacks().size(); ++i)
  {
    const SliceSampleLayers::Stack& stack = layers.GetStacks()[i];
    declarations += "uniform sampler2D " + GetStackName(i) + ";\n";
    sum += "dark += darkOf(" + GetStackName(i) + ", " + std::to_string(stack.First) + ", " +
      std::to_string(stack.Layers) + ");\n";
  }
  std::string source = vtkShaderFeatures::Insert(
    InterlumeSliceLayerPointFS, "LAYERS=" + std::to_string(layers.GetNumberOfLayers()));
  vtkShaderProgram::Substitute(source, "//INTERLUME::STACKS", declarations);
  vtkShaderProgram::Substitute(source, "//INTERLUME::SUM", sum);
  return this->Pass.Prepare(window, source, vertices);
}

void SliceLayerPoints::Draw(vtkOpenGLRenderWindow* window, const SliceFrame& frame,
  const SlicePlan::ShadowedLight& light, const SliceSampleLayers& layers, std::size_t first,
  std::size_t count)
{
  vtkShaderProgram* program = this->Pass.GetProgram();
  window->GetShaderCache()->ReadyShaderProgram(program);
  SliceShader::SetLayerPointUniforms(program, frame, light);
  program->SetUniformf("margin", static_cast<float>(0.5 / light.BufferSize));
  for (std::size_t i = 0; i < layers.GetStacks().size(); ++i)
  {
    vtkTextureObject* texture = layers.GetStacks()[i].Texture;
    texture->Activate();
    program->SetUniformi(GetStackName(i).c_str(), texture->GetTextureUnit());
  }
  this->Pass.DrawPoints(window, first, count, 0.0);
  for (const SliceSampleLayers::Stack& stack : layers.GetStacks())
  {
    stack.Texture->Deactivate();
  }
}

}
