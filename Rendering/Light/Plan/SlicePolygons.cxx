// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/SlicePolygons.h"

#include "Common/ParallelFor.h"
#include "Plan/BoxCutTable.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

namespace interlume
{

namespace
{

using namespace UnitVector;

using Block = std::array<int, 3>;
using Point = std::array<float, 3>;

// Cuts a grid of blocks with planes.
class Cutter
{
public:
  Cutter(const BlockGrid& grid, const UnitSpace& space, const glm::dvec3& normal)
    : Grid(grid)
    , Space(space)
    , Constant(glm::dot(normal, glm::dvec3(space.UnitFromTexture[3])))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const glm::dvec3 column(space.UnitFromTexture[axis]);
      for (const double border : grid.GetBorders(axis))
      {
        this->Heights[axis].push_back(glm::dot(normal, column) * border);
      }
    }
  }

  // Returns the minimum and maximum position of a block along the normal.
  std::array<double, 2> GetRange(const Block& block) const
  {
    std::array<double, 2> range{ { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX } };
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      const double height = this->GetHeight(block, corner, 0.0);
      range[0] = std::min(range[0], height);
      range[1] = std::max(range[1], height);
    }
    return range;
  }

  // Appends the cross-section of a block with the plane at \a position, as triangles.
  void Cut(const Block& block, double position, std::vector<float>& vertices) const
  {
    std::array<double, 8> heights;
    unsigned above = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      heights[corner] = this->GetHeight(block, corner, position);
      above |= heights[corner] > 0.0 ? 1u << corner : 0u;
    }
    std::array<Point, 6> points;
    std::size_t number = 0;
    for (const int edge : this->Table.GetEdges(above))
    {
      const Point point = this->GetPoint(block, BoxCutTable::GetEdge(edge), heights);
      if (number == 0 || point != points[number - 1])
      {
        points[number++] = point;
      }
    }
    if (number > 1 && points[number - 1] == points[0])
    {
      --number;
    }
    for (std::size_t i = 2; i < number; ++i)
    {
      for (const std::size_t corner : { std::size_t(0), i - 1, i })
      {
        vertices.insert(vertices.end(), points[corner].begin(), points[corner].end());
      }
    }
  }

private:
  // Returns a corner's height above the plane at \a position. All blocks add the terms in the same
  // order. Heights of shared corners are therefore bit-identical and monotonic along each axis, so
  // no face is cut twice.
  double GetHeight(const Block& block, unsigned corner, double position) const
  {
    std::array<double, 3> heights;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto border = static_cast<std::size_t>(block[axis]) + (corner >> axis & 1u);
      heights[axis] = this->Heights[axis][border];
    }
    return heights[0] + heights[1] + heights[2] + (this->Constant - position);
  }

  // Returns the intersection of the plane and an edge. It is computed from the edge's lower end, so
  // all blocks compute the same point.
  Point GetPoint(
    const Block& block, const BoxCutTable::Edge& edge, const std::array<double, 8>& heights) const
  {
    glm::dvec3 texture;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto border = static_cast<std::size_t>(block[axis]) + (edge.Start >> axis & 1u);
      texture[axis] = this->Grid.GetBorders(axis)[border];
    }
    const auto axis = static_cast<std::size_t>(edge.Axis);
    const double start = heights[edge.Start];
    const double end = heights[edge.Start | 1u << edge.Axis];
    const double length =
      this->Grid.GetBorders(axis)[static_cast<std::size_t>(block[axis]) + 1] - texture[axis];
    texture[axis] += start / (start - end) * length;
    const glm::dvec3 unit = TransformPoint(this->Space.UnitFromTexture, texture);
    return { { static_cast<float>(unit[0]), static_cast<float>(unit[1]),
      static_cast<float>(unit[2]) } };
  }

  const BlockGrid& Grid;
  const UnitSpace& Space;
  const double Constant;
  /// For each axis, contributions of the block borders to the height along the normal.
  std::array<std::vector<double>, 3> Heights;
  const BoxCutTable Table;
};

// Returns, for each slab, the blocks that its central plane may intersect, in block order.
std::vector<std::vector<Block>> Distribute(
  const std::vector<Block>& blocks, const Cutter& cutter, const SlicePlan::Sweep& sweep)
{
  std::vector<std::vector<Block>> slabs(static_cast<std::size_t>(sweep.Slabs));
  const auto toSlab = [&](double position)
  {
    const double slab = (position - sweep.First) / sweep.Spacing - 0.5;
    return static_cast<int>(std::max(std::min(slab, double(sweep.Slabs)), -1.0));
  };
  for (const Block& block : blocks)
  {
    const std::array<double, 2> range = cutter.GetRange(block);
    const int last = std::min(toSlab(range[1]) + 1, sweep.Slabs - 1);
    for (int slab = std::max(toSlab(range[0]) - 1, 0); slab <= last; ++slab)
    {
      slabs[static_cast<std::size_t>(slab)].push_back(block);
    }
  }
  return slabs;
}

}

void SlicePolygons::Build(const SlicePlan::Sweep& sweep, BlockGrid grid, const UnitSpace& space,
  const std::array<std::array<double, 2>, 3>& box, double margin)
{
  grid.Crop(box, space.GetMargins(margin));
  grid.Join();

  const Cutter cutter(grid, space, sweep.Normal);
  const std::vector<std::vector<Block>> blocks = Distribute(grid.GetVisible(), cutter, sweep);
  std::vector<std::vector<float>> parts(blocks.size());
  ParallelFor(0, sweep.Slabs,
    [&](vtkIdType slab)
    {
      const auto index = static_cast<std::size_t>(slab);
      const double position = sweep.First + (static_cast<double>(slab) + 0.5) * sweep.Spacing;
      for (const Block& block : blocks[index])
      {
        cutter.Cut(block, position, parts[index]);
      }
    });
  this->Join(parts);
}

}
