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
 * @brief   one case of an isotable: the isosurface patch inside a cell for given vertex signs
 *
 * The patch consists of the facets of the convex hull of { positive vertices } and { midpoints of
 * edges whose ends differ in sign } that do not lie in a facet of the cell (Bhaniramka, Wenger,
 * Crawfis 2004). These are the facets without positive vertices. Each patch point is identified by
 * its edge.
 */
class CasePatch
{
public:
  /// Patch points, given as indices of cell edges.
  using PointList = std::vector<int>;
  using Point = ConvexHull::Point;
  using Normal = ConvexHull::Normal;

  struct Facet
  {
    PointSet HullPoints;
    /// Patch points of the facet, sorted by edge index.
    PointList Points;
    /// Normal that points from the positive to the negative side.
    Normal Outward;
  };

  /// Returns which vertices are positive in the case with the vtkIsotable key \a key. For an
  /// interval, these are the vertices of the lifted cell, the prism over the cell.
  static std::vector<bool> GetSigns(int numberOfVertices, bool isInterval, std::uint32_t key);

  /// Computes the patch. \a positive has one entry per vertex of \a cell.
  CasePatch(const Polytope& cell, const std::vector<bool>& positive);

  const Polytope& GetCell() const { return this->Cell; }
  const std::vector<Facet>& GetFacets() const { return this->Facets; }
  const ConvexHull& GetHull() const { return this->Hull; }

  /**
   * For a four-dimensional cell, returns the faces of a facet, which is a polyhedron. Each face is
   * a polygon in cyclic order, counterclockwise as seen from outside the polyhedron.
   */
  std::vector<PointList> GetFaces(const Facet& facet) const;

  /**
   * For a three-dimensional cell, returns a facet as a polygon in cyclic order, counterclockwise as
   * seen from the negative side.
   */
  PointList GetPolygon(const Facet& facet) const;

  /// Returns the facets of a face of the hull, as sets of hull points.
  std::vector<PointSet> GetFacetsOfFace(const PointSet& face) const;

  /// Returns the cell edge that each hull point bisects, or -1 for a positive vertex.
  const std::vector<int>& GetEdgesOfHullPoints() const { return this->EdgeOfPoint; }

  /// Returns the entries of GetEdgesOfHullPoints() for a set of hull points.
  PointList GetEdges(const PointSet& face) const;

  /**
   * Returns whether a simplex has the orientation of the facet: det(p1 - p0, ..., outward) is
   * positive. The simplex has as many points as the cell has dimensions. The determinant is never
   * zero for a simplex of the facet.
   */
  bool IsPositive(const Facet& facet, const PointList& simplex) const;

private:
  PointList OrderPolygonPoints(const PointSet& polygon) const;

  Polytope Cell;
  std::vector<int> EdgeOfPoint;
  ConvexHull Hull;
  std::vector<Facet> Facets;
};

}

#endif
