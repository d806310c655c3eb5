// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/PlaneTiles.h"

#include "Plan/BoxCutTable.h"
#include "Space/UnitSpace.h"
#include "Space/UnitVector.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace interlume
{

namespace
{

using namespace UnitVector;

using Block = std::array<int, 3>;

// Range of tiles along an axis: the first tile, and the one after the last.
using Range = std::array<int, 2>;

// Margin by which bounds are enlarged to allow for rounding errors, in tiles.
constexpr double Rounding = 1e-3;

// Minimum cosine between a view ray and the slice normal. For a smaller cosine, tile corners are
// too far away for single precision.
constexpr double MinimumCosine = 0.1;

// Number of slabs that a task processes at once.
constexpr int Batch = 16;

// A bit mask of the tiles in a slab.
class TileMask
{
public:
  explicit TileMask(const std::array<int, 2>& number)
    : Number(number)
    , Words((number[0] + 63) / 64)
    , Bits(static_cast<std::size_t>(this->Words * number[1]), 0)
  {
  }

  void Clear() { std::fill(this->Bits.begin(), this->Bits.end(), 0); }

  void Add(const Range& columns, int row)
  {
    for (int word = columns[0] / 64; 64 * word < columns[1]; ++word)
    {
      const int first = std::max(columns[0] - 64 * word, 0);
      const int last = std::min(columns[1] - 64 * word, 64) - 1;
      this->Bits[this->GetIndex(word, row)] |=
        (~std::uint64_t(0) << first) & (~std::uint64_t(0) >> (63 - last));
    }
  }

  // Returns the first run of tiles in a row at or after \a column. It is empty if there are no more
  // tiles.
  Range FindRun(int column, int row) const
  {
    const int first = this->Find(column, row, true);
    return { { first, this->Find(first, row, false) } };
  }

  int GetNumberOfRows() const { return this->Number[1]; }

private:
  std::size_t GetIndex(int word, int row) const
  {
    return static_cast<std::size_t>(row) * this->Words + word;
  }

  // Returns the first column at or after \a column that has a tile or, if \a hasTile is false, that
  // has none. Returns the row's end if there is no such column.
  int Find(int column, int row, bool hasTile) const
  {
    while (column < this->Number[0])
    {
      const std::uint64_t word = this->Bits[this->GetIndex(column / 64, row)];
      const std::uint64_t left = (hasTile ? word : ~word) >> (column % 64);
      if ((left & 1u) != 0)
      {
        return column;
      }
      column = left == 0 ? (column / 64 + 1) * 64 : column + 1;
    }
    return this->Number[0];
  }

  std::array<int, 2> Number;
  int Words;
  std::vector<std::uint64_t> Bits;
};

struct Rectangle
{
  Range Columns;
  Range Rows;
};

// Returns the mask's tiles as rectangles. Equal runs in consecutive rows are merged.
std::vector<Rectangle> MakeRectangles(const TileMask& mask)
{
  std::vector<Rectangle> rectangles;
  std::vector<std::size_t> above;
  std::vector<std::size_t> here;
  for (int row = 0; row < mask.GetNumberOfRows(); ++row)
  {
    here.clear();
    std::size_t next = 0;
    for (Range run = mask.FindRun(0, row); run[0] < run[1]; run = mask.FindRun(run[1], row))
    {
      while (next < above.size() && rectangles[above[next]].Columns[0] < run[0])
      {
        ++next;
      }
      if (next < above.size() && rectangles[above[next]].Columns == run)
      {
        here.push_back(above[next]);
        rectangles[above[next]].Rows[1] = row + 1;
      }
      else
      {
        here.push_back(rectangles.size());
        rectangles.push_back({ run, { { row, row + 1 } } });
      }
    }
    above.swap(here);
  }
  return rectangles;
}

// Projects the cross-sections of blocks with slab planes onto the tiles of a view.
class Viewer
{
public:
  Viewer(const BlockGrid& grid, const UnitSpace& space, const SlicePlan::Sweep& sweep,
    const glm::dmat4& clipFromUnit, const std::array<int, 2>& size)
    : IsParallel(GetRow(clipFromUnit, 3) == glm::dvec3(0.0))
  {
    const glm::dvec4 depth = glm::row(clipFromUnit, 3);
    std::array<glm::dvec4, 2> rows;
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      this->Number[axis] = (size[axis] + PlaneTiles::TileSize - 1) / PlaneTiles::TileSize;
      rows[axis] = 0.5 * size[axis] / PlaneTiles::TileSize *
        (glm::row(clipFromUnit, static_cast<int>(axis)) + depth);
    }
    const glm::dvec4 height(sweep.Normal / sweep.Spacing, -sweep.First / sweep.Spacing - 0.5);
    this->TilesFromUnit = glm::transpose(glm::dmat4(rows[0], rows[1], depth, height));
    const glm::dmat4 map = this->TilesFromUnit * space.UnitFromTexture;
    this->Origin = map[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const double border : grid.GetBorders(axis))
      {
        this->Borders[axis].push_back(border * map[static_cast<int>(axis)]);
      }
    }
  }

  const std::array<int, 2>& GetNumber() const { return this->Number; }

  // Returns true if the entire block grid is in front of the camera, and no view ray through it is
  // nearly parallel to the slices.
  bool IsSuitable() const
  {
    std::array<glm::dvec2, 8> positions;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      glm::dvec4 point = this->Origin;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        point +=
          (corner >> axis & 1u) != 0 ? this->Borders[axis].back() : this->Borders[axis].front();
      }
      if (!(point.z > 0.0))
      {
        return false;
      }
      positions[corner] = glm::dvec2(point) / point.z;
    }
    std::array<Range, 2> ranges;
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto [minimum, maximum] = std::minmax_element(positions.begin(), positions.end(),
        [axis](const glm::dvec2& a, const glm::dvec2& b) { return a[axis] < b[axis]; });
      ranges[static_cast<std::size_t>(axis)] =
        this->GetRange((*minimum)[axis], (*maximum)[axis], axis);
    }
    // View rays vary linearly over the tiles, so testing the rays at the corners suffices.
    const glm::dvec3 normal(glm::row(this->TilesFromUnit, 3));
    double side = 0.0;
    for (unsigned corner = 0; corner < 4; ++corner)
    {
      const glm::dvec3 ray = this->GetRay(ranges[0][corner & 1u], ranges[1][corner >> 1u]);
      const double along = glm::dot(ray, normal);
      side = corner == 0 ? along : side;
      if (!(along * side > 0.0 &&
            std::abs(along) > MinimumCosine * glm::length(ray) * glm::length(normal)))
      {
        return false;
      }
    }
    return true;
  }

  // Adds a block's cross-sections with \a slabs slabs, starting at \a firstSlab, to the slabs'
  // masks.
  void Add(const Block& block, int firstSlab, int slabs, std::vector<TileMask>& masks) const
  {
    std::array<glm::dvec4, 8> corners;
    double lowest = VTK_DOUBLE_MAX;
    double highest = -VTK_DOUBLE_MAX;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      glm::dvec4 point = this->Origin;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        point += this->Borders[axis][static_cast<std::size_t>(block[axis]) + (corner >> axis & 1u)];
      }
      corners[corner] = point;
      lowest = std::min(lowest, point.w);
      highest = std::max(highest, point.w);
    }
    if (lowest < firstSlab + slabs && highest > firstSlab - 1)
    {
      const int last = std::min(static_cast<int>(std::floor(highest)), firstSlab + slabs - 1);
      for (int slab = std::max(static_cast<int>(std::ceil(lowest)), firstSlab); slab <= last;
           ++slab)
      {
        this->AddCut(corners, slab, masks[static_cast<std::size_t>(slab - firstSlab)]);
      }
    }
  }

  // Returns the point where the view ray through a tile's corner intersects a slab's plane.
  std::array<float, 3> GetPoint(int column, int row, int slab) const
  {
    const glm::dvec4 depth = glm::row(this->TilesFromUnit, 2);
    const glm::dvec4 a = glm::row(this->TilesFromUnit, 0) - static_cast<double>(column) * depth;
    const glm::dvec4 b = glm::row(this->TilesFromUnit, 1) - static_cast<double>(row) * depth;
    const glm::dvec4 c = glm::row(this->TilesFromUnit, 3) - glm::dvec4(0.0, 0.0, 0.0, slab);
    const glm::dvec3 ray = this->GetRay(column, row);
    const glm::dvec3 point = -(a.w * glm::cross(glm::dvec3(b), glm::dvec3(c)) +
                               b.w * glm::cross(glm::dvec3(c), glm::dvec3(a)) + c.w * ray) /
      glm::dot(ray, glm::dvec3(c));
    return { { static_cast<float>(point.x), static_cast<float>(point.y),
      static_cast<float>(point.z) } };
  }

