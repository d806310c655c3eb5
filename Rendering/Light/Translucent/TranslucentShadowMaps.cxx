// SPDX-License-Identifier: BSD-3-Clause
#include "Translucent/TranslucentShadowMaps.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/ShaderFeatures.h"
#include "Translucent/LayerShader.h"

#include "InterlumeTranslucentShadows.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace interlume
{

TranslucentShadowMaps::TranslucentShadowMaps() = default;

TranslucentShadowMaps::~TranslucentShadowMaps() = default;

Error TranslucentShadowMaps::Draw(vtkRenderer* renderer, const ShadowMapViews& views,
  const std::vector<vtkProp*>& props, int resolution, double bias, std::size_t maximum,
  LayerShader& shader)
{
  this->Views = views;
  this->Tiles.Set(views.GetViews(), resolution, bias);
  std::vector<double> state = this->Tiles.GetState(props);
  state.push_back(static_cast<double>(maximum));
  if (state == this->State)
  {
    return {};
  }
  this->Clear(renderer->GetRenderWindow());
  this->DrawTime.Modified();
  if (Error error = this->DrawLayers(renderer, props, maximum, shader))
  {
    return error;
  }
  this->State = std::move(state);
  return {};
}

Error TranslucentShadowMaps::DrawLayers(vtkRenderer* renderer, const std::vector<vtkProp*>& props,
  std::size_t maximum, LayerShader& shader)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const int width = this->Tiles.GetWidth();
  const int height = this->Tiles.GetHeight();
  vtkSmartPointer<vtkCamera> camera = renderer->GetActiveCamera();
  const auto draw = [&]()
  {
    renderer->SetActiveCamera(this->Camera);
    for (std::size_t view = 0; view < this->Views.GetViews().size(); ++view)
    {
      this->Views.GetViews()[view].SetCamera(this->Camera);
      LayerShader::DrawProps(renderer, props, this->Tiles.GetTile(view));
    }
    renderer->SetActiveCamera(camera);
  };
  const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  // Layers are stacked vertically in one texture.
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  maximum =
    std::min(maximum, static_cast<std::size_t>(std::max(static_cast<int>(limit) / height, 1)));
  DepthLayers depths;
  Error error = depths.Peel(window, width, std::vector<float>(texels, 1.0F), maximum, shader, draw);
  const std::vector<float> ones(texels, 1.0F);
  std::vector<float> through = ones;
  std::vector<float> values;
  vtkNew<vtkTextureObject> transmittance;
  for (const DepthLayers::Layer& layer : depths.Get())
  {
    if (error || !LayerTarget::Upload(window, transmittance, width, height, 1, ones))
    {
      break;
    }
    layer.Texture->Activate();
    shader.Begin(layer.HasRest ? LayerShader::WEAKEN_REST : LayerShader::WEAKEN, layer.Texture);
    this->Target.Draw(window, transmittance, LayerTarget::PRODUCT, draw);
    shader.Begin(LayerShader::SHOW);
    layer.Texture->Deactivate();
    const std::vector<float> transmittances = LayerTarget::Read(transmittance);
    for (std::size_t i = 0; i < texels; ++i)
    {
      through[i] *= transmittances[i];
      values.push_back(layer.Depths[i]);
      values.push_back(through[i]);
    }
  }
  const auto layers = static_cast<int>(depths.Get().size());
  transmittance->ReleaseGraphicsResources(window);
  depths.ReleaseGraphicsResources(window);
  if (layers > 0 && !error &&
    (values.size() != 2 * texels * static_cast<std::size_t>(layers) ||
      !LayerTarget::Upload(window, this->Texture, width, layers * height, 2, values)))
  {
    error = Error("The graphics card does not have enough memory for the shadow maps of "
                  "translucent surfaces. Reduce DepthMapResolution or MaximumNumberOfLayers.",
      ErrorCode::OutOfMemory);
  }
  this->Layers = error ? 0 : layers;
  return error;
}

void TranslucentShadowMaps::Clear(vtkWindow* window)
{
  this->Layers = 0;
  this->State.clear();
  this->Texture->ReleaseGraphicsResources(window);
}

vtkIdType TranslucentShadowMaps::GetBytes() const
{
  return static_cast<vtkIdType>(2 * sizeof(float)) * this->Layers * this->Tiles.GetWidth() *
    this->Tiles.GetHeight();
}

std::string TranslucentShadowMaps::GetSource(bool hasPlanes) const
{
  if (this->Layers == 0)
  {
    return {};
  }
  std::string features = "//INTERLUME::FEATURES\n";
  return ShaderFeatures::Insert(features + InterlumeTranslucentShadows,
    "TRANSLUCENT_VIEWS=" + std::to_string(this->Views.GetViews().size()) + " TRANSLUCENT_LAYERS=" +
      std::to_string(this->Layers) + (hasPlanes ? " TRANSLUCENT_PLANES" : ""));
}

std::string TranslucentShadowMaps::GetLightFraction(
  vtkLight* light, const std::string& position, const std::string& plane) const
{
  const ShadowMapViews::Light* seen = this->Layers > 0 ? this->Views.Find(light) : nullptr;
  return seen ? "lightOfTranslucentLayers(" + std::to_string(seen->FirstView) + ", " +
      std::to_string(seen->Views) + ", " + position + ", " + plane + ")"
              : std::string();
}

void TranslucentShadowMaps::SetUniforms(
  vtkShaderProgram* program, const glm::dmat4& worldFromPosition) const
{
  if (!program->IsUniformUsed("translucentLayers"))
  {
    return;
  }
  program->SetUniformi("translucentLayers", this->Texture->GetTextureUnit());
  program->SetUniformi("translucentRows", this->Tiles.GetHeight());
  this->Tiles.SetUniforms(program, "translucent", worldFromPosition);
}

void TranslucentShadowMaps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Clear(window);
  this->Target.ReleaseGraphicsResources(window);
}

}
