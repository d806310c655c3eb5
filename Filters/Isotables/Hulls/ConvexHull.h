// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ConvexHull_h
#define interlume_ConvexHull_h

#include "Hulls/PointSet.h"
#include "Hulls/Polytope.h"

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace interlume
{

/**
 * @class   ConvexHull
 * @brief   exact facets of the convex hull of integer points
 *
 * Builds the hull incrementally in integer arithmetic. All points on a supporting hyperplane form
 * one facet, so the result does not depend on the order of the points. Supports at most 128 points,
 * in 2 to 6 dimensions.
 */
class ConvexHull
{
public:
  using Point = Polytope::Point;
  using Normal = std::array<std::int64_t, Polytope::MaximumDimension>;

  struct Facet
  {
    /// All points on the hyperplane of the facet.
    PointSet Points;
    /// Outward normal, not normalized.
    Normal Outward;
  };

  /// Computes the hull. There are no facets if the points lie on one hyperplane.
  ConvexHull(int dimension, const std::vector<Point>& points);

  const std::vector<Facet>& GetFacets() const { return this->Facets; }

  /**
   * Returns whether two facets, given by their points, share a ridge (a face of dimension d - 2):
   * no third facet contains all of their common points.
   */
  bool ShareRidge(const PointSet& a, const PointSet& b) const;

  /// Returns the points of the smallest face that contains all of \a points.
  PointSet SmallestFace(std::initializer_list<int> points) const;

  /**
   * Returns the facets of a face, given by its points: the maximal proper intersections of the face
   * with facets of the hull, sorted by PointSet::operator<.
   */
  std::vector<PointSet> GetFacetsOfFace(const PointSet& face) const;

private:
  int Dimension;
  std::vector<Facet> Facets;
};

}

#endif
