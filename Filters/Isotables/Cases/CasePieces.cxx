// SPDX-License-Identifier: BSD-3-Clause
#include "Cases/CasePieces.h"

#include "Cases/CasePatch.h"
#include "Cases/SlotOrder.h"

#include <algorithm>

namespace interlume
{

// Collects the pieces of a patch, with their solids and polygons, from the facets of its hull.
class CasePieces::Builder
{
public:
  Builder(CasePieces& result, const CasePatch& patch, int numberOfVertices, int numberOfEdges)
    : Result(result)
    , Hull(patch.GetHull())
  {
    for (const int edge : patch.GetEdgesOfHullPoints())
    {
      const bool isPoint = edge >= 0;
      this->SlotOf.push_back(
        static_cast<Slot>(isPoint ? SlotOrder::GetSlot(numberOfVertices, numberOfEdges, edge) : 0));
      this->Positions.push_back(isPoint ? patch.GetCell().Midpoint(edge) : Point{});
    }
  }

  void AddPiece(const CasePatch::Facet& piece)
  {
    this->Neighbors.clear();
    for (const ConvexHull::Facet& facet : this->Hull.GetFacets())
    {
      if (facet.Points != piece.HullPoints && this->Hull.ShareRidge(facet.Points, piece.HullPoints))
      {
        this->Neighbors.push_back(&facet);
      }
    }
    const std::uint32_t pointsEnd = this->AddPoints(piece.HullPoints);
    for (const ConvexHull::Facet* neighbor : this->Neighbors)
    {
      this->AddSolid(piece, *neighbor);
    }
    this->Result.Pieces.push_back(
      { pointsEnd, static_cast<std::uint32_t>(this->Result.Solids.size()) });
  }

private:
  using Point = CasePatch::Point;
  using Normal = CasePatch::Normal;

  // Three axes onto which a solid projects one-to-one, and whether the projection preserves
  // orientation.
  struct Projection
  {
    std::array<int, 3> Axes;
    bool PreservesOrientation;
  };

  std::uint32_t AddPoints(const PointSet& face)
  {
    face.ForEach([this](int i) { this->Result.Points.push_back(this->SlotOf[i]); });
    return static_cast<std::uint32_t>(this->Result.Points.size());
  }

  // Each polygon of a solid is its intersection with another solid of the piece.
  void AddSolid(const CasePatch::Facet& piece, const ConvexHull::Facet& neighbor)
  {
    const PointSet solid = piece.HullPoints & neighbor.Points;
    this->Polygons.clear();
    for (const ConvexHull::Facet* other : this->Neighbors)
    {
      const PointSet shared = solid & other->Points;
      if (other != &neighbor && shared.HasAtLeast(3))
      {
        this->Polygons.push_back(shared);
      }
    }
    const std::uint32_t pointsEnd = this->AddPoints(solid);
    const Projection projection = Project(piece.Outward, neighbor.Outward);
    for (const PointSet& polygon : this->Polygons)
    {
      this->AddPolygon(polygon, (solid - polygon).GetFirst(), projection);
    }
    this->Result.Solids.push_back(
      { pointsEnd, static_cast<std::uint32_t>(this->Result.Polygons.size()) });
  }

  // Returns a projection of the solid shared by the two hull facets with these normals. Both
  // normals are orthogonal to the solid. The determinant of three vectors in the solid and the two
  // normals is a sum of products of complementary minors. The minors are proportional, so each
  // product has the sign of the sum. If the last point of a simplex is a point of the piece outside
  // the solid, it lies on the side opposite to the neighbor's normal.
  static Projection Project(const Normal& outward, const Normal& neighbor)
  {
    for (int k = 0;; ++k)
    {
      for (int l = k + 1; l < 5; ++l)
      {
        const std::int64_t minor = outward[k] * neighbor[l] - outward[l] * neighbor[k];
        if (minor != 0)
        {
          Projection projection{ {}, (minor > 0) == ((k + l) % 2 == 1) };
          for (int axis = 0, i = 0; axis < 5; ++axis)
          {
            if (axis != k && axis != l)
            {
              projection.Axes[i++] = axis;
            }
          }
          return projection;
        }
      }
    }
  }

