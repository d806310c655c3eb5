// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SurfaceOcclusionGrid.h"

#include "Casters/PropSurfaces.h"
#include "Casters/SceneCasters.h"
#include "Common/Vectors.h"
#include "Grid/MatterGrid.h"
#include "Grid/SurfaceCells.h"
#include "Loader/OpenGLFunctions.h"
#include "Loader/ScopedState.h"
#include "Offscreen/FloatTexture.h"
#include "Offscreen/ShaderFeatures.h"
#include "Receivers/SliceScene.h"
#include "Translucent/PaneMaps.h"

#include "InterlumeSceneCellsFS.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>

namespace interlume
{

namespace
{
constexpr int Columns = 1024;

// Draws the shares of a light, for so many cells, into rows of pixels. Returns them, or nothing
// where that fails.
std::vector<float> DrawShares(vtkOpenGLRenderWindow* window, const SliceScene& scene,
  const MatterGrid& grid, const glm::dmat4& worldFromUnit, const std::string& share)
{
  std::string source = InterlumeSceneCellsFS;
  vtkShaderProgram::Substitute(source, "INTERLUME_SHARE", share);
  vtkShaderProgram::Substitute(source, "//INTERLUME::CASTERS",
    (scene.Casters->HasViews() ? scene.Casters->GetSource() : std::string()) +
      (scene.Panes ? scene.Panes->GetSource(false) : std::string()));
  source = ShaderFeatures::Insert(
    source, (scene.Casters->HasViews() ? scene.Casters->GetFeatures() : std::string()));
  vtkOpenGLQuadHelper quad(window, nullptr, source.c_str(), nullptr);
  if (!quad.Program)
  {
    return {};
  }
  const ScatteringMedium& medium = grid.GetMedium();
  const int rows =
    static_cast<int>((medium.GetNumberOfCells() + Columns - 1) / static_cast<std::size_t>(Columns));
  vtkNew<vtkTextureObject> texture;
  if (FloatTexture::Allocate(window, texture, Columns, rows, 4, false) == 0)
  {
    return {};
  }
  vtkOpenGLState* state = window->GetState();
  std::vector<float> values(static_cast<std::size_t>(4) * Columns * static_cast<std::size_t>(rows));
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
  state->PushFramebufferBindings();
  {
    const ScopedState scoped(state);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDisable(GL_CULL_FACE);
    state->vtkglDisable(GL_SCISSOR_TEST);
    framebuffer->SetContext(window);
    framebuffer->Bind();
    framebuffer->AddColorAttachment(0, texture);
    framebuffer->ActivateDrawBuffer(0);
    framebuffer->ActivateReadBuffer(0);
    state->vtkglViewport(0, 0, Columns, rows);
    std::vector<vtkTextureObject*> active;
    const auto activate = [&](const char* name, vtkTextureObject* map)
    {
      if (quad.Program->IsUniformUsed(name))
      {
        map->Activate();
        quad.Program->SetUniformi(name, map->GetTextureUnit());
        active.push_back(map);
      }
    };
    for (const auto& [name, map] : scene.Casters->GetTextures())
    {
      activate(name, map);
    }
    if (scene.Panes)
    {
      activate("paneLayers", scene.Panes->GetTexture());
      scene.Panes->SetUniforms(quad.Program, worldFromUnit);
    }
    scene.Casters->SetUniforms(quad.Program, worldFromUnit);
    glm::dmat4 unitFromCell(1.0);
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 edge(0.0);
      edge[axis] = medium.CellSize[axis];
      unitFromCell[axis] = glm::dvec4(grid.DirectionToUnit(edge), 0.0);
    }
    unitFromCell[3] = glm::dvec4(grid.ToUnit(glm::dvec3(0.0)), 1.0);
    glm::mat4 rounded(unitFromCell);
    quad.Program->SetUniformMatrix4x4("unitFromCell", glm::value_ptr(rounded));
    const std::array<float, 4> columns{ { static_cast<float>(medium.Cells.x),
      static_cast<float>(medium.Cells.y), static_cast<float>(Columns), static_cast<float>(rows) } };
    quad.Program->SetUniform4f("cellColumns", columns.data());
    quad.Render();
    glReadPixels(0, 0, Columns, rows, GL_RGBA, GL_FLOAT, values.data());
    for (vtkTextureObject* map : active)
    {
      map->Deactivate();
    }
  }
  // While it is bound, what VTK's state knows of it would be wrong afterwards.
  state->PopFramebufferBindings();
  framebuffer->ReleaseGraphicsResources(window);
  texture->ReleaseGraphicsResources(window);
  quad.ReleaseGraphicsResources(window);
  return values;
}
}

vtkMTimeType SurfaceOcclusionGrid::GetTime(const SliceScene* scene)
{
  if (!scene || !scene->Casters)
  {
    return 0;
  }
  const bool hasPanes = scene->Panes && scene->Panes->GetLayers() > 0;
  return std::max(scene->Casters->HasViews() ? scene->Casters->GetDrawTime() : 0,
    hasPanes ? scene->Panes->GetDrawTime() : 0);
}

void SurfaceOcclusionGrid::Block(
  const SliceScene& scene, const glm::dmat4& worldFromUnit, MatterGrid& grid)
{
  for (const PropSurfaces::Surface& surface : PropSurfaces::Get(scene.Blockers))
  {
    SurfaceCells::Mark(surface.Corners, surface.Planes, worldFromUnit, grid);
  }
}

Error SurfaceOcclusionGrid::Make(vtkOpenGLRenderWindow* window, const SliceScene& scene,
  const MatterGrid& grid, const glm::dmat4& worldFromUnit, const std::vector<LightSource>& lights,
  std::vector<std::vector<glm::vec3>>& shares)
{
  shares.assign(lights.size(), {});
  const std::size_t cells = grid.GetMedium().GetNumberOfCells();
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const std::string opaque = scene.Casters->HasViews()
      ? scene.Casters->GetShare(lights[i].Light, "place", "vec4(0.0)")
      : std::string();
    const std::string panes = scene.Panes && scene.Panes->GetLayers() > 0
      ? scene.Panes->GetShare(lights[i].Light, "place", "vec4(0.0)")
      : std::string();
    if (opaque.empty() && panes.empty())
    {
      continue;
    }
    const std::string share = opaque + (opaque.empty() || panes.empty() ? "" : "*") + panes;
    const std::vector<float> values = DrawShares(window, scene, grid, worldFromUnit, share);
    if (values.size() < 4 * cells)
    {
      return Error("the shadows of surfaces in scattered light cannot be drawn", ErrorCode::OpenGL);
    }
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      shares[i].push_back(glm::make_vec3(values.data() + 4 * cell));
    }
  }
  return {};
}

}
