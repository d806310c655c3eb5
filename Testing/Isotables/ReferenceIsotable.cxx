// SPDX-License-Identifier: BSD-3-Clause
#include "Isotables/ReferenceIsotable.h"

#include "Cases/CasePatch.h"
#include "Benchmarks/Tables/FacetTriangulation.h"

#include <algorithm>
#include <cstddef>

using namespace interlume;

namespace reference
{

OrientedSimplex Orient(const std::vector<int>& slots)
{
  OrientedSimplex sorted = slots;
  int inversions = 0;
  for (std::size_t i = 0; i < slots.size(); ++i)
  {
    for (std::size_t j = i + 1; j < slots.size(); ++j)
    {
      inversions += slots[i] > slots[j];
    }
  }
  std::sort(sorted.begin(), sorted.end());
  sorted.push_back(inversions & 1);
  return sorted;
}

std::multiset<OrientedSimplex> PullExactly(
  const Polytope& cell, bool isInterval, std::uint32_t key, const std::vector<int>& slotRanks)
{
  const int n = static_cast<int>(cell.Vertices.size());
  const int m = static_cast<int>(cell.Edges.size());
  const Polytope lifted = isInterval ? cell.Prism() : cell;
  // The lifted cell's edges are those of the lower copy, those of the upper copy, and the vertical
  // edges.
  const auto toSlot = [=](int edge) { return edge < 2 * m ? n + edge : edge - 2 * m; };
  std::vector<int> ranks;
  for (std::size_t e = 0; e < lifted.Edges.size(); ++e)
  {
    ranks.push_back(slotRanks[toSlot(static_cast<int>(e))]);
  }
  std::multiset<OrientedSimplex> result;
  for (std::vector<int> simplex :
    FacetTriangulation::Triangulate(CasePatch(lifted, CasePatch::GetSigns(n, isInterval, key)),
      FacetTriangulation::PULLING, ranks))
  {
    std::transform(simplex.begin(), simplex.end(), simplex.begin(), toSlot);
    result.insert(Orient(simplex));
  }
  return result;
}

}
