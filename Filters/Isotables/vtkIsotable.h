// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIsotable_h
#define vtkIsotable_h

#include "InterlumeIsotablesModule.h" // for the export macro

#include <array>   // for the simplices
#include <atomic>  // for the cases
#include <cstdint> // for the slots
#include <memory>  // for the maker
#include <vector>  // for the lists

namespace interlume
{
class Polytope;
}

/**
 * @class   vtkIsotable
 * @brief   the case table of a three-dimensional cell, for isosurfaces or interval volumes
 *
 * Get() returns the table of a VTK cell; the constructor makes the table of any other convex cell.
 *
 * A case is keyed by one digit for each vertex, vertex 0 the least: in base 2 for a contour
 * (0: f < v, 1: f >= v), in base 3 for an interval (0: below, 1: inside, 2: above). A case is made
 * from convex hulls in integer arithmetic (P. Bhaniramka, R. Wenger, R. Crawfis, "Isosurface
 * construction in any dimension using convex hulls", IEEE TVCG 10(2), 2004), at its first use, by
 * the thread that requests it first. A reference to a case remains valid as long as the table.
 *
 * A point of a case is a slot: with n vertices and m edges, slot i < n is vertex i of the cell;
 * slot n + e is the isovalue (the lower one of an interval) on edge e; slot n + m + e is the upper
 * one on edge e. In an interval, a vertex that is inside is a point itself; a contour has none of
 * the first kind.
 *
 * Convex pieces are cut by pulling in an order of the slots: vertices first, then lower, then upper
 * crossings, each by the ranks of the edge's ends, the smaller rank first. When ranks come from
 * global point ids, any two cells cut the face they share alike. Simplices holds the cut for
 * ascending ranks, as structured grids have it; Cut() does any other.
 *
 * Each simplex is four slots, or three in a contour. To interpolate the point of slot n + e, use
 * the ends GetEdge(e).
 *
 * Vertex order: VTK_TETRA, VTK_PYRAMID, VTK_WEDGE, and VTK_VOXEL for the hexahedron. Tetrahedra
 * have positive volume in a right-handed cell; triangles of a contour have their normal towards
 * lower values; boundary triangles of an interval have it outward.
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
    NUMBER_OF_SHAPES
  };
  static constexpr int MaximumNumberOfVertices = 8;
  static constexpr int MaximumNumberOfSlots = 32;

  using Slot = std::uint8_t;
  /// The four slots of a tetrahedron, or the three of a contour's triangle (the last is unused).
  using Simplex = std::array<Slot, 4>;
  /// A boundary triangle of an interval, as three slots, and 0 at the lower side or 1 at the upper.
  using Triangle = std::array<Slot, 4>;
  using RankArray = std::array<Slot, MaximumNumberOfSlots>;

  struct Case
  {
    std::vector<Simplex> Simplices;
    std::vector<Triangle> Boundary;
    /// The slots in use, increasing.
    std::vector<Slot> Slots;
    /// The convex pieces, each as its number of points, points, number of faces, then for each face
    /// its side (0, 1 or NoSide), number of points, points in cyclic order. In a contour a piece is
    /// one face.
    std::vector<Slot> Pieces;
  };
  static constexpr Slot NoSide = 255;

  /// Returns the table shared by all users in the process.
  static const vtkIsotable& Get(Kinds kind, Shapes shape);

  /**
   * Makes the table of the convex hull of \a vertices. Its edges are in lexicographic order of
   * their vertices. The table is empty, with 0 cases, if a point is not a vertex of the hull, a
   * coordinate is odd or outside -128 ... 128, or there are more than 8 vertices or 32 slots.
   */
  vtkIsotable(Kinds kind, const std::vector<std::array<int, 3>>& vertices);

  /// Makes the table of a cell. For internal use.
  vtkIsotable(Kinds kind, const interlume::Polytope& cell);
  ~vtkIsotable();
  vtkIsotable(const vtkIsotable&) = delete;
  void operator=(const vtkIsotable&) = delete;

  Kinds GetKind() const { return this->Kind; }
  int GetNumberOfVertices() const { return this->NumberOfVertices; }
  int GetNumberOfEdges() const { return this->NumberOfEdges; }
  int GetNumberOfCases() const { return static_cast<int>(this->Cases.size()); }
  const std::array<Slot, 2>& GetEdge(int edge) const { return this->Edges[edge]; }

  /// Returns the case of \a key, 0 <= key < GetNumberOfCases().
  const Case& GetCase(int key) const
  {
    const Case* known = this->Cases[key].load(std::memory_order_acquire);
    return known ? *known : this->MakeCase(key);
  }

  /// Returns how many cases have been made so far.
  int GetNumberOfCasesMade() const;

  /**
   * Returns the order of slots for vertex ranks 0 ... n-1.
   */
  RankArray GetSlotRanks(const Slot* vertexRanks) const;

  /**
   * Cuts a case in the order given, calling simplex(const Simplex&) and boundary(const Triangle&).
   * \a ranks has a number for each slot of the case, as a RankArray has, which alone matters in its
   * order.
   */
  template <typename Ranks, typename SimplexVisitor, typename BoundaryVisitor>
  void Cut(const Case& what, const Ranks& ranks, SimplexVisitor&& simplex,
    BoundaryVisitor&& boundary) const
  {
    this->CutNamed(
      what, ranks, [](Slot slot) { return slot; }, simplex, boundary);
  }

  /**
   * Cuts a case in which slots are one point: \a same has for each slot the one that it goes by.
   * Slots are made one before anything is cut, so that a piece without volume leaves less; a
   * visited simplex may still have a slot twice.
   */
  template <typename SimplexVisitor, typename BoundaryVisitor>
  void CutMerged(const Case& what, const RankArray& ranks, const Slot* same,
    SimplexVisitor&& simplex, BoundaryVisitor&& boundary) const
  {
    this->CutNamed(
      what, ranks, [same](Slot slot) { return same[slot]; }, simplex, boundary);
  }

  /**
   * Cuts the faces of the pieces of an interval's case alone: calls triangle(a, b, c, slots,
   * number) for each triangle, outward, with the slots of the face that it is a part of.
   */
  template <typename Visitor>
  void CutSides(const Case& what, const RankArray& ranks, Visitor&& triangle) const
  {
    this->ForEachSide(what,
      [&](const Slot* slots, int number)
      {
        PullPolygon(
          slots, number, ranks, [](Slot slot) { return slot; },
          [&](Slot a, Slot b, Slot c) { triangle(a, b, c, slots, number); });
      });
  }

  /// Calls face(slots, number) for the faces of the pieces of an interval's case.
  template <typename Visitor>
  void ForEachSide(const Case& what, Visitor&& face) const
  {
    for (const Slot* at = what.Pieces.data(); at != what.Pieces.data() + what.Pieces.size();)
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
  void CutNamed(const Case& what, const Ranks& ranks, const Name& name, SimplexVisitor&& simplex,
    BoundaryVisitor&& boundary) const
  {
    for (const Slot* at = what.Pieces.data(); at != what.Pieces.data() + what.Pieces.size();)
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

  // Calls fan(a, b, c) for the triangles of a polygon coned from its first point.
  template <typename Ranks, typename Name, typename Fan>
  static void PullPolygon(
    const Slot* slots, int number, const Ranks& ranks, const Name& name, Fan&& fan)
  {
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
            simplex(Simplex{ { a, c, b, apex } });
          }
          if (side != NoSide)
          {
            boundary(Triangle{ { a, b, c, side } });
          }
        });
    }
    return at;
  }

  // Makes the pieces of cases from hulls.
  class Maker;

  const Case& MakeCase(int key) const;

  Kinds Kind;
  int NumberOfVertices;
  int NumberOfEdges;
  std::vector<std::array<Slot, 2>> Edges;
  std::unique_ptr<Maker> Pieces;
  mutable std::vector<std::atomic<const Case*>> Cases;
};

#endif
