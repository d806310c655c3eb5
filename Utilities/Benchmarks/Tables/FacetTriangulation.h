// SPDX-License-Identifier: BSD-3-Clause
#ifndef FacetTriangulation_h
#define FacetTriangulation_h

#include "Cases/CasePatch.h"

#include <vector>

/**
 * @class   FacetTriangulation
 * @brief   cuts the facets of a patch into simplices in a given order of the points
 *
 * Both methods depend on a face only through the order of its own points, so that two cells which
 * order the points of their common face alike cut it alike.
 * - Placing: points are added in order; each is joined to the faces of the simplices so far that it
 *   sees (a coplanar one is not seen), as in C. Zhang, dissertation, Ohio State 2006, section 3.3.
 * - Pulling: a face is coned from its first point over its faces that do not hold that point.
 *
 * Every simplex has the orientation of its facet. \a rank has one entry for each edge of
 * the cell; equal ranks must not occur among the points of a facet.
 */
class FacetTriangulation
{
public:
  using PointList = interlume::CasePatch::PointList;

  enum Methods
  {
    PLACING,
    PULLING
  };

  static std::vector<PointList> Triangulate(
    const interlume::CasePatch& patch, Methods method, const std::vector<int>& rank);

  static std::vector<PointList> TriangulateFacet(const interlume::CasePatch& patch,
    const interlume::CasePatch::Facet& facet, Methods method, const std::vector<int>& rank);
};

#endif
