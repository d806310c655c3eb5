// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/LightTiles.h"

#include "Common/ParallelFor.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace interlume
{

namespace
{

using namespace UnitVector;

using Box = std::array<std::array<double, 2>, 3>;

// Lower and upper corner of a box.
struct Bounds
{
  glm::dvec3 Lower;
  glm::dvec3 Upper;
};

// Margin added to bounds, in texture coordinates, because shaders clip rays to the box in single
// precision.
constexpr double Margin = 1e-5;
// Lower bound for the cosine between a ray and the normal, so that rays parallel to the slices have
// a finite intersection with a slice.
constexpr double SmallestSlope = 1e-9;

// Tests whether a box contains visible blocks, with 3D prefix sums of the visible blocks.
class BlockCounts
{
public:
  BlockCounts(const BlockGrid& grid, const Box& box)
    : Grid(grid)
    , MediumBounds{ { box[0][0], box[1][0], box[2][0] }, { box[0][1], box[1][1], box[2][1] } }
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Size[axis] = static_cast<std::size_t>(grid.GetSize(axis));
    }
    this->Sums.assign((this->Size[0] + 1) * (this->Size[1] + 1) * (this->Size[2] + 1), 0);
    for (std::size_t k = 0; k < this->Size[2]; ++k)
    {
      for (std::size_t j = 0; j < this->Size[1]; ++j)
      {
        int row = 0;
        for (std::size_t i = 0; i < this->Size[0]; ++i)
        {
          row +=
            grid.IsVisible({ { static_cast<int>(i), static_cast<int>(j), static_cast<int>(k) } });
          this->Sums[this->GetIndex(i + 1, j + 1, k + 1)] =
            row + this->Get(i + 1, j, k + 1) + this->Get(i + 1, j + 1, k) - this->Get(i + 1, j, k);
        }
      }
    }
  }

  bool HasVisibleBlock(const Bounds& part) const
  {
    const glm::dvec3 lower = glm::max(part.Lower, this->MediumBounds.Lower) - Margin;
    const glm::dvec3 upper = glm::min(part.Upper, this->MediumBounds.Upper) + Margin;
    if (!glm::all(glm::lessThanEqual(lower, upper)))
    {
      return false;
    }
    std::size_t first[3];
    std::size_t end[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      first[axis] = this->Find(static_cast<std::size_t>(axis), lower[axis]);
      end[axis] = this->Find(static_cast<std::size_t>(axis), upper[axis]) + 1;
    }
    const auto getLayer = [&](std::size_t k)
    {
      return this->Get(end[0], end[1], k) - this->Get(first[0], end[1], k) -
        this->Get(end[0], first[1], k) + this->Get(first[0], first[1], k);
    };
    return getLayer(end[2]) > getLayer(first[2]);
  }

private:
  std::size_t GetIndex(std::size_t i, std::size_t j, std::size_t k) const
  {
    return (k * (this->Size[1] + 1) + j) * (this->Size[0] + 1) + i;
  }
  int Get(std::size_t i, std::size_t j, std::size_t k) const
  {
    return this->Sums[this->GetIndex(i, j, k)];
  }
  // Returns the index of the block at a position along an axis. The first and last blocks extend to
  // infinity.
  std::size_t Find(std::size_t axis, double position) const
  {
    const std::vector<double>& borders = this->Grid.GetBorders(axis);
    const auto above = std::upper_bound(borders.begin() + 1, borders.end() - 1, position);
    return static_cast<std::size_t>(above - borders.begin()) - 1;
  }

  const BlockGrid& Grid;
  const Bounds MediumBounds;
  std::array<std::size_t, 3> Size{};
  std::vector<int> Sums;
};

