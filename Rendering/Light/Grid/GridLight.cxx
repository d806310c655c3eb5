// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/GridLight.h"

#include "Grid/ExtinctionGrid.h"
#include "Lights/EmitterSamples.h"
#include "Scattering/CellLight.h"
#include "Space/UnitVector.h"

#include "vtkProjectiveLight.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace interlume
{

namespace
{
// The light of a source without extent in the cells of a grid, before attenuation by the medium.
class GridColor
{
public:
  GridColor(const ExtinctionGrid& grid, const LightSource& light)
    : Grid(grid)
    , Light(light)
    , IsPositional(light.IsPositional)
  {
  }

  /// Returns the mean of the light at the centers of a cell's eight octants.
  glm::dvec3 Get(const glm::ivec3& cell) const
  {
    if (!this->IsPositional && !this->Light.Projective)
    {
      return this->Light.Diffuse;
    }
    const glm::dvec3& size = this->Grid.GetMedium().CellSize;
    glm::dvec3 sum(0.0);
    for (unsigned part = 0; part < 8; ++part)
    {
      const glm::dvec3 offset(
        part & 1u ? 0.25 : -0.25, part & 2u ? 0.25 : -0.25, part & 4u ? 0.25 : -0.25);
      sum += this->GetColorAt(this->Grid.ToUnit(this->Grid.GetCellCenter(cell) + offset * size));
    }
    return 0.125 * sum * this->Light.Diffuse;
  }

private:
  glm::dvec3 GetColorAt(const glm::dvec3& position) const
  {
    glm::dvec3 color(1.0);
    if (this->IsPositional)
    {
      const glm::dvec3 fromLight = position - this->Light.Position;
      const double distance = std::max(
        glm::length(fromLight), 0.25 * Vectors::InfinityNorm(this->Grid.GetMedium().CellSize));
      const glm::dvec3& attenuation = this->Light.Attenuation;
      const double fall = attenuation.x + distance * (attenuation.y + distance * attenuation.z);
      color /= fall;
      if (this->Light.ConeCosine > -1.0)
      {
        const double cosine =
          glm::dot(UnitVector::Normalize(fromLight, this->Light.Direction), this->Light.Direction);
        color *= cosine < this->Light.ConeCosine ? 0.0 : std::pow(cosine, this->Light.Exponent);
      }
    }
    if (this->Light.Projective)
    {
      const glm::dvec4 seen = this->Light.ScreenFromUnit * glm::dvec4(position, 1.0);
      glm::dvec3 screen(0.0);
      if (seen.w > 0.0)
      {
        this->Light.Projective->GetScreenColor(
          seen.x / seen.w, seen.y / seen.w, glm::value_ptr(screen));
      }
      color *= screen;
    }
    return Vectors::IsFinite(color) ? glm::max(color, 0.0) : glm::dvec3(0.0);
  }

  const ExtinctionGrid& Grid;
  const LightSource& Light;
  bool IsPositional;
};

ScatteringLight TransformLight(const ExtinctionGrid& grid, const LightSource& light)
{
  ScatteringLight result;
  result.IsPositional = light.IsPositional;
  result.Position = grid.FromUnit(light.Position);
  result.Direction = grid.DirectionFromUnit(light.Direction);
  return result;
}
}

ScatteringLight GridLight::Make(const ExtinctionGrid& grid, const LightSource& light, int samples)
{
  const ScatteringMedium& medium = grid.GetMedium();
  ScatteringLight result = TransformLight(grid, light);
  std::vector<LightSource> sources{ light };
  if (light.Area)
  {
    sources = EmitterSamples::Split(sources, { 0 }, samples);
  }
  // With many samples, one ray per cell face is enough if each sample has a different ray offset.
  const bool hasFewSamples = sources.size() < 4;
  const std::size_t cells = medium.GetNumberOfCells();
  result.Direct.assign(cells, glm::vec3(0.0f));
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    const double number = static_cast<double>(i);
    const glm::dvec2 offset = hasFewSamples
      ? glm::dvec2(0.0)
      : glm::fract(number * glm::dvec2(0.7548776662, 0.5698402910)) - 0.5;
    const std::vector<glm::vec3> means =
      CellLight::Find(medium, grid.GetColorFractions(), TransformLight(grid, sources[i]),
        hasFewSamples ? CellLight::GetRaysPerEdge(medium.Cells) : 1, offset);
    const GridColor color(grid, sources[i]);
    vtkSMPTools::For(0, static_cast<vtkIdType>(cells),
      [&](vtkIdType first, vtkIdType last)
      {
        for (auto cell = static_cast<std::size_t>(first); cell < static_cast<std::size_t>(last);
             ++cell)
        {
          const glm::dvec3 transmittance = light.ShadowStrength * glm::dvec3(means[cell]);
          result.Direct[cell] += glm::vec3(transmittance * color.Get(grid.GetCell(cell)));
        }
      });
  }
  return result;
}

}
