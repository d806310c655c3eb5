// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/ScatteringLight.h"

#include "Common/Vectors.h"
#include "Scattering/CellRay.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <limits>

namespace interlume
{

namespace
{

double ExtinctionOf(const ScatteringMedium& medium, std::size_t cell)
{
  const double extinction = medium.Extinction[cell];
  return extinction > 0.0 && std::isfinite(extinction) ? extinction : 0.0;
}

/// Returns the mean of exp(-depth) along the part of the ray that lies in its first cell, from the
/// middle of which it goes to the light, \a reach away; 0 behind blocked cells.
double MeanTransmittance(const ScatteringMedium& medium, CellRay ray, double reach)
{
  // The ray enters the cell as far from the middle as it leaves.
  const double own = 2.0 * ray.GetExit() * ExtinctionOf(medium, medium.GetIndex(ray.GetCell()));
  if (medium.IsBlocked(medium.GetIndex(ray.GetCell())))
  {
    return 0.0;
  }
  double depth = 0.0;
  // Mirrors may hold a ray for ever, and what is left of it soon counts no more.
  while (ray.GetExit() < reach && depth < 100.0 && ray.Advance())
  {
    const std::size_t index = medium.GetIndex(ray.GetCell());
    if (medium.IsBlocked(index))
    {
      return 0.0;
    }
    depth += ExtinctionOf(medium, index) * (std::min(ray.GetExit(), reach) - ray.GetEntry());
    if (ray.GetEntry() > 1e6 * glm::length(medium.CellSize))
    {
      break;
    }
  }
  return std::exp(-depth) * (own > 1e-9 ? -std::expm1(-own) / own : 1.0 - 0.5 * own);
}

}

glm::dvec3 ScatteringLight::GetDirection(const glm::dvec3& place) const
{
  if (!this->IsPositional)
  {
    return this->Direction;
  }
  const glm::dvec3 away = place - this->Position;
  const double length = Vectors::SafeLength(away);
  return length > 0.0 ? away / length : glm::dvec3(0.0);
}

void ScatteringLight::Fill(const ScatteringMedium& medium, const glm::vec3& color)
{
  this->Direct.assign(medium.GetNumberOfCells(), glm::vec3(0.0f));
  vtkSMPTools::For(0, medium.Cells.z,
    [&](vtkIdType begin, vtkIdType end)
    {
      glm::ivec3 cell(0);
      for (cell.z = static_cast<int>(begin); cell.z < end; ++cell.z)
      {
        for (cell.y = 0; cell.y < medium.Cells.y; ++cell.y)
        {
          for (cell.x = 0; cell.x < medium.Cells.x; ++cell.x)
          {
            const glm::dvec3 middle = medium.Origin + (glm::dvec3(cell) + 0.5) * medium.CellSize;
            const double reach = this->IsPositional ? Vectors::SafeLength(middle - this->Position)
                                                    : std::numeric_limits<double>::infinity();
            const glm::dvec3 direction = this->GetDirection(middle);
            const CellRay ray(medium, glm::dvec3(cell) + 0.5, -direction);
            const double mean = reach > 0.0 ? MeanTransmittance(medium, ray, reach) : 1.0;
            this->Direct[medium.GetIndex(cell)] = color * static_cast<float>(mean);
          }
        }
      }
    });
}

std::string ScatteringLight::Check(std::size_t cells) const
{
  if (this->Direct.size() != cells)
  {
    return "A light has " + std::to_string(this->Direct.size()) + " values in " +
      std::to_string(cells) + " cells of the scattering grid.";
  }
  const glm::dvec3& given = this->IsPositional ? this->Position : this->Direction;
  if (!Vectors::IsFinite(given) ||
    (!this->IsPositional && std::abs(Vectors::SafeLength(given) - 1.0) > 1e-6))
  {
    return std::string("A light has the ") + (this->IsPositional ? "place " : "direction ") +
      std::to_string(given.x) + ", " + std::to_string(given.y) + ", " + std::to_string(given.z) +
      (this->IsPositional ? ", which is not finite." : ", which is not of length 1.");
  }
  return {};
}

}
