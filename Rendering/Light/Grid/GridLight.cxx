// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/GridLight.h"

#include "Grid/MatterGrid.h"
#include "Lights/EmitterSamples.h"
#include "Space/UnitVector.h"

#include "vtkProjectiveLight.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace interlume
{

namespace
{
// A light of one place or direction, in the box of the grid.
class GridRay
{
public:
  GridRay(const MatterGrid& grid, const LightSource& light)
    : Grid(grid)
    , Light(light)
    , IsPositional(light.IsPositional)
    , Position(grid.FromUnit(light.Position))
    , Direction(grid.DirectionFromUnit(light.Direction))
  {
  }

  /// Returns the mean transmittance of a cell along the ray through its middle.
  glm::dvec3 GetTransmittance(const glm::ivec3& cell) const
  {
    const ScatteringMedium& medium = this->Grid.GetMedium();
    const glm::dvec3 middle = this->Grid.GetMiddle(cell);
    const glm::dvec3 way = this->IsPositional ? this->Position - middle : -this->Direction;
    const double length = glm::length(way);
    if (!(length > 0.0))
    {
      return glm::dvec3(1.0);
    }
    const glm::dvec3 toLight = way / length;
    const double reach = this->IsPositional ? length : std::numeric_limits<double>::max();
    // How far the ray is from the next border along each axis, and from border to border.
    glm::dvec3 next;
    glm::dvec3 step;
    glm::ivec3 turn;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double slope = std::abs(toLight[axis]);
      step[axis] = slope > 0.0 ? medium.CellSize[axis] / slope : std::numeric_limits<double>::max();
      next[axis] = slope > 0.0 ? 0.5 * step[axis] : step[axis];
      turn[axis] = toLight[axis] > 0.0 ? 1 : -1;
    }
    const double chord = std::min({ next.x, next.y, next.z });
    glm::dvec3 depth(0.0);
    glm::ivec3 at = cell;
    double from = chord;
    while (from < reach)
    {
      const int axis = next.x <= next.y && next.x <= next.z ? 0 : next.y <= next.z ? 1 : 2;
      at[axis] += turn[axis];
      next[axis] += step[axis];
      if (at[axis] < 0 || at[axis] >= medium.Cells[axis])
      {
        break;
      }
      const double to = std::min({ next.x, next.y, next.z, reach });
      const std::size_t index = medium.GetIndex(at);
      if (medium.IsBlocked(index))
      {
        return glm::dvec3(0.0);
      }
      depth += (to - from) * this->GetExtinction(index);
      from = to;
    }
    // From the border towards the light, or the light itself, to the border on the other side.
    const double own = std::min(chord, reach) + chord;
    const glm::dvec3 within = own * this->GetExtinction(medium.GetIndex(cell));
    glm::dvec3 mean;
    for (int c = 0; c < 3; ++c)
    {
      mean[c] = within[c] > 1e-4 ? -std::expm1(-within[c]) / within[c] : 1.0 - 0.5 * within[c];
    }
    return glm::exp(-depth) * mean;
  }

  /// Returns the light without the matter, as the mean of eight parts of a cell.
  glm::dvec3 GetColor(const glm::ivec3& cell) const
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
      sum += this->GetColorAt(this->Grid.ToUnit(this->Grid.GetMiddle(cell) + offset * size));
    }
    return 0.125 * sum * this->Light.Diffuse;
  }

private:
  glm::dvec3 GetExtinction(std::size_t cell) const
  {
    const double extinction = this->Grid.GetMedium().Extinction[cell];
    const std::vector<glm::vec3>& parts = this->Grid.GetParts();
    return parts.empty() ? glm::dvec3(extinction) : extinction * glm::dvec3(parts[cell]);
  }

  glm::dvec3 GetColorAt(const glm::dvec3& place) const
  {
    glm::dvec3 color(1.0);
    if (this->IsPositional)
    {
      const glm::dvec3 way = place - this->Light.Position;
      const double distance =
        std::max(glm::length(way), 0.25 * Vectors::InfinityNorm(this->Grid.GetMedium().CellSize));
      const glm::dvec3& attenuation = this->Light.Attenuation;
      const double fall = attenuation.x + distance * (attenuation.y + distance * attenuation.z);
      color /= fall;
      if (this->Light.ConeCosine > -1.0)
      {
        const double cosine =
          glm::dot(UnitVector::Normalize(way, this->Light.Direction), this->Light.Direction);
        color *= cosine < this->Light.ConeCosine ? 0.0 : std::pow(cosine, this->Light.Exponent);
      }
    }
    if (this->Light.Projective)
    {
      const glm::dvec4 seen = this->Light.ScreenFromUnit * glm::dvec4(place, 1.0);
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

  const MatterGrid& Grid;
  const LightSource& Light;
  bool IsPositional;
  glm::dvec3 Position;
  glm::dvec3 Direction;
};
}

ScatteringLight GridLight::Make(const MatterGrid& grid, const LightSource& light, int samples)
{
  ScatteringLight result;
  result.IsPositional = light.IsPositional;
  result.Position = grid.FromUnit(light.Position);
  result.Direction = grid.DirectionFromUnit(light.Direction);
  std::vector<LightSource> sources{ light };
  if (light.Area)
  {
    sources = EmitterSamples::Split(sources, { 0 }, samples);
  }
  std::vector<GridRay> rays;
  for (const LightSource& source : sources)
  {
    rays.emplace_back(grid, source);
  }
  const std::size_t cells = grid.GetMedium().GetNumberOfCells();
  result.Direct.resize(cells);
  vtkSMPTools::For(0, static_cast<vtkIdType>(cells),
    [&](vtkIdType first, vtkIdType last)
    {
      for (auto cell = static_cast<std::size_t>(first); cell < static_cast<std::size_t>(last);
           ++cell)
      {
        glm::dvec3 sum(0.0);
        const glm::ivec3 at = grid.GetCell(cell);
        for (const GridRay& ray : rays)
        {
          sum += grid.GetMedium().IsBlocked(cell) ? glm::dvec3(0.0)
                                                  : ray.GetColor(at) * ray.GetTransmittance(at);
        }
        result.Direct[cell] = glm::vec3(light.ShadowStrength * sum);
      }
    });
  return result;
}

}
