#include "vtkIsotableHull.h"

#include "vtkIsotableAlgebra.h"

#include <algorithm>

namespace
{
using namespace vtkIsotableAlgebra;
using Point = vtkIsotableHull::Point;
using Normal = vtkIsotableHull::Normal;

// A simplicial facet of the growing hull.
struct Simplex
{
  std::array<int, MaximumDimension> Vertices;
  Normal Outward;
  std::int64_t Offset;
};

// Affinely independent points, greedily in order; fewer than dimension + 1 for flat input.
std::vector<int> FindSpanningPoints(int dimension, const std::vector<Point>& points)
{
  std::vector<int> chosen;
  Span span(dimension);
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
  {
    if (span.Insert(points[i]))
    {
      chosen.push_back(i);
    }
  }
  return chosen;
}

class Builder
{
public:
  Builder(int dimension, const std::vector<Point>& points)
    : Dimension(dimension)
    , Points(points)
  {
  }

  bool Build()
  {
    const std::vector<int> start = FindSpanningPoints(this->Dimension, this->Points);
    if (static_cast<int>(start.size()) <= this->Dimension)
    {
      return false;
    }
    for (int i : start)
    {
      for (int axis = 0; axis < this->Dimension; ++axis)
      {
        this->Inside[axis] += this->Points[i][axis];
      }
    }
    for (int skip = 0; skip <= this->Dimension; ++skip)
    {
      std::array<int, MaximumDimension> vertices{};
      for (int i = 0, n = 0; i <= this->Dimension; ++i)
      {
        if (i != skip)
        {
          vertices[n++] = start[i];
        }
      }
      this->AddSimplex(vertices);
    }
    for (int i = 0; i < static_cast<int>(this->Points.size()); ++i)
    {
      if (std::find(start.begin(), start.end(), i) == start.end())
      {
        this->AddPoint(i);
      }
    }
    return true;
  }

  std::vector<Simplex> Simplices;

private:
  // The vertices of a simplex stay sorted, so that equal ridges are equal arrays.
  std::array<int, MaximumDimension> Insert(std::array<int, MaximumDimension> ridge, int point) const
  {
    int at = this->Dimension - 1;
    for (; at > 0 && ridge[at - 1] > point; --at)
    {
      ridge[at] = ridge[at - 1];
    }
    ridge[at] = point;
    return ridge;
  }

  void AddSimplex(const std::array<int, MaximumDimension>& vertices)
  {
    Simplex simplex;
    simplex.Vertices = vertices;
    std::array<Normal, MaximumDimension - 1> rows{};
    for (int i = 1; i < this->Dimension; ++i)
    {
      rows[i - 1] = Difference(this->Points[vertices[i]], this->Points[vertices[0]]);
    }
    simplex.Outward = CrossProduct(this->Dimension, rows);
    simplex.Offset = Dot(this->Dimension, simplex.Outward, this->Points[vertices[0]]);
    // Inside is the sum of dimension + 1 points.
    if (Dot(this->Dimension, simplex.Outward, this->Inside) >
      simplex.Offset * (this->Dimension + 1))
    {
      for (std::int64_t& value : simplex.Outward)
      {
        value = -value;
      }
      simplex.Offset = -simplex.Offset;
    }
    this->Simplices.push_back(simplex);
  }

  void AddPoint(int point)
  {
    const auto firstVisible = std::partition(this->Simplices.begin(), this->Simplices.end(),
      [&](const Simplex& simplex)
      { return Dot(this->Dimension, simplex.Outward, this->Points[point]) <= simplex.Offset; });
    // The horizon: ridges of exactly one visible simplex.
    this->Ridges.clear();
    for (auto simplex = firstVisible; simplex != this->Simplices.end(); ++simplex)
    {
      for (int skip = 0; skip < this->Dimension; ++skip)
      {
        std::array<int, MaximumDimension> ridge{};
        for (int i = 0, n = 0; i < this->Dimension; ++i)
        {
          if (i != skip)
          {
            ridge[n++] = simplex->Vertices[i];
          }
        }
        this->Ridges.push_back(ridge);
      }
    }
    this->Simplices.erase(firstVisible, this->Simplices.end());
    std::sort(this->Ridges.begin(), this->Ridges.end());
    for (std::size_t i = 0; i < this->Ridges.size();)
    {
      if (i + 1 < this->Ridges.size() && this->Ridges[i] == this->Ridges[i + 1])
      {
        i += 2;
        continue;
      }
      this->AddSimplex(Insert(this->Ridges[i], point));
      ++i;
    }
  }

  int Dimension;
  const std::vector<Point>& Points;
  Point Inside{};
  std::vector<std::array<int, MaximumDimension>> Ridges;
};
}

vtkIsotableHull::vtkIsotableHull(int dimension, const std::vector<Point>& points)
{
  Builder builder(dimension, points);
  if (points.size() > vtkIsotablePointSet::Capacity || !builder.Build())
  {
    return;
  }
  for (const Simplex& simplex : builder.Simplices)
  {
    Facet facet;
    facet.Outward = simplex.Outward;
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
    {
      if (Dot(dimension, simplex.Outward, points[i]) == simplex.Offset)
      {
        facet.Points.Insert(i);
      }
    }
    this->Facets.push_back(facet);
  }
  const auto byPoints = [](const Facet& a, const Facet& b) { return a.Points < b.Points; };
  const auto samePoints = [](const Facet& a, const Facet& b) { return a.Points == b.Points; };
  std::sort(this->Facets.begin(), this->Facets.end(), byPoints);
  this->Facets.erase(
    std::unique(this->Facets.begin(), this->Facets.end(), samePoints), this->Facets.end());
}

vtkIsotablePointSet vtkIsotableHull::SmallestFace(std::initializer_list<int> points) const
{
  vtkIsotablePointSet wanted;
  for (int i : points)
  {
    wanted.Insert(i);
  }
  vtkIsotablePointSet common;
  bool any = false;
  for (const Facet& facet : this->Facets)
  {
    if (wanted.IsSubsetOf(facet.Points))
    {
      common = any ? (common & facet.Points) : facet.Points;
      any = true;
    }
  }
  return common;
}

std::vector<vtkIsotablePointSet> vtkIsotableHull::FacetsOf(const vtkIsotablePointSet& face) const
{
  std::vector<vtkIsotablePointSet> result;
  for (const Facet& facet : this->Facets)
  {
    const vtkIsotablePointSet common = face & facet.Points;
    if (!common.IsEmpty() && common != face)
    {
      result.push_back(common);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  const std::vector<vtkIsotablePointSet> all = result;
  const auto isInside = [&all](const vtkIsotablePointSet& set)
  {
    return std::any_of(all.begin(), all.end(),
      [&set](const vtkIsotablePointSet& other) { return set != other && set.IsSubsetOf(other); });
  };
  result.erase(std::remove_if(result.begin(), result.end(), isInside), result.end());
  return result;
}
