// SPDX-License-Identifier: BSD-3-Clause
#ifndef HypercubeTable_h
#define HypercubeTable_h

#include "Benchmarks/Tables/FacetTriangulation.h"

#include <cstdint>
#include <vector>

/**
 * @class   HypercubeTable
 * @brief   counts the simplices in all 3^16 cases of the interval table of the 4D cube
 *
 * The 384 rotations and reflections of the cube reduce the cases to 132,102 classes. The patch is
 * computed for one case of each class. A triangulation in a fixed order is not symmetric, so
 * simplices are counted for each of the 384 images of that case. The facets of all patches form
 * orbits under the symmetries. Each image in an orbit is triangulated only once.
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

  /// A triangulation method and the order of the points, given as the rank of the point on each
  /// edge of the lifted cube.
  struct Rule
  {
    FacetTriangulation::Methods Method;
    std::vector<int> Ranks;
  };

  /**
   * Returns the statistics of each rule, for every \a stride-th class of cases. With stride 1, all
   * classes are counted.
   */
  static std::vector<Statistics> Count(const std::vector<Rule>& rules, int stride);
};

#endif
