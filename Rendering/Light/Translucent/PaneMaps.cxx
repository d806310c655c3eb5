// SPDX-License-Identifier: BSD-3-Clause
#include "Translucent/PaneMaps.h"

#include "Loader/OpenGLFunctions.h"
#include "Offscreen/ShaderFeatures.h"
#include "Translucent/LayerShader.h"

#include "InterlumeScenePanes.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace interlume
{

PaneMaps::PaneMaps() = default;

PaneMaps::~PaneMaps() = default;

Error PaneMaps::Draw(vtkRenderer* renderer, const CasterViews& views,
  const std::vector<vtkProp*>& props, int resolution, double bias, std::size_t most,
  LayerShader& shader)
{
  this->Views = views;
  this->Tiles.Set(views.GetViews(), resolution, bias);
  std::vector<double> state = this->Tiles.GetState(props);
  state.push_back(static_cast<double>(most));
  if (state == this->State)
  {
    return {};
  }
  this->Clear(renderer->GetRenderWindow());
  this->DrawTime.Modified();
  if (Error error = this->DrawLayers(renderer, props, most, shader))
  {
    return error;
  }
  this->State = std::move(state);
  return {};
}

Error PaneMaps::DrawLayers(
  vtkRenderer* renderer, const std::vector<vtkProp*>& props, std::size_t most, LayerShader& shader)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const int width = this->Tiles.GetWidth();
  const int height = this->Tiles.GetHeight();
  vtkSmartPointer<vtkCamera> eye = renderer->GetActiveCamera();
  const auto draw = [&]()
  {
    renderer->SetActiveCamera(this->Camera);
    for (std::size_t view = 0; view < this->Views.GetViews().size(); ++view)
    {
      this->Views.GetViews()[view].SetCamera(this->Camera);
      LayerShader::DrawProps(renderer, props, this->Tiles.GetTile(view));
    }
    renderer->SetActiveCamera(eye);
  };
  const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  // Layers lie above each other in one texture.
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  most = std::min(most, static_cast<std::size_t>(std::max(static_cast<int>(limit) / height, 1)));
  DepthLayers depths;
  Error error = depths.Peel(window, width, std::vector<float>(texels, 1.0F), most, shader, draw);
  const std::vector<float> whole(texels, 1.0F);
  std::vector<float> through = whole;
  std::vector<float> values;
  vtkNew<vtkTextureObject> share;
  for (const DepthLayers::Layer& layer : depths.Get())
  {
    if (error || !LayerTarget::Upload(window, share, width, height, 1, whole))
    {
      break;
    }
    layer.Texture->Activate();
    shader.Begin(layer.HasRest ? LayerShader::WEAKEN_REST : LayerShader::WEAKEN, layer.Texture);
    this->Target.Draw(window, share, LayerTarget::PRODUCT, draw);
    shader.Begin(LayerShader::SHOW);
    layer.Texture->Deactivate();
    const std::vector<float> shares = LayerTarget::Read(share);
    for (std::size_t i = 0; i < texels; ++i)
    {
      through[i] *= shares[i];
      values.push_back(layer.Depths[i]);
      values.push_back(through[i]);
    }
  }
  const auto layers = static_cast<int>(depths.Get().size());
  share->ReleaseGraphicsResources(window);
  depths.ReleaseGraphicsResources(window);
  if (layers > 0 && !error &&
    (values.size() != 2 * texels * static_cast<std::size_t>(layers) ||
      !LayerTarget::Upload(window, this->Texture, width, layers * height, 2, values)))
  {
    error = Error("the graphics card has no memory for the light behind translucent surfaces",
      ErrorCode::OutOfMemory);
  }
  this->Layers = error ? 0 : layers;
  return error;
}

void PaneMaps::Clear(vtkWindow* window)
{
  this->Layers = 0;
  this->State.clear();
  this->Texture->ReleaseGraphicsResources(window);
}

vtkIdType PaneMaps::GetBytes() const
{
  return static_cast<vtkIdType>(2 * sizeof(float)) * this->Layers * this->Tiles.GetWidth() *
    this->Tiles.GetHeight();
}

std::string PaneMaps::GetSource(bool hasPlanes) const
{
  if (this->Layers == 0)
  {
    return {};
  }
  std::string features = "//INTERLUME::FEATURES\n";
  return ShaderFeatures::Insert(features + InterlumeScenePanes,
    "PANE_VIEWS=" + std::to_string(this->Views.GetViews().size()) +
      " PANE_LAYERS=" + std::to_string(this->Layers) + (hasPlanes ? " PANE_PLANES" : ""));
}

std::string PaneMaps::GetShare(
  vtkLight* light, const std::string& place, const std::string& plane) const
{
  const CasterViews::Light* seen = this->Layers > 0 ? this->Views.Find(light) : nullptr;
  return seen ? "lightOfPanes(" + std::to_string(seen->FirstView) + ", " +
      std::to_string(seen->Views) + ", " + place + ", " + plane + ")"
              : std::string();
}

void PaneMaps::SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPlace) const
{
  if (!program->IsUniformUsed("paneLayers"))
  {
    return;
  }
  program->SetUniformi("paneLayers", this->Texture->GetTextureUnit());
  program->SetUniformi("paneRows", this->Tiles.GetHeight());
  this->Tiles.SetUniforms(program, "pane", worldFromPlace);
}

void PaneMaps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Clear(window);
  this->Target.ReleaseGraphicsResources(window);
}

}
