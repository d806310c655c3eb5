// SPDX-License-Identifier: BSD-3-Clause
#include "Cases/CasePatch.h"

#include "Hulls/IntegerAlgebra.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace interlume
{

namespace
{
std::vector<CasePatch::Point> CollectHullPoints(
  const Polytope& cell, const std::vector<bool>& positive, std::vector<int>& edgeOfPoint)
{
  std::vector<CasePatch::Point> points;
  for (std::size_t i = 0; i < cell.Vertices.size(); ++i)
  {
    if (positive[i])
    {
      points.push_back(cell.Vertices[i]);
      edgeOfPoint.push_back(-1);
    }
  }
  for (std::size_t e = 0; e < cell.Edges.size(); ++e)
  {
    if (positive[cell.Edges[e][0]] != positive[cell.Edges[e][1]])
    {
      points.push_back(cell.Midpoint(static_cast<int>(e)));
      edgeOfPoint.push_back(static_cast<int>(e));
    }
  }
  return points;
}
}

std::vector<bool> CasePatch::GetSigns(int numberOfVertices, bool isInterval, std::uint32_t key)
{
  const std::uint32_t base = isInterval ? 3 : 2;
  std::vector<bool> positive(isInterval ? 2 * numberOfVertices : numberOfVertices);
  for (int v = 0; v < numberOfVertices; ++v, key /= base)
  {
    positive[v] = key % base >= 1;
    if (isInterval)
    {
      positive[v + numberOfVertices] = key % base == 2;
    }
  }
  return positive;
}

CasePatch::CasePatch(const Polytope& cell, const std::vector<bool>& positive)
  : Cell(cell)
  , Hull(cell.Dimension, CollectHullPoints(cell, positive, EdgeOfPoint))
{
  for (const ConvexHull::Facet& hullFacet : this->Hull.GetFacets())
  {
    Facet facet{ hullFacet.Points, this->GetEdges(hullFacet.Points), hullFacet.Outward };
    if (facet.Points.front() >= 0)
    {
      this->Facets.push_back(facet);
    }
  }
}

CasePatch::PointList CasePatch::GetEdges(const PointSet& face) const
{
  PointList edges;
  edges.reserve(face.Count());
  face.ForEach([&](int i) { edges.push_back(this->EdgeOfPoint[i]); });
  return edges;
}

std::vector<PointSet> CasePatch::GetFacetsOfFace(const PointSet& face) const
{
  return this->Hull.GetFacetsOfFace(face);
}

bool CasePatch::IsPositive(const Facet& facet, const PointList& simplex) const
{
  using namespace IntegerAlgebra;
  const int dimension = this->Cell.Dimension;
  IntegerAlgebra::Normal rows[MaximumDimension];
  int columns[MaximumDimension];
  const Point origin = this->Cell.Midpoint(simplex[0]);
  for (int i = 1; i < dimension; ++i)
  {
    rows[i - 1] = Difference(this->Cell.Midpoint(simplex[i]), origin);
  }
  rows[dimension - 1] = facet.Outward;
  std::iota(columns, columns + dimension, 0);
  return Determinant(rows, columns, dimension) > 0;
}

CasePatch::PointList CasePatch::OrderPolygonPoints(const PointSet& polygon) const
{
  std::vector<std::array<int, 2>> sides;
  sides.reserve(polygon.Count());
  for (PointSet side : this->GetFacetsOfFace(polygon))
  {
    const int first = side.GetFirst();
    side.Remove(first);
    sides.push_back({ { this->EdgeOfPoint[first], this->EdgeOfPoint[side.GetFirst()] } });
  }
  PointList chain;
  chain.reserve(sides.size());
  chain.assign(sides.back().begin(), sides.back().end());
  sides.pop_back();
  while (sides.size() > 1)
  {
    const int last = chain.back();
    const auto next = std::find_if(sides.begin(), sides.end(),
      [last](const std::array<int, 2>& side) { return side[0] == last || side[1] == last; });
    chain.push_back((*next)[0] == last ? (*next)[1] : (*next)[0]);
    sides.erase(next);
  }
  return chain;
}

CasePatch::PointList CasePatch::GetPolygon(const Facet& facet) const
{
  PointList polygon = this->OrderPolygonPoints(facet.HullPoints);
  if (!this->IsPositive(facet, { polygon[0], polygon[1], polygon[2] }))
  {
    std::reverse(polygon.begin(), polygon.end());
  }
  return polygon;
}

std::vector<CasePatch::PointList> CasePatch::GetFaces(const Facet& facet) const
{
  std::vector<PointList> faces;
  faces.reserve(this->Hull.GetFacets().size());
  for (const PointSet& face : this->GetFacetsOfFace(facet.HullPoints))
  {
    PointList polygon = this->OrderPolygonPoints(face);
    const auto inside = std::find_if(facet.Points.begin(), facet.Points.end(),
      [&](int edge) { return std::find(polygon.begin(), polygon.end(), edge) == polygon.end(); });
    if (this->IsPositive(facet, { polygon[0], polygon[1], polygon[2], *inside }))
    {
      std::reverse(polygon.begin(), polygon.end());
    }
    faces.push_back(polygon);
  }
  return faces;
}

}
