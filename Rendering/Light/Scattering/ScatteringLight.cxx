// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/ScatteringLight.h"

#include "Common/Vectors.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <glm/common.hpp>

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

/// Returns the mean of exp(-depth) along the part of the ray that lies in the cell, and 0 behind
/// blocked cells. The ray goes from the middle of \a cell to the light, \a reach away.
double MeanTransmittance(
  const ScatteringMedium& medium, const glm::ivec3& cell, const glm::dvec3& toLight, double reach)
{
  // Distances in world units at which the ray leaves the cell along each axis.
  glm::dvec3 next(std::numeric_limits<double>::infinity());
  glm::dvec3 step(next);
  glm::ivec3 side(0);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (toLight[axis] != 0.0)
    {
      step[axis] = medium.CellSize[axis] / std::abs(toLight[axis]);
      next[axis] = 0.5 * step[axis];
      side[axis] = toLight[axis] > 0.0 ? 1 : -1;
    }
  }
  glm::ivec3 at = cell;
  double gone = 0.0;
  double depth = 0.0;
  double own = 0.0;
  while (gone < reach)
  {
    const std::size_t index = medium.GetIndex(at);
    if (medium.IsBlocked(index))
    {
      return 0.0;
    }
    const int axis = next.x <= next.y && next.x <= next.z ? 0 : (next.y <= next.z ? 1 : 2);
    const double end = std::min(next[axis], reach);
    const double within = ExtinctionOf(medium, index) * (end - gone);
    if (at == cell)
    {
      // The ray enters as far from the middle as it leaves.
      own = within + ExtinctionOf(medium, index) * next[axis];
    }
    else
    {
      depth += within;
    }
    gone = end;
    next[axis] += step[axis];
    at[axis] += side[axis];
    if (at[axis] < 0 || at[axis] >= medium.Cells[axis])
    {
      if (!medium.Mirrors[axis])
      {
        break;
      }
      at[axis] -= side[axis];
      side[axis] = -side[axis];
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
            const double mean = MeanTransmittance(medium, cell, -this->GetDirection(middle), reach);
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
