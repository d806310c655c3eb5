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
 * @brief   the facets of the convex hull of lattice points, exactly
 *
 * Builds the hull incrementally in integer arithmetic. Points on one hyperplane form one facet,
 * however many they are: the result does not depend on the order of the points. At most 128 points,
 * in 2 to 6 dimensions.
 */
class ConvexHull
{
public:
  using Point = Polytope::Point;
  using Normal = std::array<std::int64_t, Polytope::MaximumDimension>;

  struct Facet
  {
    /// All points on the facet's hyperplane.
    PointSet Points;
    /// The outward normal, not normalised to a length.
    Normal Outward;
  };

  /// Computes the hull. It has no facets when the points lie on one hyperplane.
  ConvexHull(int dimension, const std::vector<Point>& points);

  const std::vector<Facet>& GetFacets() const { return this->Facets; }

  /**
   * Returns whether two facets, given by their points, meet in a ridge, a face of one dimension
   * less: no third facet holds all points that they share.
   */
  bool IsRidge(const PointSet& a, const PointSet& b) const;

  /// Returns the points of the smallest face that holds all of \a points.
  PointSet SmallestFace(std::initializer_list<int> points) const;

  /**
   * Returns the facets of the face \a face, which is given by its points: the maximal proper
   * intersections with facets of the hull, in increasing order of point sets.
   */
  std::vector<PointSet> FacetsOf(const PointSet& face) const;

private:
  int Dimension;
  std::vector<Facet> Facets;
};

}

#endif
