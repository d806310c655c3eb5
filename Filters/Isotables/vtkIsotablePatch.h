// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIsotablePatch_h
#define vtkIsotablePatch_h

#include "InterlumeIsotablesModule.h" // for the export macro
#include "vtkIsotableHull.h"          // for the facets
#include "vtkIsotablePolytope.h"      // for the cell

#include <vector> // for the lists

/**
 * @class   vtkIsotablePatch
 * @brief   one case of an isotable: the isosurface patch inside a cell for given signs
 *
 * The patch is made of the facets of the convex hull of { positive vertices } and { midpoints of
 * the edges whose ends differ in sign } that lie in no facet of the cell (Bhaniramka, Wenger,
 * Crawfis 2004). These are the facets without a positive vertex. A patch point is named by its
 * edge.
 */
class INTERLUMEISOTABLES_EXPORT vtkIsotablePatch
{
public:
  /// A list of patch points, each the index of an edge of the cell.
  using PointList = std::vector<int>;
  using Point = vtkIsotableHull::Point;
  using Normal = vtkIsotableHull::Normal;

  struct Facet
  {
    vtkIsotablePointSet HullPoints;
    /// The points of the patch, in increasing order of edges.
    PointList Points;
    /// The normal that points from the positive side to the negative.
    Normal Outward;
  };

  /// Computes the patch. \a positive has one entry for each vertex of \a cell.
  vtkIsotablePatch(const vtkIsotablePolytope& cell, const std::vector<bool>& positive);

  const vtkIsotablePolytope& GetCell() const { return this->Cell; }
  const std::vector<Facet>& GetFacets() const { return this->Facets; }
  const vtkIsotableHull& GetHull() const { return this->Hull; }

  /**
   * Returns the faces of a facet, one dimension less. In four dimensions, where a facet is a solid,
   * its polygons are in cyclic order and seen counterclockwise from outside of the solid.
   */
  std::vector<PointList> GetFaces(const Facet& facet) const;

  /**
   * Returns a facet in three dimensions as a polygon in cyclic order, seen counterclockwise from
   * the negative side.
   */
  PointList GetPolygon(const Facet& facet) const;

  /// Returns the faces of any face of the hull, as sets of hull points.
  std::vector<vtkIsotablePointSet> GetFacesOf(const vtkIsotablePointSet& face) const;

  /// Returns for each hull point the edge it stands for, or -1 for a positive vertex.
  const std::vector<int>& GetEdgesOfHullPoints() const { return this->EdgeOfPoint; }

  /// Returns the edges that a set of hull points stands for.
  PointList GetEdges(const vtkIsotablePointSet& face) const;

  /**
   * Returns whether the simplex of dimension d - 1 with these points has the orientation of the
   * facet: the sign of det(p1 - p0, ..., outward). Zero never occurs for a simplex of the facet.
   */
  bool IsPositive(const Facet& facet, const PointList& simplex) const;

private:
  PointList ChainPolygon(const vtkIsotablePointSet& polygon) const;

  vtkIsotablePolytope Cell;
  std::vector<int> EdgeOfPoint;
  vtkIsotableHull Hull;
  std::vector<Facet> Facets;
};

#endif