private:
  // Returns the tiles along an axis that intersect a range of positions in tile units.
  Range GetRange(double lower, double upper, int axis) const
  {
    const double end = this->Number[static_cast<std::size_t>(axis)];
    return { { static_cast<int>(std::floor(std::max(std::min(lower - Rounding, end), 0.0))),
      static_cast<int>(std::ceil(std::max(std::min(upper + Rounding, end), 0.0))) } };
  }

  // Returns the direction of the view ray through a tile's corner, up to its sign and length.
  glm::dvec3 GetRay(int column, int row) const
  {
    const glm::dvec3 depth = GetRow(this->TilesFromUnit, 2);
    return glm::cross(GetRow(this->TilesFromUnit, 0) - static_cast<double>(column) * depth,
      GetRow(this->TilesFromUnit, 1) - static_cast<double>(row) * depth);
  }

  // Adds the tiles that intersect a block's cross-section with a slab's plane.
  void AddCut(const std::array<glm::dvec4, 8>& corners, int slab, TileMask& mask) const
  {
    const double height = slab;
    unsigned above = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      above |= corners[corner].w > height ? 1u << corner : 0u;
    }
    std::array<glm::dvec2, 6> points;
    std::size_t number = 0;
    double lowest = VTK_DOUBLE_MAX;
    double highest = -VTK_DOUBLE_MAX;
    for (const int index : this->Table.GetEdges(above))
    {
      const BoxCutTable::Edge edge = BoxCutTable::GetEdge(index);
      const glm::dvec4& start = corners[edge.Start];
      const glm::dvec4& end = corners[edge.Start | 1u << edge.Axis];
      const glm::dvec4 point = start + (height - start.w) / (end.w - start.w) * (end - start);
      points[number] = this->IsParallel ? glm::dvec2(point) : glm::dvec2(point) / point.z;
      lowest = std::min(lowest, points[number].y);
      highest = std::max(highest, points[number].y);
      ++number;
    }
    const Range rows = this->GetRange(lowest, highest, 1);
    for (int row = rows[0]; row < rows[1]; ++row)
    {
      this->AddRow(points, number, row, mask);
    }
  }

  // Adds the tiles of a row that a polygon covers.
  void AddRow(
    const std::array<glm::dvec2, 6>& points, std::size_t number, int row, TileMask& mask) const
  {
    const double lower = row - Rounding;
    const double upper = row + 1 + Rounding;
    double minimum = VTK_DOUBLE_MAX;
    double maximum = -VTK_DOUBLE_MAX;
    for (std::size_t i = 0; i < number; ++i)
    {
      const glm::dvec2& point = points[i];
      const glm::dvec2& other = points[i + 1 < number ? i + 1 : 0];
      const bool rises = point.y < other.y;
      const glm::dvec2& start = rises ? point : other;
      const glm::dvec2& end = rises ? other : point;
      if (start.y > upper || end.y < lower)
      {
        continue;
      }
      const double slope = end.y > start.y ? (end.x - start.x) / (end.y - start.y) : 0.0;
      const double first = start.x + slope * std::max(lower - start.y, 0.0);
      const double last = end.x - slope * std::max(end.y - upper, 0.0);
      minimum = std::min(minimum, std::min(first, last));
      maximum = std::max(maximum, std::max(first, last));
    }
    const Range columns = this->GetRange(minimum, maximum, 0);
    if (columns[0] < columns[1])
    {
      mask.Add(columns, row);
    }
  }

  std::array<int, 2> Number{};
  const bool IsParallel;
  /// Transforms unit space to (column * depth, row * depth, depth, slab). Columns and rows are in
  /// tiles. On the central plane of a slab, the last coordinate is the slab's index.
  glm::dmat4 TilesFromUnit;
  /// Origin of texture coordinates, and offsets from it to the block borders along each axis,
  /// transformed by TilesFromUnit.
  glm::dvec4 Origin;
  std::array<std::vector<glm::dvec4>, 3> Borders;
  const BoxCutTable Table;
};

