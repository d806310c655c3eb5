// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/CasterMaps.h"

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

CasterMaps::CasterMaps() = default;

CasterMaps::~CasterMaps() = default;

int CasterMaps::GetLargestResolution(int views, int most)
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  return std::max(std::min(static_cast<int>(limit), most) / ViewTiles::GetColumns(views), 1);
}

Error CasterMaps::Draw(vtkRenderer* renderer, const std::vector<CasterView>& views,
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
      "the graphics card has no memory for the depth maps of lights", ErrorCode::OutOfMemory);
  }
  vtkSmartPointer<vtkCamera> eye = renderer->GetActiveCamera();
  this->Depths.Draw(window, true,
    [&]()
    {
      renderer->SetActiveCamera(this->Camera);
      for (std::size_t view = 0; view < views.size(); ++view)
      {
        views[view].SetCamera(this->Camera);
        PropDepths::DrawProps(renderer, props, this->Tiles.GetTile(view));
      }
      renderer->SetActiveCamera(eye);
    });
  this->Drawn = static_cast<int>(views.size());
  this->State = std::move(state);
  return {};
}

std::string CasterMaps::GetFeatures() const
{
  return "CASTER_VIEWS=" + std::to_string(this->Tiles.GetViews().size());
}

void CasterMaps::SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPlace) const
{
  program->SetUniformi("casterDepths", this->Depths.GetTexture()->GetTextureUnit());
  this->Tiles.SetUniforms(program, "caster", worldFromPlace);
}

void CasterMaps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depths.ReleaseGraphicsResources(window);
  this->State.clear();
  this->Drawn = 0;
}

}