  void AddPolygon(const PointSet& polygon, int inside, const Projection& projection)
  {
    this->Cycle.clear();
    polygon.ForEach([this](int i) { this->Cycle.push_back(i); });
    if (this->Cycle.size() > 3)
    {
      this->OrderPolygon(polygon);
    }
    if (!this->IsPositive(inside, projection))
    {
      std::swap(this->Cycle[0], this->Cycle[2]);
      std::reverse(this->Cycle.begin() + 3, this->Cycle.end());
    }
    for (const int i : this->Cycle)
    {
      this->Result.Points.push_back(this->SlotOf[i]);
    }
    this->Result.Polygons.push_back(static_cast<std::uint32_t>(this->Result.Points.size()));
  }

  bool IsPositive(int inside, const Projection& projection) const
  {
    std::array<std::array<int, 3>, 3> m;
    const Point& origin = this->Positions[this->Cycle[0]];
    const std::array<const Point*, 3> ends{ { &this->Positions[this->Cycle[1]],
      &this->Positions[this->Cycle[2]], &this->Positions[inside] } };
    for (int row = 0; row < 3; ++row)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int axis = projection.Axes[i];
        m[row][i] = (*ends[row])[axis] - origin[axis];
      }
    }
    const int determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
      m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
      m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return (determinant > 0) == projection.PreservesOrientation;
  }

  // An edge of a polygon is its intersection with another polygon of the solid.
  void OrderPolygon(const PointSet& polygon)
  {
    this->Sides.clear();
    for (const PointSet& other : this->Polygons)
    {
      const PointSet shared = polygon & other;
      if (other != polygon && shared.HasAtLeast(2))
      {
        this->Sides.push_back(shared);
      }
    }
    int at = this->Cycle[0];
    for (int& i : this->Cycle)
    {
      i = at;
      const auto side = std::find_if(this->Sides.begin(), this->Sides.end(),
        [at](const PointSet& set) { return set.Contains(at); });
      side->Remove(at);
      at = side->GetFirst();
      *side = this->Sides.back();
      this->Sides.pop_back();
    }
  }

  CasePieces& Result;
  const ConvexHull& Hull;
  /// Slot of each hull point.
  std::vector<Slot> SlotOf;
  std::vector<Point> Positions;
  /// Hull facets adjacent to the piece. Each shares one solid with it.
  std::vector<const ConvexHull::Facet*> Neighbors;
  std::vector<PointSet> Polygons;
  std::vector<PointSet> Sides;
  std::vector<int> Cycle;
};

CasePieces::CasePieces(const CasePatch& patch, int numberOfVertices, int numberOfEdges)
{
  Builder builder(*this, patch, numberOfVertices, numberOfEdges);
  for (const CasePatch::Facet& facet : patch.GetFacets())
  {
    builder.AddPiece(facet);
  }
  PointSet used;
  for (const Slot slot : this->Points)
  {
    used.Insert(slot);
  }
  used.ForEach([this](int slot) { this->Slots.push_back(static_cast<Slot>(slot)); });
  this->Slots.shrink_to_fit();
  this->Pieces.shrink_to_fit();
  this->Solids.shrink_to_fit();
  this->Polygons.shrink_to_fit();
  this->Points.shrink_to_fit();
}

std::size_t CasePieces::GetBytes() const
{
  return sizeof(*this) + this->Slots.capacity() + this->Points.capacity() +
    sizeof(Piece) * this->Pieces.capacity() + sizeof(Solid) * this->Solids.capacity() +
    sizeof(std::uint32_t) * this->Polygons.capacity();
}

}
