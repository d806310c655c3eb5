// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIsotable_h
#define vtkIsotable_h

#include "InterlumeIsotablesModule.h" // for the export macro

#include <array>   // for the simplices
#include <atomic>  // for the cases
#include <cstdint> // for the slots
#include <memory>  // for the case builder
#include <vector>  // for the lists

namespace interlume
{
class Polytope;
}

/**
 * @class   vtkIsotable
 * @brief   case table of a cell, for isosurfaces or interval volumes
 *
 * Get() returns the table of a VTK cell. The constructor creates the table of any other convex
 * three-dimensional cell. Cases are computed from convex hulls in integer arithmetic at their first
 * use (P. Bhaniramka, R. Wenger, R. Crawfis, "Isosurface construction in any dimension using convex
 * hulls", IEEE TVCG 10(2), 2004). Any thread may request a case. A reference to a case remains
 * valid as long as the table exists. See Documentation/methods/isotables.md.
 *
 * The key of a case has one digit per vertex; the digit of vertex 0 is the least significant.
 * Contours use base 2 (0: below the isovalue, 1: at or above it). Intervals use base 3 (0: below
 * the interval, 1: inside, 2: above).
 *
 * The points of a case are numbered as slots. With n vertices and m edges, slot i < n is vertex i
 * of the cell. Slot n + e is the point on edge e with the isovalue, or with the lower isovalue of
 * an interval. Slot n + m + e is the point on edge e with the upper isovalue. In an interval, a
 * vertex that is inside is itself a point. Contours use no vertex slots. The point of slot n + e is
 * interpolated between the ends of the edge, GetEdge(e).
 *
 * Convex pieces are split into simplices by a pulling triangulation, which depends on the order of
 * the slots: vertices first, then lower, then upper edge points. Vertices are ordered by their
 * ranks. Edge points are ordered by the smaller rank of their edge's ends, then by the larger one.
 * If ranks come from global point ids, any two cells split a shared face identically.
 * Case::Simplices is the triangulation for ascending ranks, as on structured grids. Cut() computes
 * the triangulation for other ranks.
 *
 * A simplex has four slots, or three in a contour. The vertices of a cell are in the order of
 * VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, and VTK_VOXEL for the hexahedron. In a right-handed cell,
 * tetrahedra have positive volume. Normals of contour triangles point toward lower values. Normals
 * of boundary triangles point out of the interval.
 *
 * Two-dimensional cells have interval tables only; their contour tables have no cases. Vertices are
 * in the order of VTK_TRIANGLE, and VTK_PIXEL for the quadrilateral. A simplex is a triangle with
 * the orientation of the cell. Its boundary consists of line segments with the interval to their
 * left, given as two slots, the second one repeated, and the side.
 *
 * @sa vtkIsotableContour vtkIntervalVolume
 */
class INTERLUMEISOTABLES_EXPORT vtkIsotable
{
public:
  enum Kinds
  {
    CONTOUR,
    INTERVAL
  };
  enum Shapes
  {
    TETRAHEDRON,
    PYRAMID,
    WEDGE,
    HEXAHEDRON,
    /// Number of three-dimensional shapes, which precede the others.
    NUMBER_OF_SOLIDS,
    TRIANGLE = NUMBER_OF_SOLIDS,
    QUADRILATERAL,
    NUMBER_OF_SHAPES
  };
  static constexpr int MaximumNumberOfVertices = 8;
  static constexpr int MaximumNumberOfSlots = 32;

  using Slot = std::uint8_t;
  /// Slots of a tetrahedron or a triangle (the fourth entry is unused).
  using Simplex = std::array<Slot, 4>;
  /// Boundary triangle of an interval: three slots, then 0 for the lower or 1 for the upper side.
  using Triangle = std::array<Slot, 4>;
  using RankArray = std::array<Slot, MaximumNumberOfSlots>;

  struct Case
  {
    std::vector<Simplex> Simplices;
    std::vector<Triangle> Boundary;
    /// Slots in use, in increasing order.
    std::vector<Slot> Slots;
    /// Convex pieces. A piece of an interval is stored as its number of points, its points, its
    /// number of faces, and for each face its side (0, 1 or NoSide), its number of points, and its
    /// points in cyclic order. The faces of a polygon are its sides. A piece of a contour is one
    /// face: its number of points and its points.
    std::vector<Slot> Pieces;
  };
  static constexpr Slot NoSide = 255;