// Pyramids of light rays through the tiles of a light buffer, in texture coordinates.
class Pyramids
{
public:
  Pyramids(const SlicePlan::ShadowedLight& light, const glm::dvec3& normal,
    const glm::dvec3& position, const UnitSpace& space)
    : Number(static_cast<std::size_t>(std::max(light.BufferSize / LightTiles::TileSize, 1)))
    , Apex(TransformPoint(space.TextureFromUnit, position))
    , Upwards(TransformVector(space.TextureFromUnit, normal))
  {
    for (std::size_t j = 0; j <= this->Number; ++j)
    {
      for (std::size_t i = 0; i <= this->Number; ++i)
      {
        const glm::dvec3 direction =
          SlicePlan::GetBufferDirection(light.Frame, { { this->GetEdge(i), this->GetEdge(j) } });
        const double slope = glm::dot(direction, normal);
        const glm::dvec3 across = direction - slope * normal;
        this->Across.push_back(
          TransformVector(space.TextureFromUnit, (1.0 / std::max(slope, SmallestSlope)) * across));
      }
    }
  }

  std::size_t GetNumber() const { return this->Number; }
  /// Returns the position of a tile's edge in the buffer, from 0 to 1.
  double GetEdge(std::size_t i) const
  {
    return static_cast<double>(i) / static_cast<double>(this->Number);
  }
  /// Returns a bounding box of the pyramid of tile (i, j) between two heights above the light. The
  /// corners suffice, because tile edges are straight in every slice plane: the creases of the
  /// octahedral map run along the tiles' diagonals.
  Bounds Bound(std::size_t i, std::size_t j, const std::array<double, 2>& heights) const
  {
    Bounds box{ glm::dvec3(VTK_DOUBLE_MAX), glm::dvec3(-VTK_DOUBLE_MAX) };
    for (const std::size_t corner :
      { std::size_t(0), std::size_t(1), this->Number + 1, this->Number + 2 })
    {
      const glm::dvec3& across = this->Across[j * (this->Number + 1) + i + corner];
      for (const double height : heights)
      {
        const glm::dvec3 point = this->Apex + height * (this->Upwards + across);
        box.Lower = glm::min(box.Lower, point);
        box.Upper = glm::max(box.Upper, point);
      }
    }
    return box;
  }

private:
  const std::size_t Number;
  const glm::dvec3 Apex;
  const glm::dvec3 Upwards;
  // Lateral offset of the ray through each tile corner at height 1.
  std::vector<glm::dvec3> Across;
};

void AddRectangle(
  const std::array<double, 2>& x, const std::array<double, 2>& y, std::vector<float>& vertices)
{
  for (const auto& [i, j] : { std::array<std::size_t, 2>{ { 0, 0 } }, { { 1, 0 } }, { { 1, 1 } },
         { { 0, 0 } }, { { 1, 1 } }, { { 0, 1 } } })
  {
    vertices.insert(vertices.end(), { static_cast<float>(x[i]), static_cast<float>(y[j]), 0.0f });
  }
}

void AddTiles(const Pyramids& pyramids, const BlockCounts& blocks,
  const std::array<double, 2>& heights, std::vector<float>& vertices)
{
  const std::size_t number = pyramids.GetNumber();
  for (std::size_t j = 0; j < number; ++j)
  {
    std::size_t first = 0;
    for (std::size_t i = 0; i <= number; ++i)
    {
      if (i < number && blocks.HasVisibleBlock(pyramids.Bound(i, j, heights)))
      {
        continue;
      }
      if (i > first)
      {
        AddRectangle({ { pyramids.GetEdge(first), pyramids.GetEdge(i) } },
          { { pyramids.GetEdge(j), pyramids.GetEdge(j + 1) } }, vertices);
      }
      first = i + 1;
    }
  }
}

}

void LightTiles::Build(const SlicePlan::Sweep& sweep, const SlicePlan::ShadowedLight& light,
  const glm::dvec3& position, const BlockGrid& grid, const UnitSpace& space, const Box& box)
{
  const BlockCounts counts(grid, box);
  const Pyramids pyramids(light, sweep.Normal, position, space);
  const double apex = glm::dot(position, sweep.Normal);
  std::vector<std::vector<float>> parts(static_cast<std::size_t>(sweep.Slabs));
  ParallelFor(0, sweep.Slabs,
    [&](vtkIdType slab)
    {
      const double lower = sweep.First + static_cast<double>(slab) * sweep.Spacing - apex;
      const double upper = lower + sweep.Spacing;
      if (upper > 0.0)
      {
        AddTiles(pyramids, counts, { { std::max(lower, 0.0), upper } },
          parts[static_cast<std::size_t>(slab)]);
      }
    });
  this->Join(parts);
}

}
