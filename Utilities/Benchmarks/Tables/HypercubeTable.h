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
 * computed for one case of each class. A triangulation in a fixed order is not symmetric, so
 * simplices are counted for each of the 384 images of the case. Each facet of a patch belongs to an
 * orbit of facets. Facets are triangulated once for each image in the orbit.
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

  /// Rank of the point on each edge of the lifted cube, and the method that cuts facets in the
  /// order of the ranks.
  struct Rule
  {
    FacetTriangulation::Methods Method;
    std::vector<int> Ranks;
  };

  /**
   * Returns the statistics for each rule, over every \a stride-th class of cases. With stride 1,
   * all classes are counted.
   */
  static std::vector<Statistics> Count(const std::vector<Rule>& rules, int stride);
};

#endif
