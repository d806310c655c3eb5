// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Tables/FacetTriangulation.h"

#include "Hulls/IntegerAlgebra.h"

#include <algorithm>
#include <map>

using namespace interlume;

namespace
{
using PointList = FacetTriangulation::PointList;

// Computes pulling triangulations. Caches the triangulation of each face, since neighboring faces
// share lower-dimensional faces.
class Puller
{
public:
  Puller(const CasePatch& patch, const std::vector<int>& rank)
    : Patch(patch)
    , Rank(rank)
  {
  }

  const std::vector<PointList>& Pull(const PointSet& face)
  {
    const auto known = this->Known.find(face);
    if (known != this->Known.end())
    {
      return known->second;
    }
    std::vector<PointList> simplices;
    const PointList points = this->Patch.GetEdges(face);
    if (points.size() == 1)
    {
      simplices.push_back(points);
    }
    else
    {
      const int first = *std::min_element(points.begin(), points.end(),
        [this](int a, int b) { return this->Rank[a] < this->Rank[b]; });
      for (const PointSet& side : this->Patch.GetFacetsOfFace(face))
      {
        const PointList sidePoints = this->Patch.GetEdges(side);
        if (std::find(sidePoints.begin(), sidePoints.end(), first) != sidePoints.end())
        {
          continue;
        }
        for (PointList simplex : this->Pull(side))
        {
          simplex.insert(simplex.begin(), first);
          simplices.push_back(simplex);
        }
      }
    }
    return this->Known.emplace(face, simplices).first->second;
  }

private:
  const CasePatch& Patch;
  const std::vector<int>& Rank;
  std::map<PointSet, std::vector<PointList>> Known;
};

// Computes a placing triangulation. The points placed first may all lie in a lower-dimensional
// subspace.
class Placer
{
public:
  explicit Placer(const Polytope& cell)
    : Cell(cell)
    , Affine(cell.Dimension)
  {
  }

  void Place(int point)
  {
    const bool grows = this->Affine.Insert(this->Cell.Midpoint(point));
    if (this->Simplices.empty())
    {
      this->Simplices.push_back({ point });
    }
    else if (grows)
    {
      for (PointList& simplex : this->Simplices)
      {
        simplex.push_back(point);
      }
    }
    else
    {
      this->JoinVisible(point);
    }
  }

  std::vector<PointList> Simplices;

private:
  // A face of a simplex and the vertex of the simplex that is opposite to it.
  struct Face
  {
    PointList Points;
    int Opposite;
  };

  std::int64_t GetOrientation(const PointList& face, int point) const
  {
    const std::vector<int>& pivots = this->Affine.GetPivots();
    const IntegerAlgebra::Point origin = this->Cell.Midpoint(face[0]);
    IntegerAlgebra::Normal rows[IntegerAlgebra::MaximumDimension];
    for (std::size_t i = 1; i < face.size(); ++i)
    {
      rows[i - 1] = IntegerAlgebra::Difference(this->Cell.Midpoint(face[i]), origin);
    }
    rows[face.size() - 1] = IntegerAlgebra::Difference(this->Cell.Midpoint(point), origin);
    return IntegerAlgebra::Determinant(rows, pivots.data(), static_cast<int>(pivots.size()));
  }

  void JoinVisible(int point)
  {
    std::vector<Face> faces;
    for (const PointList& simplex : this->Simplices)
    {
      for (std::size_t skip = 0; skip < simplex.size(); ++skip)
      {
        Face face{ simplex, simplex[skip] };
        face.Points.erase(face.Points.begin() + skip);
        std::sort(face.Points.begin(), face.Points.end());
        faces.push_back(face);
      }
    }
    std::sort(
      faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.Points < b.Points; });
    for (std::size_t i = 0; i < faces.size();)
    {
      if (i + 1 < faces.size() && faces[i].Points == faces[i + 1].Points)
      {
        i += 2;
        continue;
      }
      const std::int64_t inside = this->GetOrientation(faces[i].Points, faces[i].Opposite);
      const std::int64_t there = this->GetOrientation(faces[i].Points, point);
      if ((inside > 0 && there < 0) || (inside < 0 && there > 0))
      {
        this->Simplices.push_back(faces[i].Points);
        this->Simplices.back().push_back(point);
      }
      ++i;
    }
  }

  const Polytope& Cell;
  IntegerAlgebra::Span Affine;
};
}

std::vector<PointList> FacetTriangulation::TriangulateFacet(const CasePatch& patch,
  const CasePatch::Facet& facet, Methods method, const std::vector<int>& rank)
{
  std::vector<PointList> simplices;
  if (method == PULLING)
  {
    simplices = Puller(patch, rank).Pull(facet.HullPoints);
  }
  else
  {
    PointList points = facet.Points;
    std::sort(points.begin(), points.end(), [&rank](int a, int b) { return rank[a] < rank[b]; });
    Placer placer(patch.GetCell());
    for (int point : points)
    {
      placer.Place(point);
    }
    simplices = placer.Simplices;
  }
  for (PointList& simplex : simplices)
  {
    if (!patch.IsPositive(facet, simplex))
    {
      std::swap(simplex[0], simplex[1]);
    }
  }
  return simplices;
}

std::vector<PointList> FacetTriangulation::Triangulate(
  const CasePatch& patch, Methods method, const std::vector<int>& rank)
{
  std::vector<PointList> simplices;
  for (const CasePatch::Facet& facet : patch.GetFacets())
  {
    const std::vector<PointList> some = TriangulateFacet(patch, facet, method, rank);
    simplices.insert(simplices.end(), some.begin(), some.end());
  }
  return simplices;
}
