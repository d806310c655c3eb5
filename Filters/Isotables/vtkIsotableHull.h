// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkIsotableHull_h
#define vtkIsotableHull_h

#include "InterlumeIsotablesModule.h" // for the export macro
#include "vtkIsotablePointSet.h"      // for the faces
#include "vtkIsotablePolytope.h"      // for the points

#include <cstdint>          // for the normals
#include <initializer_list> // for the faces
#include <vector>           // for the lists

/**
 * @class   vtkIsotableHull
 * @brief   the facets of the convex hull of lattice points, exactly
 *
 * Builds the hull incrementally in integer arithmetic. Points on one hyperplane form one facet,
 * however many they are: the result does not depend on the order of the points. At most 128 points,
 * in 2 to 6 dimensions.
 */
class INTERLUMEISOTABLES_EXPORT vtkIsotableHull
{
public:
  using Point = vtkIsotablePolytope::Point;
  using Normal = std::array<std::int64_t, vtkIsotablePolytope::MaximumDimension>;

  struct Facet
  {
    /// All points on the facet's hyperplane.
    vtkIsotablePointSet Points;
    /// The outward normal, not normalised to a length.
    Normal Outward;
  };

  /// Computes the hull. It has no facets when the points lie on one hyperplane.
  vtkIsotableHull(int dimension, const std::vector<Point>& points);

  const std::vector<Facet>& GetFacets() const { return this->Facets; }

  /**
   * Returns whether two facets, given by their points, meet in a ridge, a face of one dimension
   * less: no third facet holds all points that they share.
   */
  bool IsRidge(const vtkIsotablePointSet& a, const vtkIsotablePointSet& b) const;

  /// Returns the points of the smallest face that holds all of \a points.
  vtkIsotablePointSet SmallestFace(std::initializer_list<int> points) const;

  /**
   * Returns the facets of the face \a face, which is given by its points: the maximal proper
   * intersections with facets of the hull, in increasing order of point sets.
   */
  std::vector<vtkIsotablePointSet> FacetsOf(const vtkIsotablePointSet& face) const;

private:
  int Dimension;
  std::vector<Facet> Facets;
};

#endif
