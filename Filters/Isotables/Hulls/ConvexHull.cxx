// SPDX-License-Identifier: BSD-3-Clause
#include "Hulls/ConvexHull.h"

#include "Hulls/IntegerAlgebra.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace interlume
{

namespace
{
using namespace IntegerAlgebra;
using Point = ConvexHull::Point;
using Normal = ConvexHull::Normal;

// A facet of the current hull: Outward * x <= Offset.
struct Face
{
  Normal Outward;
  std::int64_t Offset;
  // Signed height of the point being added, positive above the facet.
  std::int64_t Height;
  PointSet Points;
};

// Finds affinely independent points, greedily in order. If there are fewer than dimension + 1, all
// points lie in one hyperplane.
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

// Returns whether two facets share a ridge: no third facet contains all of their common points.
template <typename FaceType>
bool MeetInRidge(
  int dimension, const std::vector<FaceType>& faces, const PointSet& a, const PointSet& b)
{
  const PointSet shared = a & b;
  return shared.HasAtLeast(dimension - 1) &&
    std::none_of(faces.begin(), faces.end(),
      [&](const FaceType& other)
      { return shared.IsSubsetOf(other.Points) && other.Points != a && other.Points != b; });
}

// Returns whether a * x + b * y cannot overflow.
bool CanCombine(int dimension, std::int64_t a, const Normal& x, std::int64_t b, const Normal& y)
{
  constexpr std::int64_t limit = std::int64_t(1) << 30;
  bool fits = a < limit && b < limit;
  for (int axis = 0; axis < dimension; ++axis)
  {
    fits = fits && std::abs(x[axis]) < limit && std::abs(y[axis]) < limit;
  }
  return fits;
}

// Builds the hull by the double description method. A facet stores all points on its hyperplane.
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
    PointSet simplex;
    for (int i : start)
    {
      simplex.Insert(i);
    }
    for (int i : start)
    {
      PointSet side = simplex;
      side.Remove(i);
      this->Faces.push_back(this->MakeFace(side, i));
    }
    for (int i = 0; i < static_cast<int>(this->Points.size()); ++i)
    {
      if (!simplex.Contains(i))
      {
        this->AddPoint(i);
      }
    }
    return true;
  }

  std::vector<Face> Faces;

private:
  // Creates the facet on the hyperplane that \a points span. \a inside is a point below the facet.
  Face MakeFace(const PointSet& points, int inside) const
  {
    const Point& origin = this->Points[points.GetFirst()];
    std::array<Normal, MaximumDimension - 1> rows{};
    int number = 0;
    Span span(this->Dimension);
    points.ForEach(
      [&](int i)
      {
        if (span.Insert(this->Points[i]) && i != points.GetFirst())
        {
          rows[number++] = Difference(this->Points[i], origin);
        }
      });
    Face face{ CrossProduct(this->Dimension, rows), 0, 0, points };
    face.Offset = Dot(this->Dimension, face.Outward, origin);
    if (Dot(this->Dimension, face.Outward, this->Points[inside]) > face.Offset)
    {
      for (std::int64_t& value : face.Outward)
      {
        value = -value;
      }
      face.Offset = -face.Offset;
    }
    return face;
  }

  // Creates the facet through a point and the ridge between two facets. The point is above the
  // first facet and below the second.
  Face MakeFace(const Face& above, const Face& below, int point) const
  {
    PointSet points = above.Points & below.Points;
    points.Insert(point);
    const std::int64_t common = std::gcd(above.Height, below.Height);
    const std::int64_t a = above.Height / common;
    const std::int64_t b = -below.Height / common;
    if (!CanCombine(this->Dimension, a, below.Outward, b, above.Outward))
    {
      return this->MakeFace(points, (below.Points - points).GetFirst());
    }
    Face face{ {}, 0, 0, points };
    std::int64_t divisor = 0;
    for (int axis = 0; axis < this->Dimension; ++axis)
    {
      face.Outward[axis] = a * below.Outward[axis] + b * above.Outward[axis];
      divisor = divisor == 1 ? 1 : std::gcd(divisor, face.Outward[axis]);
    }
    for (int axis = 0; axis < this->Dimension && divisor > 1; ++axis)
    {
      face.Outward[axis] /= divisor;
    }
    face.Offset = Dot(this->Dimension, face.Outward, this->Points[point]);
    return face;
  }

  void AddPoint(int point)
  {
    for (Face& face : this->Faces)
    {
      face.Height = Dot(this->Dimension, face.Outward, this->Points[point]) - face.Offset;
      if (face.Height == 0)
      {
        face.Points.Insert(point);
      }
    }
    const auto firstAbove = std::partition(
      this->Faces.begin(), this->Faces.end(), [](const Face& face) { return face.Height <= 0; });
    this->Added.clear();
    for (auto above = firstAbove; above != this->Faces.end(); ++above)
    {
      for (auto below = this->Faces.begin(); below != firstAbove; ++below)
      {
        if (below->Height < 0 &&
          MeetInRidge(this->Dimension, this->Faces, above->Points, below->Points))
        {
          this->Added.push_back(this->MakeFace(*above, *below, point));
        }
      }
    }
    this->Faces.erase(firstAbove, this->Faces.end());
    this->Faces.insert(this->Faces.end(), this->Added.begin(), this->Added.end());
  }

  int Dimension;
  const std::vector<Point>& Points;
  std::vector<Face> Added;
};
}

ConvexHull::ConvexHull(int dimension, const std::vector<Point>& points)
  : Dimension(dimension)
{
  if (points.size() > PointSet::Capacity)
  {
    return;
  }
  Builder builder(dimension, points);
  if (!builder.Build())
  {
    return;
  }
  this->Facets.reserve(builder.Faces.size());
  for (const Face& face : builder.Faces)
  {
    this->Facets.push_back({ face.Points, face.Outward });
  }
  std::sort(this->Facets.begin(), this->Facets.end(),
    [](const Facet& a, const Facet& b) { return a.Points < b.Points; });
}

bool ConvexHull::ShareRidge(const PointSet& a, const PointSet& b) const
{
  return MeetInRidge(this->Dimension, this->Facets, a, b);
}

PointSet ConvexHull::SmallestFace(std::initializer_list<int> points) const
{
  PointSet required;
  for (int i : points)
  {
    required.Insert(i);
  }
  PointSet common;
  bool any = false;
  for (const Facet& facet : this->Facets)
  {
    if (required.IsSubsetOf(facet.Points))
    {
      common = any ? (common & facet.Points) : facet.Points;
      any = true;
    }
  }
  return common;
}

std::vector<PointSet> ConvexHull::GetFacetsOfFace(const PointSet& face) const
{
  std::vector<PointSet> result;
  result.reserve(this->Facets.size());
  for (const Facet& facet : this->Facets)
  {
    const PointSet common = face & facet.Points;
    if (!common.IsEmpty() && common != face)
    {
      result.push_back(common);
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  const std::vector<PointSet> all = result;
  const auto isInside = [&all](const PointSet& set)
  {
    return std::any_of(all.begin(), all.end(),
      [&set](const PointSet& other) { return set != other && set.IsSubsetOf(other); });
  };
  result.erase(std::remove_if(result.begin(), result.end(), isInside), result.end());
  return result;
}

}
