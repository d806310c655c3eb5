// SPDX-License-Identifier: BSD-3-Clause
#include "Termination/TerminationGrid.h"

#include "Cells/MultilinearCell.h"
#include "Common/Batches.h"
#include "Common/Vectors.h"

#include "vtkSMPTools.h"
#include "vtkTerminationSurface.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace
{
// Number of bisection steps that locate the border between a node inside the part and a node
// outside.
constexpr int Halvings = 40;
// On an edge shared with another part, the normal is evaluated slightly inside the part. This is
// the shift, as a fraction of the distance to the center of parameter space.
constexpr double Inset = 1e-6;
// Minimum ratio of a triangle's height to its longest side. Below it, the triangle is degenerate,
// for example at the pole of a sphere.
constexpr double Flatness = 1e-12;
}

TerminationGrid::TerminationGrid(
  const vtkTerminationSurface* surface, int part, int columns, int rows)
  : Surface(surface)
  , Part(part)
  , Columns(columns)
  , Rows(rows)
{
}

void TerminationGrid::FillPoint(Point& point) const
{
  const double* x = point.Position;
  double inner[3];
  if (this->Surface->EvaluatePart(x) != this->Part)
  {
    const double uv[2] = { point.Parameters[0] + Inset * (0.5 - point.Parameters[0]),
      point.Parameters[1] + Inset * (0.5 - point.Parameters[1]) };
    x = this->Surface->EvaluatePoint(this->Part, uv, inner) ? inner : x;
  }
  this->Surface->EvaluateNormal(x, point.Normal);
}

void TerminationGrid::MakeNode(int i, int j)
{
  Node& node = this->At(i, j);
  node = {};
  node.Self.Parameters[0] = static_cast<double>(i) / this->Columns;
  node.Self.Parameters[1] = static_cast<double>(j) / this->Rows;
  node.IsInside =
    this->Surface->EvaluatePoint(this->Part, node.Self.Parameters, node.Self.Position);
  if (node.IsInside)
  {
    this->FillPoint(node.Self);
  }
}

void TerminationGrid::MakeCrossings(int i, int j)
{
  Node& node = this->At(i, j);
  for (int direction = 0; direction < 2; ++direction)
  {
    const int nextI = i + (direction == 0 ? 1 : 0);
    const int nextJ = j + (direction == 1 ? 1 : 0);
    if (nextI > this->Columns || nextJ > this->Rows ||
      this->At(nextI, nextJ).IsInside == node.IsInside)
    {
      continue;
    }
    const Node& next = this->At(nextI, nextJ);
    Point inside = node.IsInside ? node.Self : next.Self;
    double outside = (node.IsInside ? next : node).Self.Parameters[direction];
    for (int step = 0; step < Halvings; ++step)
    {
      Point midpoint = inside;
      midpoint.Parameters[direction] = 0.5 * (inside.Parameters[direction] + outside);
      if (this->Surface->EvaluatePoint(this->Part, midpoint.Parameters, midpoint.Position))
      {
        inside = midpoint;
      }
      else
      {
        outside = midpoint.Parameters[direction];
      }
    }
    this->FillPoint(inside);
    node.Crossings[direction] = inside;
    node.HasCrossing[direction] = true;
  }
}

void TerminationGrid::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
{
  const Point& first = this->Points[a];
  const Point& second = this->Points[b];
  const Point& third = this->Points[c];
  glm::dvec3 sides[3] = { Vectors::Difference(second.Position, first.Position),
    Vectors::Difference(third.Position, first.Position),
    Vectors::Difference(third.Position, second.Position) };
  // Scale lengths to about 1 so that squared areas do not overflow.
  const double scale = MultilinearCell::GetScale(
    std::max(Vectors::InfinityNorm(sides[0]), Vectors::InfinityNorm(sides[1])));
  double longest = 0.0;
  for (glm::dvec3& side : sides)
  {
    side *= scale;
    longest = std::max(longest, glm::dot(side, side));
  }
  const glm::dvec3 cross = glm::cross(sides[0], sides[1]);
  if (!(glm::length(cross) > Flatness * longest))
  {
    ++this->FlatTriangles;
    return;
  }
  const double* facet = glm::value_ptr(cross);
  const double facing = Vectors::Dot(facet, first.Normal) + Vectors::Dot(facet, second.Normal) +
    Vectors::Dot(facet, third.Normal);
  if (facing < 0.0)
  {
    std::swap(b, c);
  }
  this->Triangles.push_back({ { a, b, c } });
}

void TerminationGrid::ClipCell(int i, int j)
{
  // The vertices of the clipped cell are its corners inside the part and the border crossings on
  // its edges.
  std::vector<vtkIdType> polygon;
  const auto addNode = [this, &polygon](int column, int row)
  {
    const Node& node = this->At(column, row);
    if (node.IsInside)
    {
      polygon.push_back(node.Ids[0]);
    }
  };
  const auto addCrossing = [this, &polygon](int column, int row, int direction)
  {
    const Node& node = this->At(column, row);
    if (node.HasCrossing[direction])
    {
      polygon.push_back(node.Ids[1 + direction]);
    }
  };
  addNode(i, j);
  addCrossing(i, j, 0);
  addNode(i + 1, j);
  addCrossing(i + 1, j, 1);
  addNode(i + 1, j + 1);
  addCrossing(i, j + 1, 0);
  addNode(i, j + 1);
  addCrossing(i, j, 1);
  for (std::size_t k = 2; k < polygon.size(); ++k)
  {
    this->AddTriangle(polygon[0], polygon[k - 1], polygon[k]);
  }
}

bool TerminationGrid::Execute(vtkAlgorithm* owner, double start, double end)
{
  this->Nodes.resize((this->Columns + 1) * static_cast<std::size_t>(this->Rows + 1));
  const auto visit = [this](void (TerminationGrid::*method)(int, int))
  {
    return [this, method](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType j = first; j < last; ++j)
      {
        for (int i = 0; i <= this->Columns; ++i)
        {
          (this->*method)(i, static_cast<int>(j));
        }
      }
    };
  };
  const double midpoint = 0.5 * (start + end);
  if (!Batches::Run(this->Rows + 1, owner, start, midpoint, visit(&TerminationGrid::MakeNode)) ||
    !Batches::Run(this->Rows + 1, owner, midpoint, end, visit(&TerminationGrid::MakeCrossings)))
  {
    return false;
  }
  const auto addPoint = [this](const Point& point)
  {
    this->Points.push_back(point);
    return static_cast<vtkIdType>(this->Points.size()) - 1;
  };
  for (Node& node : this->Nodes)
  {
    node.Ids[0] = node.IsInside ? addPoint(node.Self) : -1;
    for (int direction = 0; direction < 2; ++direction)
    {
      node.Ids[1 + direction] =
        node.HasCrossing[direction] ? addPoint(node.Crossings[direction]) : -1;
      this->BorderPoints += node.HasCrossing[direction] ? 1 : 0;
    }
  }
  for (int j = 0; j < this->Rows; ++j)
  {
    for (int i = 0; i < this->Columns; ++i)
    {
      this->ClipCell(i, j);
    }
  }
  return true;
}

}