  /// Return the table of a VTK cell, shared by all users in the process.
  static const vtkIsotable& Get(Kinds kind, Shapes shape);

  /**
   * Create the table of the convex hull of \a vertices. Edges are in lexicographic order of their
   * vertices. The table is empty (0 cases) if a point is not a vertex of the hull, if a coordinate
   * is odd or outside -128 ... 128, or if there are more than 8 vertices or 32 slots.
   */
  vtkIsotable(Kinds kind, const std::vector<std::array<int, 3>>& vertices);

  /// Create the table of a cell. For internal use.
  vtkIsotable(Kinds kind, const interlume::Polytope& cell);
  ~vtkIsotable();
  vtkIsotable(const vtkIsotable&) = delete;
  void operator=(const vtkIsotable&) = delete;

  Kinds GetKind() const { return this->Kind; }
  /// Return the number of points of a simplex: 4 for a tetrahedron, 3 for a triangle.
  int GetSimplexSize() const { return this->SimplexSize; }
  int GetNumberOfVertices() const { return this->NumberOfVertices; }
  int GetNumberOfEdges() const { return this->NumberOfEdges; }
  int GetNumberOfCases() const { return static_cast<int>(this->Cases.size()); }
  const std::array<Slot, 2>& GetEdge(int edge) const { return this->Edges[edge]; }

  /// Return the case of \a key, 0 <= key < GetNumberOfCases().
  const Case& GetCase(int key) const
  {
    const Case* known = this->Cases[key].load(std::memory_order_acquire);
    return known ? *known : this->MakeCase(key);
  }

  /// Return the number of cases computed so far.
  int GetNumberOfCasesMade() const;

  /**
   * Return the ranks of the slots. \a vertexRanks is a permutation of the vertex indices.
   */
  RankArray GetSlotRanks(const Slot* vertexRanks) const;

  /**
   * Triangulate a case in a given order. Calls simplex(const Simplex&) and boundary(const
   * Triangle&). \a ranks, for example a RankArray, has a number for each slot of the case; only the
   * order of the numbers matters.
   */
  template <typename Ranks, typename SimplexVisitor, typename BoundaryVisitor>
  void Cut(const Case& source, const Ranks& ranks, SimplexVisitor&& simplex,
    BoundaryVisitor&& boundary) const
  {
    this->CutNamed(
      source, ranks, [](Slot slot) { return slot; }, simplex, boundary);
  }

  /**
   * Triangulate a case in which some slots coincide. \a same contains the representative of each
   * slot. Coincident slots are merged before the triangulation, so that a piece without volume
   * produces fewer simplices. A visited simplex may still contain a slot twice.
   */
  template <typename SimplexVisitor, typename BoundaryVisitor>
  void CutMerged(const Case& source, const RankArray& ranks, const Slot* same,
    SimplexVisitor&& simplex, BoundaryVisitor&& boundary) const
  {
    this->CutNamed(
      source, ranks, [same](Slot slot) { return same[slot]; }, simplex, boundary);
  }

  /**
   * Triangulate only the faces of the pieces of an interval case. Calls triangle(a, b, c, slots,
   * number) for each outward triangle, with the slots of the face that contains it. For a side of a
   * polygon, c is equal to b.
   */
  template <typename Visitor>
  void CutSides(const Case& source, const RankArray& ranks, Visitor&& triangle) const
  {
    this->ForEachSide(source,
      [&](const Slot* slots, int number)
      {
        PullPolygon(
          slots, number, ranks, [](Slot slot) { return slot; },
          [&](Slot a, Slot b, Slot c) { triangle(a, b, c, slots, number); });
      });
  }

