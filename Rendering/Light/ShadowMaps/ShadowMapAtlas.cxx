// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowMaps/ShadowMapAtlas.h"

#include "Space/ShaderUniforms.h"

#include "vtkProp.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

namespace interlume
{

void ShadowMapAtlas::Set(const std::vector<ShadowMapView>& views, int resolution, double bias)
{
  this->Views = views;
  this->Columns = GetColumns(static_cast<int>(views.size()));
  this->Resolution = resolution;
  this->Bias = bias;
}

int ShadowMapAtlas::GetColumns(int views)
{
  return std::max(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(views)))), 1);
}

int ShadowMapAtlas::GetHeight() const
{
  const int count = static_cast<int>(this->Views.size());
  return (count + this->Columns - 1) / this->Columns * this->Resolution;
}

std::array<int, 4> ShadowMapAtlas::GetTile(std::size_t view) const
{
  const int number = static_cast<int>(view);
  return { { number % this->Columns * this->Resolution, number / this->Columns * this->Resolution,
    this->Resolution, this->Resolution } };
}

std::vector<double> ShadowMapAtlas::GetState(const std::vector<vtkProp*>& props) const
{
  std::vector<double> state{ static_cast<double>(this->Resolution) };
  for (const ShadowMapView& view : this->Views)
  {
    const double* clip = glm::value_ptr(view.ClipFromWorld);
    state.insert(state.end(), clip, clip + 16);
  }
  for (vtkProp* prop : props)
  {
    // Doubles represent addresses and modification times exactly, since both are below 2^53.
    state.push_back(static_cast<double>(reinterpret_cast<std::uintptr_t>(prop)));
    state.push_back(static_cast<double>(prop->GetRedrawMTime()));
  }
  return state;
}

void ShadowMapAtlas::SetUniforms(
  vtkShaderProgram* program, const std::string& name, const glm::dmat4& worldFromPosition) const
{
  std::vector<glm::mat4> clips;
  std::vector<glm::mat4> inverses;
  std::vector<glm::vec4> tiles;
  std::vector<glm::vec2> depths;
  for (std::size_t i = 0; i < this->Views.size(); ++i)
  {
    const ShadowMapView& view = this->Views[i];
    const glm::dmat4 clip = view.ClipFromWorld * worldFromPosition;
    clips.emplace_back(clip);
    inverses.emplace_back(glm::inverse(clip));
    const std::array<int, 4> tile = this->GetTile(i);
    tiles.emplace_back(tile[0], tile[1], this->Resolution, this->Bias);
    depths.emplace_back(view.TexelDepth[0], view.TexelDepth[1]);
  }
  std::string capital = name;
  capital[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  const ShaderUniforms uniforms(program);
  uniforms.Set(name + "FromPosition", clips);
  uniforms.Set(name + "Tiles", tiles);
  uniforms.Set("positionFrom" + capital, inverses);
  uniforms.Set(name + "Texels", depths);
}

}
