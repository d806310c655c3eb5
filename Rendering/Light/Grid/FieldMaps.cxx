// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/FieldMaps.h"

#include "Common/Vectors.h"
#include "Grid/MatterGrid.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cstddef>

namespace interlume
{

namespace
{
enum Kinds
{
  FLUENCE,
  LEAN,
  FORWARD
};

using Values = std::vector<glm::vec3>;

// Returns how much the fluence on the side of the box is less than in the middle of the cell there.
glm::vec3 GetSideShare(const ScatteringMedium& medium, const glm::ivec3& cell, int axis)
{
  const std::size_t index = medium.GetIndex(cell);
  const auto g = static_cast<float>(medium.Phase.Moment(1));
  const glm::vec3 depth = medium.Extinction[index] * static_cast<float>(medium.CellSize[axis]) *
    (1.0F - g * medium.Albedo[index]);
  return 1.0F / (1.0F + 0.75F * depth);
}

// Returns the value of a node, of the cell there or beyond the nearest one.
glm::vec3 GetNode(
  const ScatteringMedium& medium, const Values& values, Kinds kind, const glm::ivec3& node)
{
  const glm::ivec3 cell = glm::clamp(node - 1, glm::ivec3(0), medium.Cells - 1);
  glm::vec3 value = values[medium.GetIndex(cell)];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (node[axis] - 1 == cell[axis] || kind == LEAN)
    {
      continue;
    }
    if (kind == FLUENCE)
    {
      value *= 2.0F * GetSideShare(medium, cell, axis) - 1.0F;
      continue;
    }
    glm::ivec3 before = cell;
    before[axis] = std::clamp(cell[axis] + (node[axis] == 0 ? 1 : -1), 0, medium.Cells[axis] - 1);
    const glm::vec3 inside = values[medium.GetIndex(before)];
    value = glm::clamp(2.0F * value - inside, glm::vec3(0.0F), 2.0F * value);
  }
  return value;
}

void AddMap(
  const MatterGrid& grid, const Values& values, Kinds kind, const glm::ivec3& nodes, float* texels)
{
  const ScatteringMedium& medium = grid.GetMedium();
  vtkSMPTools::For(0, nodes.z,
    [&](vtkIdType first, vtkIdType last)
    {
      glm::ivec3 node;
      for (node.z = static_cast<int>(first); node.z < static_cast<int>(last); ++node.z)
      {
        for (node.y = 0; node.y < nodes.y; ++node.y)
        {
          for (node.x = 0; node.x < nodes.x; ++node.x)
          {
            glm::vec3 value = GetNode(medium, values, kind, node);
            value = kind == LEAN ? glm::vec3(grid.DirectionToUnit(glm::dvec3(value))) : value;
            const std::size_t at = static_cast<std::size_t>(node.x) +
              static_cast<std::size_t>(nodes.x) *
                (static_cast<std::size_t>(node.y) +
                  static_cast<std::size_t>(nodes.y) * static_cast<std::size_t>(node.z));
            std::copy_n(glm::value_ptr(value), 3, texels + 3 * at);
          }
        }
      }
    });
}
}

FieldMaps::FieldMaps(const MatterGrid& grid, const ScatteringField& field)
  : Nodes(grid.GetMedium().Cells + 2)
{
  const std::size_t map = 3 * static_cast<std::size_t>(this->Nodes.x) *
    static_cast<std::size_t>(this->Nodes.y) * static_cast<std::size_t>(this->Nodes.z);
  this->Texels.resize(map * (2 + field.Forward.size()));
  const auto add = [&](const Values& values, Kinds kind, std::size_t number)
  {
    if (!values.empty())
    {
      AddMap(grid, values, kind, this->Nodes, this->Texels.data() + number * map);
    }
  };
  add(field.Fluence, FLUENCE, 0);
  add(field.Lean, LEAN, 1);
  for (std::size_t i = 0; i < field.Forward.size(); ++i)
  {
    add(field.Forward[i], FORWARD, 2 + i);
  }
  // The middle of the first cell is node 1.
  const glm::dvec3& size = grid.GetMedium().CellSize;
  const glm::dvec3 offset = grid.FromUnit(glm::dvec3(0.0)) / size + 0.5;
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    this->NodeFromUnit[axis] = glm::dvec4(grid.DirectionFromUnit(direction) / size, 0.0);
  }
  this->NodeFromUnit[3] = glm::dvec4(offset, 1.0);
}

}
