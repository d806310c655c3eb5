// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Intervals/ReferenceIsotable.h"

#include "vtkIsotablePatch.h"
#include "vtkIsotableTriangulation.h"

#include <algorithm>
#include <cstddef>

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

std::vector<bool> GetSigns(int numberOfVertices, bool isInterval, std::uint32_t key)
{
  const std::uint32_t base = isInterval ? 3 : 2;
  std::vector<bool> positive(isInterval ? 2 * numberOfVertices : numberOfVertices);
  for (int v = 0; v < numberOfVertices; ++v, key /= base)
  {
    positive[v] = key % base >= 1;
    if (isInterval)
    {
      positive[v + numberOfVertices] = key % base == 2;
    }
  }
  return positive;
}

std::multiset<OrientedSimplex> PullExactly(const vtkIsotablePolytope& cell, bool isInterval,
  std::uint32_t key, const std::vector<int>& slotRanks)
{
  const int n = static_cast<int>(cell.Vertices.size());
  const int m = static_cast<int>(cell.Edges.size());
  const vtkIsotablePolytope lifted = isInterval ? cell.Prism() : cell;
  // The lifted cell has the edges of the lower side, of the upper side, and those at the vertices.
  const auto toSlot = [=](int edge) { return edge < 2 * m ? n + edge : edge - 2 * m; };
  std::vector<int> ranks;
  for (std::size_t e = 0; e < lifted.Edges.size(); ++e)
  {
    ranks.push_back(slotRanks[toSlot(static_cast<int>(e))]);
  }
  std::multiset<OrientedSimplex> result;
  for (std::vector<int> simplex :
    vtkIsotableTriangulation::Triangulate(vtkIsotablePatch(lifted, GetSigns(n, isInterval, key)),
      vtkIsotableTriangulation::PULLING, ranks))
  {
    std::transform(simplex.begin(), simplex.end(), simplex.begin(), toSlot);
    result.insert(Orient(simplex));
  }
  return result;
}

}
