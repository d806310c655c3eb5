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
 * @brief   convex pieces of a case of a four-dimensional cell, for triangulation in any point order
 *
 * A piece is a four-dimensional facet of the patch. It is stored with its three-dimensional faces,
 * the solids, and their polygons in cyclic order. Pull() computes the pulling triangulation: the
 * first point of the piece is joined to each solid that does not contain this point. In the same
 * way, each solid is split by joining its first point to its polygons, and each polygon is split
 * into a fan of triangles from its first point.
 *
 * Slots are defined by SlotOrder.
 */
class CasePieces
{
public:
  using Slot = std::uint8_t;
  /// Slots of a 4-simplex.
  using Simplex = std::array<Slot, 5>;

  /// Properties of a point in a triangulation: its rank in the order (smallest first), the name
  /// that identifies it in the simplices, and one bit for each boundary (isosurface or time step)
  /// on which it lies.
  struct Label
  {
    std::uint16_t Rank;
    Slot Name;
    std::uint8_t Sides;
  };

  /// Collects the pieces of \a patch, whose cell is the prism over a four-dimensional cell. The
  /// four-dimensional cell has \a numberOfVertices vertices and \a numberOfEdges edges. Vertex
  /// coordinates must be in -32 ... 32.
  CasePieces(const CasePatch& patch, int numberOfVertices, int numberOfEdges);

  /// Returns the slots in use, in increasing order.
  const std::vector<Slot>& GetSlots() const { return this->Slots; }

  /**
   * Calls visit(const Simplex&) for each simplex of the triangulation. \a labels is indexed by
   * slot. Labels with different names must have different ranks. Slots with the same name are
   * merged into one point before the triangulation, so that a degenerate piece produces fewer
   * simplices. A visited simplex may still contain a name twice. Simplices have the orientation of
   * the patch (see CasePatch::IsPositive), or the opposite orientation if \a reverse is true.
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
          const std::uint32_t start = this->FindFirstIndex(points, labels);
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
   * Triangulates each solid whose points all have a bit of Label::Sides in common, in the same way
   * as Pull(). Calls solid(sides, points) for each tetrahedron, with the orientation that it has as
   * a face of a simplex of Pull(), and polygon(sides, sidesOfPolygon, points) for each triangle of
   * the solid's surface, oriented outward. \a sides contains the bits that all points of the solid
   * have in common, and \a sidesOfPolygon those of the polygon that contains the triangle.
   */
  template <typename SolidVisitor, typename PolygonVisitor>
  void TriangulateSides(
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
          const std::uint32_t start = this->FindFirstIndex(points, labels);
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

  /// Returns the memory size in bytes.
  std::size_t GetBytes() const;

private:
  // End indices in the arrays of points, solids and polygons. Each range starts at the end of the
  // previous one. The points of a piece precede those of its solids, and the points of a solid
  // precede those of its polygons.
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

  std::uint32_t FindFirstIndex(const Range& range, const Label* labels) const
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
    return this->Points[this->FindFirstIndex(range, labels)];
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