void AddRectangle(
  const Viewer& viewer, const Rectangle& rectangle, int slab, std::vector<float>& vertices)
{
  std::array<std::array<float, 3>, 4> points;
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    points[corner] =
      viewer.GetPoint(rectangle.Columns[corner & 1u], rectangle.Rows[corner >> 1u], slab);
  }
  for (const std::size_t corner : { 0, 1, 3, 0, 3, 2 })
  {
    vertices.insert(vertices.end(), points[corner].begin(), points[corner].end());
  }
}

}

bool PlaneTiles::Build(const SlicePlan::Sweep& sweep, const glm::dmat4& clipFromUnit,
  const std::array<int, 2>& size, BlockGrid grid, const UnitSpace& space,
  const std::array<std::array<double, 2>, 3>& box, double margin)
{
  grid.Crop(box, space.GetMargins(margin));
  const std::vector<Block> blocks = grid.GetVisible();
  const Viewer viewer(grid, space, sweep, clipFromUnit, size);
  const bool isSuitable = viewer.IsSuitable();
  std::vector<std::vector<float>> parts(static_cast<std::size_t>(sweep.Slabs));
  vtkSMPTools::For(0, isSuitable ? (sweep.Slabs + Batch - 1) / Batch : 0,
    [&](vtkIdType first, vtkIdType end)
    {
      std::vector<TileMask> masks(Batch, TileMask(viewer.GetNumber()));
      for (vtkIdType batch = first; batch < end; ++batch)
      {
        const int firstSlab = static_cast<int>(batch) * Batch;
        const int slabs = std::min(Batch, sweep.Slabs - firstSlab);
        for (const Block& block : blocks)
        {
          viewer.Add(block, firstSlab, slabs, masks);
        }
        for (int i = 0; i < slabs; ++i)
        {
          TileMask& mask = masks[static_cast<std::size_t>(i)];
          for (const Rectangle& rectangle : MakeRectangles(mask))
          {
            const std::size_t slab = static_cast<std::size_t>(firstSlab) + i;
            AddRectangle(viewer, rectangle, firstSlab + i, parts[slab]);
          }
          mask.Clear();
        }
      }
    });
  this->Join(parts);
  return isSuitable;
}

}
