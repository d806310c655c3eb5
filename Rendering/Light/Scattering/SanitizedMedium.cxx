// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/SanitizedMedium.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace interlume
{

namespace
{

/// Clamps a value to the range from 0 to \a largest. A non-finite value is replaced by 0 and sets
/// \a isBad.
float Clean(float value, float largest, bool& isBad)
{
  isBad = isBad || !std::isfinite(value);
  return std::isfinite(value) ? std::min(std::max(value, 0.0f), largest) : 0.0f;
}

glm::vec3 Clean(const glm::vec3& value, float largest, bool& isBad)
{
  return { Clean(value.x, largest, isBad), Clean(value.y, largest, isBad),
    Clean(value.z, largest, isBad) };
}

/// Squares of larger values overflow single precision.
constexpr float Largest = 1e18f;

}

SanitizedMedium::SanitizedMedium(
  const ScatteringMedium& medium, const std::vector<ScatteringLight>& lights)
  : CellVolume(medium.CellSize.x * medium.CellSize.y * medium.CellSize.z)
{
  const std::size_t cells = medium.GetNumberOfCells();
  this->Box.Cells = medium.Cells;
  this->Box.CellSize = medium.CellSize;
  this->Box.Origin = medium.Origin;
  this->Box.Mirrors = medium.Mirrors;
  this->Box.Blocked = medium.Blocked;
  this->Extinction.resize(cells);
  this->Albedo.resize(cells);
  this->Direct.assign(lights.size(), std::vector<glm::vec3>(cells));
  for (const ScatteringLight& light : lights)
  {
    this->Lights.emplace_back();
    this->Lights.back().IsPositional = light.IsPositional;
    this->Lights.back().Direction = light.Direction;
    this->Lights.back().Position = light.Position;
  }
  for (std::size_t cell = 0; cell < cells; ++cell)
  {
    bool isBad = false;
    this->Extinction[cell] = Clean(medium.Extinction[cell], Largest, isBad);
    this->Albedo[cell] = Clean(medium.Albedo[cell], 1.0f, isBad);
    for (std::size_t light = 0; light < lights.size(); ++light)
    {
      this->Direct[light][cell] = Clean(lights[light].Direct[cell], Largest, isBad);
    }
    this->BadCells += isBad ? 1 : 0;
    if (this->Box.IsBlocked(cell))
    {
      this->Extinction[cell] = 0.0f;
      for (std::vector<glm::vec3>& direct : this->Direct)
      {
        direct[cell] = glm::vec3(0.0f);
      }
    }
  }
}

}
