// SPDX-License-Identifier: BSD-3-Clause
#include "Hulls/Polytope.h"

#include "Hulls/ConvexHull.h"
#include "Hulls/PointSet.h"

#include "vtkIsotable.h"

#include <algorithm>
#include <cstdlib>

namespace interlume
{

Polytope Polytope::Simplex(int dimension)
{
  Polytope cell;
  cell.Dimension = dimension;
  cell.Vertices.push_back(Point{});
  for (int axis = 0; axis < dimension; ++axis)
  {
    Point p{};
    p[axis] = 2;
    cell.Vertices.push_back(p);
  }
  for (int i = 0; i <= dimension; ++i)
  {
    for (int j = i + 1; j <= dimension; ++j)
    {
      cell.Edges.push_back({ { i, j } });
    }
  }
  return cell;
}

Polytope Polytope::Cube(int dimension)
{
  Polytope cell;
  cell.Dimension = dimension;
  for (int i = 0; i < (1 << dimension); ++i)
  {
    Point p{};
    for (int axis = 0; axis < dimension; ++axis)
    {
      p[axis] = 2 * ((i >> axis) & 1);
    }
    cell.Vertices.push_back(p);
  }
  for (int axis = 0; axis < dimension; ++axis)
  {
    const int half = 1 << axis;
    const std::vector<std::array<int, 2>> lower = cell.Edges;
    for (int i = 0; i < half; ++i)
    {
      cell.Edges.push_back({ { i, i + half } });
    }
    for (const auto& edge : lower)
    {
      cell.Edges.push_back({ { edge[0] + half, edge[1] + half } });
    }
  }
  return cell;
}

Polytope Polytope::Wedge()
{
  return Simplex(2).Prism();
}

Polytope Polytope::Pyramid()
{
  return FromVertices(3,
    { Point{ { 0, 0, 0 } }, Point{ { 2, 0, 0 } }, Point{ { 2, 2, 0 } }, Point{ { 0, 2, 0 } },
      Point{ { 0, 0, 2 } } });
}

Polytope Polytope::FromShape(int shape)
{
  switch (shape)
  {
    case vtkIsotable::TETRAHEDRON:
      return Simplex(3);
    case vtkIsotable::PYRAMID:
      return Pyramid();
    case vtkIsotable::WEDGE:
      return Wedge();
    case vtkIsotable::TRIANGLE:
      return Simplex(2);
    case vtkIsotable::QUADRILATERAL:
      return Cube(2);
    default:
      return Cube(3);
  }
}

Polytope Polytope::FromVertices(int dimension, const std::vector<Point>& vertices)
{
  if (vertices.size() > MaximumNumberOfVertices)
  {
    return {};
  }
  for (const Point& p : vertices)
  {
    for (int axis = 0; axis < dimension; ++axis)
    {
      if (p[axis] % 2 != 0 || std::abs(p[axis]) > MaximumCoordinate)
      {
        return {};
      }
    }
  }
  Polytope cell;
  cell.Dimension = dimension;
  cell.Vertices = vertices;
  const ConvexHull hull(dimension, vertices);
  const int n = static_cast<int>(vertices.size());
  for (int i = 0; i < n; ++i)
  {
    // A point is a vertex if the facets that contain it have no other point in common. Similarly, a
    // pair of points is an edge if the facets that contain both have no other point in common.
    if (hull.SmallestFace({ i }).Count() != 1)
    {
      return {};
    }
    for (int j = i + 1; j < n; ++j)
    {
      if (hull.SmallestFace({ i, j }).Count() == 2)
      {
        cell.Edges.push_back({ { i, j } });
      }
    }
  }
  return cell.Edges.size() <= MaximumNumberOfEdges ? cell : Polytope{};
}

Polytope Polytope::Prism() const
{
  Polytope prism = *this;
  prism.Dimension = this->Dimension + 1;
  const int n = static_cast<int>(this->Vertices.size());
  for (Point p : this->Vertices)
  {
    p[this->Dimension] = 2;
    prism.Vertices.push_back(p);
  }
  for (const auto& edge : this->Edges)
  {
    prism.Edges.push_back({ { edge[0] + n, edge[1] + n } });
  }
  for (int i = 0; i < n; ++i)
  {
    prism.Edges.push_back({ { i, i + n } });
  }
  return prism;
}

std::vector<std::array<std::uint8_t, 2>> Polytope::GetSortedEdges() const
{
  std::vector<std::array<std::uint8_t, 2>> edges;
  for (const auto& edge : this->Edges)
  {
    edges.push_back({ { static_cast<std::uint8_t>(std::min(edge[0], edge[1])),
      static_cast<std::uint8_t>(std::max(edge[0], edge[1])) } });
  }
  return edges;
}

Polytope::Point Polytope::Midpoint(int edge) const
{
  const Point& a = this->Vertices[this->Edges[edge][0]];
  const Point& b = this->Vertices[this->Edges[edge][1]];
  Point p{};
  for (int axis = 0; axis < this->Dimension; ++axis)
  {
    p[axis] = (a[axis] + b[axis]) / 2;
  }
  return p;
}

}
