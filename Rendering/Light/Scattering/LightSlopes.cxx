// SPDX-License-Identifier: BSD-3-Clause
#include "Scattering/LightSlopes.h"

#include "Scattering/MediumLoop.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{

double SumOf(const glm::vec3& color)
{
  return static_cast<double>(color.x) + color.y + color.z;
}

/// Returns the logarithmic attenuation of one light across a cell along an axis.
double FindSlope(const ScatteringMedium& box, const std::vector<glm::vec3>& light,
  const glm::ivec3& cell, int axis, double along, double extinction)
{
  const int side = along > 0.0 ? 1 : -1;
  const auto find = [&](int step)
  {
    glm::ivec3 other = cell;
    other[axis] += step;
    const bool isInside = other[axis] >= 0 && other[axis] < box.Cells[axis];
    return isInside ? SumOf(light[box.GetIndex(other)]) : 0.0;
  };
  const double here = SumOf(light[box.GetIndex(cell)]);
  const double before = find(-side);
  const double after = find(side);
  const double ratio = before > 0.0 ? before / here : (after > 0.0 ? here / after : 1.0);
  // Without lit neighbors, assume that the cell's full optical depth attenuates the light.
  const double cellDepth = extinction * box.CellSize[axis] / std::abs(along);
  const bool isIsolated = !(before > 0.0) && !(after > 0.0);
  return side * std::min(isIsolated ? cellDepth : std::log(std::max(ratio, 1.0)), cellDepth);
}

}

std::vector<glm::vec3> LightSlopes::Find(
  const SanitizedMedium& medium, const std::vector<std::vector<glm::vec3>>& lights)
{
  const ScatteringMedium& box = medium.Box;
  std::vector<glm::vec3> slopes(medium.Extinction.size(), glm::vec3(0.0f));
  ForEachOccupiedCell(medium,
    [&](const glm::ivec3& cell, std::size_t at)
    {
      const double extinction = medium.Extinction[at];
      const glm::dvec3 center = box.Origin + (glm::dvec3(cell) + 0.5) * box.CellSize;
      glm::dvec3 sum(0.0);
      double total = 0.0;
      for (std::size_t light = 0; light < lights.size(); ++light)
      {
        const double here = SumOf(lights[light][at]);
        const glm::dvec3 along = medium.Lights[light].GetDirection(center);
        total += here;
        for (int axis = 0; axis < 3 && here > 0.0; ++axis)
        {
          sum[axis] += along[axis] != 0.0
            ? here * FindSlope(box, lights[light], cell, axis, along[axis], extinction)
            : 0.0;
        }
      }
      slopes[at] = total > 0.0 ? glm::vec3(sum / total) : glm::vec3(0.0f);
    });
  return slopes;
}

double LightSlopes::GetOffset(double slope)
{
  return std::abs(slope) > 1e-3 ? 1.0 / slope - 1.0 / std::expm1(slope) - 0.5 : -slope / 12.0;
}

}
