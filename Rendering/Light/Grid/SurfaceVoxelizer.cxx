// SPDX-License-Identifier: BSD-3-Clause
#include "Grid/SurfaceVoxelizer.h"

#include "Common/Vectors.h"
#include "Grid/ExtinctionGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{
using Polygon = std::vector<glm::dvec3>;

// Returns the part of a polygon on the nonnegative side of a plane.
Polygon Cut(const Polygon& polygon, const glm::dvec4& plane)
{
  Polygon part;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3& here = polygon[i];
    const glm::dvec3& next = polygon[(i + 1) % polygon.size()];
    const double from = glm::dot(plane, glm::dvec4(here, 1.0));
    const double to = glm::dot(plane, glm::dvec4(next, 1.0));
    if (from >= 0.0)
    {
      part.push_back(here);
    }
    if ((from < 0.0) != (to < 0.0))
    {
      part.push_back(here + from / (from - to) * (next - here));
    }
  }
  return part;
}

Polygon Cut(const Polygon& polygon, int axis, double lower, double upper)
{
  glm::dvec4 plane(0.0);
  plane[axis] = 1.0;
  plane.w = -lower;
  const Polygon above = Cut(polygon, plane);
  plane[axis] = -1.0;
  plane.w = upper;
  return Cut(above, plane);
}

// Marks the cells that polygons intersect. Polygons are in cell coordinates.
class Marker
{
public:
  explicit Marker(ScatteringMedium& medium)
    : Medium(medium)
  {
  }

  void Mark(const Polygon& polygon, int axis, glm::ivec3 cell)
  {
    if (polygon.empty())
    {
      return;
    }
    double lower = polygon[0][axis];
    double upper = lower;
    for (const glm::dvec3& corner : polygon)
    {
      lower = std::min(lower, corner[axis]);
      upper = std::max(upper, corner[axis]);
    }
    const int maximum = this->Medium.Cells[axis] - 1;
    const int first = std::clamp(static_cast<int>(std::floor(lower)), 0, maximum);
    const int last = std::clamp(static_cast<int>(std::ceil(upper)) - 1, first, maximum);
    for (int i = first; i <= last; ++i)
    {
      cell[axis] = i;
      if (axis == 2)
      {
        this->Medium.Blocked[this->Medium.GetIndex(cell)] = 1;
      }
      else
      {
        this->Mark(first == last ? polygon : Cut(polygon, axis, i, i + 1.0), axis + 1, cell);
      }
    }
  }

private:
  ScatteringMedium& Medium;
};
}

void SurfaceVoxelizer::Mark(const std::vector<glm::dvec3>& corners,
  const std::vector<glm::dvec4>& planes, const glm::dmat4& worldFromUnit, ExtinctionGrid& grid)
{
  // Surfaces within this distance from the faces of the box, in cells, are ignored.
  constexpr double margin = 1e-6;
  ScatteringMedium& medium = grid.GetMedium();
  const glm::dmat4 unitFromWorld = glm::inverse(worldFromUnit);
  Marker marker(medium);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    Polygon polygon(corners.begin() + static_cast<std::ptrdiff_t>(i),
      corners.begin() + static_cast<std::ptrdiff_t>(i + 3));
    if (!std::all_of(polygon.begin(), polygon.end(), Vectors::IsFinite))
    {
      continue;
    }
    for (const glm::dvec4& plane : planes)
    {
      polygon = Cut(polygon, plane);
    }
    for (glm::dvec3& corner : polygon)
    {
      corner = grid.FromUnit(glm::dvec3(unitFromWorld * glm::dvec4(corner, 1.0))) / medium.CellSize;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      polygon = Cut(polygon, axis, margin, medium.Cells[axis] - margin);
    }
    if (!polygon.empty())
    {
      medium.Blocked.resize(medium.GetNumberOfCells(), 0);
      marker.Mark(polygon, 0, glm::ivec3(0));
    }
  }
}

}
