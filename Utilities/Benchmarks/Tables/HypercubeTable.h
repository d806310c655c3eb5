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
 * The 384 rotations and reflections of the cube reduce the cases to 132,102 classes; the patch is
 * computed for one case of each class. A triangulation in a fixed order is not symmetric, so the
 * number of simplices is counted for each of the 384 images. Each patch facet belongs to an orbit
 * of facets and is triangulated once for each image of the facet.
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

  /// Order of the points, by edge of the lifted cube, and the method that cuts facets in that
  /// order.
  struct Rule
  {
    FacetTriangulation::Methods Method;
    std::vector<int> Ranks;
  };

  /**
   * Returns one result for each rule. Counts every \a stride-th class of cases; 1 counts all.
   */
  static std::vector<Statistics> Count(const std::vector<Rule>& rules, int stride);
};

#endif
