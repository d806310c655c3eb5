// SPDX-License-Identifier: BSD-3-Clause
#ifndef HypercubeTable_h
#define HypercubeTable_h

#include "Benchmarks/Tables/FacetTriangulation.h"

#include <cstdint>
#include <vector>

/**
 * @class   HypercubeTable
 * @brief   counts over all 3^16 cases of the interval table of the four-dimensional cube
 *
 * The 384 rotations and reflections of the cube leave 132,102 cases; the patch is computed for one
 * of each kind. A triangulation in a fixed order is not symmetric, so the number of simplices is
 * then found for every one of the 384 images: each patch facet belongs to an orbit of facets, and
 * is triangulated once for each image of the facet.
 */
class HypercubeTable
{
public:
  struct Statistics
  {
    std::uint64_t Cases = 0;
    std::uint64_t CasesUpToSymmetry = 0;
    std::uint64_t FacetOrbits = 0;
    std::uint64_t Facets = 0;
    std::uint64_t Sum = 0;
    int Maximum = 0;
    std::uint64_t CasesAtMaximum = 0;
  };

  /// How the points are ordered, by edge of the lifted cube, and how facets are cut in that order.
  struct Rule
  {
    FacetTriangulation::Methods Method;
    std::vector<int> Ranks;
  };

  /**
   * One result for each rule. Takes every \a stride th kind of case: 1 for all.
   */
  static std::vector<Statistics> Count(const std::vector<Rule>& rules, int stride);
};

#endif
