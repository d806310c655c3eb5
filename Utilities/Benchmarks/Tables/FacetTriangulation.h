// SPDX-License-Identifier: BSD-3-Clause
#ifndef FacetTriangulation_h
#define FacetTriangulation_h

#include "Cases/CasePatch.h"

#include <vector>

/**
 * @class   FacetTriangulation
 * @brief   triangulates the facets of a patch, based on a given order of the points
 *
 * The triangulation of a face depends only on the order of its points. Two cells that order the
 * points of their common face in the same way therefore triangulate it in the same way. Methods:
 * - Placing: points are added in order. Each point is joined to those faces of the existing
 *   simplices that are visible from it (coplanar faces are not), as in C. Zhang, dissertation, Ohio
 *   State 2006, section 3.3.
 * - Pulling: the first point of a face is joined to the simplices of all subfaces that do not
 *   contain it, which are triangulated in the same way.
 *
 * All simplices have the orientation of their facet. \a rank defines the order of the points. It
 * has one entry for each edge of the cell, since each point is on an edge. Points of a facet must
 * have different ranks.
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