  /// Call face(slots, number) for each face of the pieces of an interval case.
  template <typename Visitor>
  void ForEachSide(const Case& source, Visitor&& face) const
  {
    for (const Slot* at = source.Pieces.data(); at != source.Pieces.data() + source.Pieces.size();)
    {
      at += 1 + at[0];
      for (int faces = *at++; faces > 0; --faces)
      {
        const int number = at[1];
        const Slot* slots = at + 2;
        at = slots + number;
        face(slots, number);
      }
    }
  }

private:
  template <typename Ranks, typename Name, typename SimplexVisitor, typename BoundaryVisitor>
  void CutNamed(const Case& source, const Ranks& ranks, const Name& name, SimplexVisitor&& simplex,
    BoundaryVisitor&& boundary) const
  {
    for (const Slot* at = source.Pieces.data(); at != source.Pieces.data() + source.Pieces.size();)
    {
      at = this->Kind == CONTOUR ? CutPolygon(at, ranks, name, simplex)
                                 : CutSolid(at, ranks, name, simplex, boundary);
    }
  }

  template <typename Ranks, typename Name>
  static Slot First(const Slot* slots, int number, const Ranks& ranks, const Name& name)
  {
    Slot first = name(slots[0]);
    for (int i = 1; i < number; ++i)
    {
      const Slot slot = name(slots[i]);
      first = ranks[slot] < ranks[first] ? slot : first;
    }
    return first;
  }

  // Splits a polygon into a fan around its point of lowest rank. Calls fan(a, b, c) for each
  // triangle, or fan(a, b, b) for two points.
  template <typename Ranks, typename Name, typename Fan>
  static void PullPolygon(
    const Slot* slots, int number, const Ranks& ranks, const Name& name, Fan&& fan)
  {
    if (number == 2)
    {
      fan(name(slots[0]), name(slots[1]), name(slots[1]));
      return;
    }
    int start = 0;
    for (int i = 1; i < number; ++i)
    {
      start = ranks[name(slots[i])] < ranks[name(slots[start])] ? i : start;
    }
    int b = start + 1 == number ? 0 : start + 1;
    for (int i = 2; i < number; ++i)
    {
      const int c = b + 1 == number ? 0 : b + 1;
      fan(name(slots[start]), name(slots[b]), name(slots[c]));
      b = c;
    }
  }

  template <typename Ranks, typename Name, typename SimplexVisitor>
  static const Slot* CutPolygon(
    const Slot* at, const Ranks& ranks, const Name& name, SimplexVisitor&& simplex)
  {
    const int number = at[0];
    PullPolygon(at + 1, number, ranks, name,
      [&simplex](Slot a, Slot b, Slot c) {
        simplex(Simplex{ { a, b, c, 0 } });
      });
    return at + 1 + number;
  }

  template <typename Ranks, typename Name, typename SimplexVisitor, typename BoundaryVisitor>
  static const Slot* CutSolid(const Slot* at, const Ranks& ranks, const Name& name,
    SimplexVisitor&& simplex, BoundaryVisitor&& boundary)
  {
    const Slot apex = First(at + 1, at[0], ranks, name);
    at += 1 + at[0];
    int faces = *at++;
    while (faces-- > 0)
    {
      const Slot side = at[0];
      const int number = at[1];
      const Slot* slots = at + 2;
      at = slots + number;
      bool holdsApex = false;
      for (int i = 0; i < number; ++i)
      {
        holdsApex |= name(slots[i]) == apex;
      }
      if (holdsApex && side == NoSide)
      {
        continue;
      }
      PullPolygon(slots, number, ranks, name,
        [&](Slot a, Slot b, Slot c)
        {
          if (!holdsApex)
          {
            simplex(number == 2 ? Simplex{ { a, b, apex, 0 } } : Simplex{ { a, c, b, apex } });
          }
          if (side != NoSide)
          {
            boundary(Triangle{ { a, b, c, side } });
          }
        });
    }
    return at;
  }

  // Computes cases from convex hulls and symmetries.
  class Builder;

  const Case& MakeCase(int key) const;

  Kinds Kind;
  int SimplexSize;
  int NumberOfVertices;
  int NumberOfEdges;
  std::vector<std::array<Slot, 2>> Edges;
  std::unique_ptr<Builder> Pieces;
  mutable std::vector<std::atomic<const Case*>> Cases;
};

#endif
