// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CasePieces_h
#define interlume_CasePieces_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace interlume
{

class CasePatch;

/**
 * @class   CasePieces
 * @brief   the convex pieces of one case of a four-dimensional cell, ready to be cut in any order
 *
 * A piece is a facet of the patch in five dimensions, and is kept with its faces: its solids, their
 * polygons in cyclic order. Pull() cuts it as FacetTriangulation::PULLING does: it is coned
 * from its first point over its solids without it, each of which is coned from its first point over
 * its polygons without it, each of which is a fan from its first point.
 *
 * Slots are those of SlotOrder.
 */
class CasePieces
{
public:
  using Slot = std::uint8_t;
  /// The slots of a 4-simplex.
  using Simplex = std::array<Slot, 5>;

  /// The properties of a point of the pieces in a cut: its place in the order, the least first, the
  /// name it goes by in the simplices, and bits for the sides that it is on.
  struct Label
  {
    std::uint16_t Rank;
    Slot Name;
    std::uint8_t Sides;
  };

  /// Collects the pieces of the patch of a lifted cell with that many vertices and edges before it
  /// was lifted, and coordinates from -32 to 32.
  CasePieces(const CasePatch& patch, int numberOfVertices, int numberOfEdges);

  /// Returns the slots in use, increasing.
  const std::vector<Slot>& GetSlots() const { return this->Slots; }

  /**
   * Calls visit(const Simplex&) for every simplex of the cut. \a labels has one entry for each slot
   * in use; ranks of different names must be distinct. Slots of one name are one point: they are
   * made one before anything is cut, so that a piece without hypervolume leaves less; a visited
   * simplex may still have a name twice. Simplices have the orientation of the patch (see
   * CasePatch::IsPositive), or the opposite one if \a reverse.
   */
  template <typename Visitor>
  void Pull(const Label* labels, bool reverse, Visitor&& visit) const
  {
    const int second = reverse ? 2 : 1;
    std::uint32_t solid = 0;
    std::uint32_t polygon = 0;
    Range points{ 0, 0 };
    for (const Piece& piece : this->Pieces)
    {
      points = { points.End, piece.PointsEnd };
      const Slot apex = this->FindFirst(points, labels);
      for (; solid < piece.SolidsEnd; ++solid)
      {
        points = { points.End, this->Solids[solid].PointsEnd };
        const Slot first = this->FindFirst(points, labels);
        if (labels[first].Name == labels[apex].Name)
        {
          polygon = this->Solids[solid].PolygonsEnd;
          points.End = this->Polygons[polygon - 1];
          continue;
        }
        for (; polygon < this->Solids[solid].PolygonsEnd; ++polygon)
        {
          points = { points.End, this->Polygons[polygon] };
          const std::uint32_t start = this->FindFirstPlace(points, labels);
          if (labels[this->Points[start]].Name == labels[first].Name)
          {
            continue;
          }
          Simplex simplex;
          simplex[0] = labels[this->Points[start]].Name;
          simplex[3] = labels[first].Name;
          simplex[4] = labels[apex].Name;
          std::uint32_t at = this->GetNext(points, start);
          Slot before = labels[this->Points[at]].Name;
          for (std::uint32_t i = points.Begin + 2; i < points.End; ++i)
          {
            at = this->GetNext(points, at);
            simplex[second] = before;
            before = labels[this->Points[at]].Name;
            simplex[3 - second] = before;
            visit(static_cast<const Simplex&>(simplex));
          }
        }
      }
    }
  }

  /**
   * Cuts the solids whose points are all on one side as Pull() does. Calls solid(sides, points) for
   * each of their tetrahedra, outward as the face of a simplex of Pull() that leaves out its last
   * point, and polygon(sides, sidesOfPolygon, points) for the triangles around such a solid,
   * outward from it. \a sides are the sides that all points of the solid are on.
   */
  template <typename SolidVisitor, typename PolygonVisitor>
  void PullSides(
    const Label* labels, bool reverse, SolidVisitor&& solid, PolygonVisitor&& polygon) const
  {
    std::uint32_t s = 0;
    std::uint32_t p = 0;
    Range points{ 0, 0 };
    for (const Piece& piece : this->Pieces)
    {
      points.End = piece.PointsEnd;
      for (; s < piece.SolidsEnd; ++s)
      {
        points = { points.End, this->Solids[s].PointsEnd };
        const std::uint8_t sides = this->FindSides(points, labels);
        const Slot first = labels[this->FindFirst(points, labels)].Name;
        if (sides == 0)
        {
          p = this->Solids[s].PolygonsEnd;
          points.End = this->Polygons[p - 1];
          continue;
        }
        for (; p < this->Solids[s].PolygonsEnd; ++p)
        {
          points = { points.End, this->Polygons[p] };
          const std::uint8_t sidesOfPolygon = this->FindSides(points, labels);
          const std::uint32_t start = this->FindFirstPlace(points, labels);
          const Slot name = labels[this->Points[start]].Name;
          std::uint32_t at = this->GetNext(points, start);
          for (std::uint32_t i = points.Begin + 2; i < points.End; ++i)
          {
            Slot b = labels[this->Points[at]].Name;
            at = this->GetNext(points, at);
            Slot c = labels[this->Points[at]].Name;
            if (reverse)
            {
              std::swap(b, c);
            }
            if (name != first)
            {
              solid(sides, std::array<Slot, 4>{ { name, b, c, first } });
            }
            polygon(sides, sidesOfPolygon, std::array<Slot, 3>{ { name, c, b } });
          }
        }
      }
    }
  }

  /// Returns the memory held, in bytes.
  std::size_t GetBytes() const;

private:
  // The ends of the lists of points, solids and polygons; each begins at the end of the one before,
  // and the points of a face come before those of its own faces.
  struct Piece
  {
    std::uint32_t PointsEnd;
    std::uint32_t SolidsEnd;
  };
  struct Solid
  {
    std::uint32_t PointsEnd;
    std::uint32_t PolygonsEnd;
  };
  struct Range
  {
    std::uint32_t Begin;
    std::uint32_t End;
  };

  std::uint32_t FindFirstPlace(const Range& range, const Label* labels) const
  {
    std::uint32_t first = range.Begin;
    for (std::uint32_t i = range.Begin + 1; i < range.End; ++i)
    {
      first = labels[this->Points[i]].Rank < labels[this->Points[first]].Rank ? i : first;
    }
    return first;
  }

  Slot FindFirst(const Range& range, const Label* labels) const
  {
    return this->Points[this->FindFirstPlace(range, labels)];
  }

  std::uint8_t FindSides(const Range& range, const Label* labels) const
  {
    unsigned sides = labels[this->Points[range.Begin]].Sides;
    for (std::uint32_t i = range.Begin + 1; i < range.End; ++i)
    {
      sides &= labels[this->Points[i]].Sides;
    }
    return static_cast<std::uint8_t>(sides);
  }

  static std::uint32_t GetNext(const Range& range, std::uint32_t at)
  {
    return at + 1 == range.End ? range.Begin : at + 1;
  }

  class Builder;

  std::vector<Slot> Slots;
  std::vector<Piece> Pieces;
  std::vector<Solid> Solids;
  std::vector<std::uint32_t> Polygons;
  std::vector<Slot> Points;
};

}

#endif
