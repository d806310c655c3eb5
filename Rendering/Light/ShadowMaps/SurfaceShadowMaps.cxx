// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/SurfaceShadowMaps.h"

#include "Loader/OpenGLFunctions.h"

#include "vtkCamera.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace interlume
{

SurfaceShadowMaps::SurfaceShadowMaps() = default;

SurfaceShadowMaps::~SurfaceShadowMaps() = default;

int SurfaceShadowMaps::GetLargestResolution(int views, int maximum)
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  return std::max(
    std::min(static_cast<int>(limit), maximum) / ShadowMapAtlas::GetColumns(views), 1);
}

Error SurfaceShadowMaps::Draw(vtkRenderer* renderer, const std::vector<ShadowMapView>& views,
  const std::vector<vtkProp*>& props, int resolution, double bias)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Drawn = 0;
  this->Tiles.Set(views, resolution, bias);
  std::vector<double> state = this->Tiles.GetState(props);
  if (state == this->State && this->Depths.GetTexture()->GetHandle() != 0)
  {
    return {};
  }
  this->State.clear();
  if (!this->Depths.Allocate(window, this->Tiles.GetWidth(), this->Tiles.GetHeight()))
  {
    return Error(
      "The graphics card does not have enough memory for the shadow maps of surfaces. Reduce "
      "DepthMapResolution.",
      ErrorCode::OutOfMemory);
  }
  vtkSmartPointer<vtkCamera> camera = renderer->GetActiveCamera();
  this->Depths.Draw(window, true,
    [&]()
    {
      renderer->SetActiveCamera(this->Camera);
      for (std::size_t view = 0; view < views.size(); ++view)
      {
        views[view].SetCamera(this->Camera);
        PropDepths::DrawProps(renderer, props, this->Tiles.GetTile(view));
      }
      renderer->SetActiveCamera(camera);
    });
  this->Drawn = static_cast<int>(views.size());
  this->State = std::move(state);
  return {};
}

std::string SurfaceShadowMaps::GetFeatures() const
{
  return "OCCLUDER_VIEWS=" + std::to_string(this->Tiles.GetViews().size());
}

void SurfaceShadowMaps::SetUniforms(
  vtkShaderProgram* program, const glm::dmat4& worldFromPosition) const
{
  program->SetUniformi("occluderDepths", this->Depths.GetTexture()->GetTextureUnit());
  this->Tiles.SetUniforms(program, "occluder", worldFromPosition);
}

void SurfaceShadowMaps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depths.ReleaseGraphicsResources(window);
  this->State.clear();
  this->Drawn = 0;
}

}
