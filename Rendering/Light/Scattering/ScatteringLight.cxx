// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/ScatteringLight.h"

#include "Common/Vectors.h"
#include "Scattering/CellLight.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace interlume
{

glm::dvec3 ScatteringLight::GetDirection(const glm::dvec3& position) const
{
  if (!this->IsPositional)
  {
    return this->Direction;
  }
  const glm::dvec3 away = position - this->Position;
  const double length = Vectors::SafeLength(away);
  return length > 0.0 ? away / length : glm::dvec3(0.0);
}

void ScatteringLight::Fill(const ScatteringMedium& medium, const glm::vec3& color)
{
  this->Direct = CellLight::Find(medium, {}, *this, CellLight::GetRaysPerEdge(medium.Cells));
  for (glm::vec3& value : this->Direct)
  {
    value *= color;
  }
}

Error ScatteringLight::Check(std::size_t cells) const
{
  if (this->Direct.size() != cells)
  {
    return "A light has " + std::to_string(this->Direct.size()) +
      " values, but the scattering grid has " + std::to_string(cells) + " cells.";
  }
  const glm::dvec3& given = this->IsPositional ? this->Position : this->Direction;
  if (!Vectors::IsFinite(given) ||
    (!this->IsPositional && std::abs(Vectors::SafeLength(given) - 1.0) > 1e-6))
  {
    return std::string("A light has the ") + (this->IsPositional ? "position " : "direction ") +
      std::to_string(given.x) + ", " + std::to_string(given.y) + ", " + std::to_string(given.z) +
      (this->IsPositional ? ", which is not finite." : ", which is not of length 1.");
  }
  return {};
}

}
