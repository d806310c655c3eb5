// SPDX-License-Identifier: BSD-3-Clause
#include "Draw/SurfaceOcclusionGrid.h"

#include "ShadowMaps/PropSurfaces.h"
#include "ShadowMaps/SceneOccluders.h"
#include "Common/Vectors.h"
#include "Grid/ExtinctionGrid.h"
#include "Grid/SurfaceVoxelizer.h"
#include "Loader/OpenGLFunctions.h"
#include "Loader/ScopedGLState.h"
#include "Offscreen/FloatTexture.h"
#include "Offscreen/ShaderFeatures.h"
#include "Receivers/SliceScene.h"
#include "Translucent/TranslucentShadowMaps.h"

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

// Computes on the GPU, one pixel per cell, the fraction of a light that surfaces transmit to each
// cell. The argument fraction is the GLSL expression to evaluate. Returns an empty array on
// failure.
std::vector<float> DrawFractions(vtkOpenGLRenderWindow* window, const SliceScene& scene,
  const ExtinctionGrid& grid, const glm::dmat4& worldFromUnit, const std::string& fraction)
{
  std::string source = InterlumeSceneCellsFS;
  vtkShaderProgram::Substitute(source, "INTERLUME_FRACTION", fraction);
  vtkShaderProgram::Substitute(source, "//INTERLUME::OCCLUDERS",
    (scene.Occluders->HasViews() ? scene.Occluders->GetSource() : std::string()) +
      (scene.TranslucentMaps ? scene.TranslucentMaps->GetSource(false) : std::string()));
  source = ShaderFeatures::Insert(
    source, (scene.Occluders->HasViews() ? scene.Occluders->GetFeatures() : std::string()));
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
    const ScopedGLState scoped(state);
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
    for (const auto& [name, map] : scene.Occluders->GetTextures())
    {
      activate(name, map);
    }
    if (scene.TranslucentMaps)
    {
      activate("translucentLayers", scene.TranslucentMaps->GetTexture());
      scene.TranslucentMaps->SetUniforms(quad.Program, worldFromUnit);
    }
    scene.Occluders->SetUniforms(quad.Program, worldFromUnit);
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
  // Restore the bindings before deleting the bound framebuffer. Otherwise VTK's cached state would
  // differ from the state of OpenGL.
  state->PopFramebufferBindings();
  framebuffer->ReleaseGraphicsResources(window);
  texture->ReleaseGraphicsResources(window);
  quad.ReleaseGraphicsResources(window);
  return values;
}
}

vtkMTimeType SurfaceOcclusionGrid::GetTime(const SliceScene* scene)
{
  if (!scene || !scene->Occluders)
  {
    return 0;
  }
  const bool hasTranslucentShadows =
    scene->TranslucentMaps && scene->TranslucentMaps->GetLayers() > 0;
  return std::max(scene->Occluders->HasViews() ? scene->Occluders->GetDrawTime() : 0,
    hasTranslucentShadows ? scene->TranslucentMaps->GetDrawTime() : 0);
}

void SurfaceOcclusionGrid::Block(
  const SliceScene& scene, const glm::dmat4& worldFromUnit, ExtinctionGrid& grid)
{
  for (const PropSurfaces::Surface& surface : PropSurfaces::Get(scene.Blockers))
  {
    SurfaceVoxelizer::Mark(surface.Corners, surface.Planes, worldFromUnit, grid);
  }
}

Error SurfaceOcclusionGrid::Make(vtkOpenGLRenderWindow* window, const SliceScene& scene,
  const ExtinctionGrid& grid, const glm::dmat4& worldFromUnit,
  const std::vector<LightSource>& lights, std::vector<std::vector<glm::vec3>>& transmitted)
{
  transmitted.assign(lights.size(), {});
  const std::size_t cells = grid.GetMedium().GetNumberOfCells();
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const std::string opaque = scene.Occluders->HasViews()
      ? scene.Occluders->GetLightFraction(lights[i].Light, "place", "vec4(0.0)")
      : std::string();
    const std::string translucent = scene.TranslucentMaps && scene.TranslucentMaps->GetLayers() > 0
      ? scene.TranslucentMaps->GetLightFraction(lights[i].Light, "place", "vec4(0.0)")
      : std::string();
    if (opaque.empty() && translucent.empty())
    {
      continue;
    }
    const std::string fraction =
      opaque + (opaque.empty() || translucent.empty() ? "" : "*") + translucent;
    const std::vector<float> values = DrawFractions(window, scene, grid, worldFromUnit, fraction);
    if (values.size() < 4 * cells)
    {
      return Error("The shadows of surfaces in scattered light could not be rendered, because a "
                   "shader or texture could not be created.",
        ErrorCode::OpenGL);
    }
    for (std::size_t cell = 0; cell < cells; ++cell)
    {
      transmitted[i].push_back(glm::make_vec3(values.data() + 4 * cell));
    }
  }
  return {};
}

}
