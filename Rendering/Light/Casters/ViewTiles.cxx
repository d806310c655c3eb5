// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/ViewTiles.h"

#include "vtkProp.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>

#include <glm/gtc/type_ptr.hpp>

namespace interlume
{

namespace
{
// Appends a matrix in single precision.
void Add(std::vector<float>& values, const glm::dmat4& matrix)
{
  const glm::mat4 rounded(matrix);
  values.insert(values.end(), glm::value_ptr(rounded), glm::value_ptr(rounded) + 16);
}
}

void ViewTiles::Set(const std::vector<CasterView>& views, int resolution, double bias)
{
  this->Views = views;
  this->Columns = GetColumns(static_cast<int>(views.size()));
  this->Resolution = resolution;
  this->Bias = bias;
}

int ViewTiles::GetColumns(int views)
{
  return std::max(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(views)))), 1);
}

int ViewTiles::GetHeight() const
{
  const int count = static_cast<int>(this->Views.size());
  return (count + this->Columns - 1) / this->Columns * this->Resolution;
}

std::array<int, 4> ViewTiles::GetTile(std::size_t view) const
{
  const int number = static_cast<int>(view);
  return { { number % this->Columns * this->Resolution, number / this->Columns * this->Resolution,
    this->Resolution, this->Resolution } };
}

std::vector<double> ViewTiles::GetState(const std::vector<vtkProp*>& props) const
{
  std::vector<double> state{ static_cast<double>(this->Resolution) };
  for (const CasterView& view : this->Views)
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

void ViewTiles::SetUniforms(
  vtkShaderProgram* program, const std::string& name, const glm::dmat4& worldFromPlace) const
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
    const std::array<int, 4> tile = this->GetTile(i);
    tiles.insert(tiles.end(),
      { static_cast<float>(tile[0]), static_cast<float>(tile[1]),
        static_cast<float>(this->Resolution), static_cast<float>(this->Bias) });
    depths.insert(depths.end(),
      { static_cast<float>(view.TexelDepth[0]), static_cast<float>(view.TexelDepth[1]) });
  }
  std::string capital = name;
  capital[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  const std::string inverse = "placeFrom" + capital;
  const std::string texels = name + "Texels";
  const int count = static_cast<int>(this->Views.size());
  program->SetUniformMatrix4x4v((name + "FromPlace").c_str(), count, clips.data());
  program->SetUniform4fv((name + "Tiles").c_str(), count, tiles.data());
  if (program->IsUniformUsed(inverse.c_str()))
  {
    program->SetUniformMatrix4x4v(inverse.c_str(), count, inverses.data());
  }
  if (program->IsUniformUsed(texels.c_str()))
  {
    program->SetUniform2fv(texels.c_str(), count, depths.data());
  }
}

}
