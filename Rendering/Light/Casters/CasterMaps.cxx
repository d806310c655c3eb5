// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/CasterMaps.h"

#include "Loader/OpenGLFunctions.h"

#include "vtkCamera.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"

#include <cmath>
#include <cstdint>

namespace interlume
{

namespace
{
int CountColumns(int views)
{
  return std::max(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(views)))), 1);
}

// Appends a matrix in single precision.
void Add(std::vector<float>& values, const glm::dmat4& matrix)
{
  const glm::mat4 rounded(matrix);
  values.insert(values.end(), glm::value_ptr(rounded), glm::value_ptr(rounded) + 16);
}

// Returns all that the maps depend on.
std::vector<double> GetState(
  const std::vector<CasterView>& views, const std::vector<vtkProp*>& props, int resolution)
{
  std::vector<double> state{ static_cast<double>(resolution) };
  for (const CasterView& view : views)
  {
    const double* clip = glm::value_ptr(view.ClipFromWorld);
    state.insert(state.end(), clip, clip + 16);
  }
  for (vtkProp* prop : props)
  {
    // Doubles have all digits of addresses and times that occur.
    state.push_back(static_cast<double>(reinterpret_cast<std::uintptr_t>(prop)));
    state.push_back(static_cast<double>(prop->GetRedrawMTime()));
  }
  return state;
}
}

CasterMaps::CasterMaps() = default;

CasterMaps::~CasterMaps() = default;

int CasterMaps::GetLargestResolution(int views, int most)
{
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  return std::max(std::min(static_cast<int>(limit), most) / CountColumns(views), 1);
}

std::array<int, 2> CasterMaps::GetTile(int view) const
{
  return { { view % this->Columns * this->Resolution, view / this->Columns * this->Resolution } };
}

std::string CasterMaps::Draw(vtkRenderer* renderer, const std::vector<CasterView>& views,
  const std::vector<vtkProp*>& props, int resolution, double bias)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Drawn = 0;
  this->Views = views;
  this->Bias = bias;
  this->Resolution = resolution;
  const int count = static_cast<int>(this->Views.size());
  this->Columns = CountColumns(count);
  const int rows = (count + this->Columns - 1) / this->Columns;
  std::vector<double> state = GetState(views, props, resolution);
  if (state == this->State && this->Depths.GetTexture()->GetHandle() != 0)
  {
    return {};
  }
  this->State.clear();
  if (!this->Depths.Allocate(window, this->Columns * resolution, rows * resolution))
  {
    return "the graphics card has no memory for the depth maps of lights";
  }
  vtkSmartPointer<vtkCamera> eye = renderer->GetActiveCamera();
  this->Depths.Draw(window, true,
    [&]()
    {
      renderer->SetActiveCamera(this->Camera);
      for (int view = 0; view < count; ++view)
      {
        this->Views[view].SetCamera(this->Camera);
        const std::array<int, 2> tile = this->GetTile(view);
        PropDepths::DrawProps(renderer, props, { { tile[0], tile[1], resolution, resolution } });
      }
      renderer->SetActiveCamera(eye);
    });
  this->Drawn = count;
  this->State = std::move(state);
  return {};
}

std::string CasterMaps::GetFeatures() const
{
  return "CASTER_VIEWS=" + std::to_string(this->Views.size());
}

void CasterMaps::SetUniforms(vtkShaderProgram* program, const glm::dmat4& worldFromPlace) const
{
  std::vector<float> clips;
  std::vector<float> inverses;
  std::vector<float> tiles;
  std::vector<float> depths;
  for (std::size_t i = 0; i < this->Views.size(); ++i)
  {
    const CasterView& view = this->Views[i];
    const glm::dmat4 clip = view.ClipFromWorld * worldFromPlace;
    Add(clips, clip);
    Add(inverses, glm::inverse(clip));
    const std::array<int, 2> tile = this->GetTile(static_cast<int>(i));
    tiles.insert(tiles.end(),
      { static_cast<float>(tile[0]), static_cast<float>(tile[1]),
        static_cast<float>(this->Resolution), static_cast<float>(this->Bias) });
    depths.insert(depths.end(),
      { static_cast<float>(view.TexelDepth[0]), static_cast<float>(view.TexelDepth[1]) });
  }
  const int count = static_cast<int>(this->Views.size());
  program->SetUniformi("casterDepths", this->Depths.GetTexture()->GetTextureUnit());
  program->SetUniformMatrix4x4v("casterFromPlace", count, clips.data());
  if (program->IsUniformUsed("placeFromCaster"))
  {
    program->SetUniformMatrix4x4v("placeFromCaster", count, inverses.data());
  }
  program->SetUniform4fv("casterTiles", count, tiles.data());
  program->SetUniform2fv("casterTexels", count, depths.data());
}

void CasterMaps::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Depths.ReleaseGraphicsResources(window);
  this->State.clear();
  this->Drawn = 0;
}

}
