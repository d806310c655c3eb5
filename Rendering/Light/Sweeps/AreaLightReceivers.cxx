// SPDX-License-Identifier: BSD-3-Clause
#include "Sweeps/AreaLightReceivers.h"

#include "Buffers/EmitterSampleLayers.h"
#include "ShadowMaps/SceneOccluders.h"
#include "Offscreen/ShaderFeatures.h"
#include "Receivers/SliceScene.h"
#include "Shaders/SliceShader.h"
#include "Shaders/VolumeRenderState.h"

#include "InterlumeSliceLayerPointFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace interlume
{

namespace
{
/// Bias, in texels, for surfaces whose plane is unknown. Without it, self-shadowing would add noise
/// to the mean transmittance.
constexpr double UNKNOWN_PLANE = 8.0;

std::string GetStackName(std::size_t stack)
{
  return "stack_" + std::to_string(stack);
}
}

Error AreaLightReceivers::Prepare(vtkOpenGLRenderWindow* window, const VolumeRenderState& frame,
  const SlicePlan::ShadowedLight& light, const EmitterSampleLayers& layers,
  vtkOpenGLBufferObject* vertices)
{
  const SceneOccluders& occluders = *frame.Image->Scene->Occluders;
  const std::string visibility =
    occluders.GetSampleLightFraction(frame.Image->Lights[light.Light].Light,
      layers.GetNumberOfLayers(), "layer", "place", "vec4(0.0)");
  this->HasOccluders = !visibility.empty();
  std::string declarations;
  std::string sum;
  for (std::size_t i = 0; i < layers.GetStacks().size(); ++i)
  {
    const EmitterSampleLayers::Stack& stack = *layers.GetStacks()[i];
    declarations += "uniform sampler2D " + GetStackName(i) + ";\n";
    sum += "  addLayers(" + GetStackName(i) + ", " + std::to_string(stack.First) + ", " +
      std::to_string(stack.Layers) + ");\n";
  }
  std::string features = "LAYERS=" + std::to_string(layers.GetNumberOfLayers());
  features +=
    this->HasOccluders ? " SAMPLE_FRACTION=" + visibility + " " + occluders.GetFeatures() : "";
  std::string source = ShaderFeatures::Insert(InterlumeSliceLayerPointFS, features);
  vtkShaderProgram::Substitute(
    source, "//INTERLUME::OCCLUDERS", this->HasOccluders ? occluders.GetSource() : "");
  vtkShaderProgram::Substitute(source, "//INTERLUME::STACKS", declarations);
  vtkShaderProgram::Substitute(source, "//INTERLUME::SUM", sum);
  return this->Pass.Prepare(window, source, vertices);
}

void AreaLightReceivers::Draw(vtkOpenGLRenderWindow* window, const VolumeRenderState& frame,
  const SlicePlan::ShadowedLight& light, const EmitterSampleLayers& layers, std::size_t first,
  std::size_t count)
{
  vtkShaderProgram* program = this->Pass.GetProgram();
  window->GetShaderCache()->ReadyShaderProgram(program);
  SliceShader::SetLayerPointUniforms(program, frame, light);
  program->SetUniformf("margin", static_cast<float>(0.5 / layers.GetLayerSize()));
  for (std::size_t i = 0; i < layers.GetStacks().size(); ++i)
  {
    vtkTextureObject* texture = layers.GetStacks()[i]->Texture;
    texture->Activate();
    program->SetUniformi(GetStackName(i).c_str(), texture->GetTextureUnit());
  }
  std::vector<vtkTextureObject*> maps;
  if (this->HasOccluders)
  {
    const SceneOccluders& occluders = *frame.Image->Scene->Occluders;
    for (const auto& [name, map] : occluders.GetTextures())
    {
      if (program->IsUniformUsed(name) && map->GetTextureUnit() < 0)
      {
        map->Activate();
        maps.push_back(map);
      }
    }
    occluders.SetUniforms(program, frame.Space.GetWorldFromUnit());
    occluders.AddBias(program, UNKNOWN_PLANE);
  }
  this->Pass.DrawPoints(window, first, count, 0.0);
  for (vtkTextureObject* map : maps)
  {
    map->Deactivate();
  }
  for (const std::unique_ptr<EmitterSampleLayers::Stack>& stack : layers.GetStacks())
  {
    stack->Texture->Deactivate();
  }
}

}
