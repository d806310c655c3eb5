// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/ScatteredLightMaps.h"

#include "Common/Vectors.h"
#include "Grid/ExtinctionGrid.h"

#include <algorithm>
#include <cstddef>

namespace interlume
{

namespace
{
using Values = std::vector<glm::vec3>;

void AddMap(float* texels, const Values& values)
{
  for (const glm::vec3& value : values)
  {
    texels = std::copy_n(glm::value_ptr(value), 3, texels) + 1;
  }
}
}

ScatteredLightMaps::ScatteredLightMaps(const ExtinctionGrid& grid, const ScatteredLight& field)
  : Nodes(grid.GetMedium().Cells)
{
  const std::size_t map = 4 * grid.GetMedium().GetNumberOfCells();
  this->Texels.resize(map * (2 + field.Forward.size()));
  AddMap(this->Texels.data(), field.Fluence);
  Values netFlux = field.NetFlux;
  for (glm::vec3& value : netFlux)
  {
    value = glm::vec3(grid.DirectionToUnit(glm::dvec3(value)));
  }
  AddMap(this->Texels.data() + map, netFlux);
  for (std::size_t i = 0; i < field.Forward.size(); ++i)
  {
    AddMap(this->Texels.data() + (2 + i) * map, field.Forward[i]);
  }
  const glm::dvec3& size = grid.GetMedium().CellSize;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    this->NodeFromUnit[axis] = glm::dvec4(grid.DirectionFromUnit(direction) / size, 0.0);
  }
  // Node 0 is the center of the first cell.
  this->NodeFromUnit[3] = glm::dvec4(grid.FromUnit(glm::dvec3(0.0)) / size - 0.5, 1.0);
}

}
