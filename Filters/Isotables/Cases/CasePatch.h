// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CasePatch_h
#define interlume_CasePatch_h

#include "Hulls/ConvexHull.h"
#include "Hulls/Polytope.h"

#include <cstdint>
#include <vector>

namespace interlume
{

/**
 * @class   CasePatch
 * @brief   one case of an isotable: the isosurface patch inside a cell for given signs
 *
 * The patch is made of the facets of the convex hull of { positive vertices } and { midpoints of
 * the edges whose ends differ in sign } that lie in no facet of the cell (Bhaniramka, Wenger,
 * Crawfis 2004). These are the facets without a positive vertex. A patch point is named by its
 * edge.
 */
class CasePatch
{
public:
  /// A list of patch points, each the index of an edge of the cell.
  using PointList = std::vector<int>;
  using Point = ConvexHull::Point;
  using Normal = ConvexHull::Normal;

  struct Facet
  {
    PointSet HullPoints;
    /// The points of the patch, in increasing order of edges.
    PointList Points;
    /// The normal that points from the positive side to the negative.
    Normal Outward;
  };

  /// Returns which vertices are positive in the case of a key of vtkIsotable: those of the lifted
  /// cell of an interval, of the cell itself for a contour.
  static std::vector<bool> GetSigns(int numberOfVertices, bool isInterval, std::uint32_t key);

  /// Computes the patch. \a positive has one entry for each vertex of \a cell.
  CasePatch(const Polytope& cell, const std::vector<bool>& positive);

  const Polytope& GetCell() const { return this->Cell; }
  const std::vector<Facet>& GetFacets() const { return this->Facets; }
  const ConvexHull& GetHull() const { return this->Hull; }

  /**
   * Returns the faces of a facet in four dimensions, a solid, as polygons in cyclic order, seen
   * counterclockwise from outside of the solid.
   */
  std::vector<PointList> GetFaces(const Facet& facet) const;

  /**
   * Returns a facet in three dimensions as a polygon in cyclic order, seen counterclockwise from
   * the negative side.
   */
  PointList GetPolygon(const Facet& facet) const;

  /// Returns the faces of any face of the hull, as sets of hull points.
  std::vector<PointSet> GetFacesOf(const PointSet& face) const;

  /// Returns for each hull point the edge it stands for, or -1 for a positive vertex.
  const std::vector<int>& GetEdgesOfHullPoints() const { return this->EdgeOfPoint; }

  /// Returns the edges that a set of hull points stands for.
  PointList GetEdges(const PointSet& face) const;

  /**
   * Returns whether the simplex of dimension d - 1 with these points has the orientation of the
   * facet: the sign of det(p1 - p0, ..., outward). Zero never occurs for a simplex of the facet.
   */
  bool IsPositive(const Facet& facet, const PointList& simplex) const;

private:
  PointList ChainPolygon(const PointSet& polygon) const;

  Polytope Cell;
  std::vector<int> EdgeOfPoint;
  ConvexHull Hull;
  std::vector<Facet> Facets;
};

}

#endif
