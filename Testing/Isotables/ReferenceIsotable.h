// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceIsotable_h
#define ReferenceIsotable_h

#include "Hulls/Polytope.h"

#include <cstdint>
#include <set>
#include <vector>

namespace reference
{

/// A simplex as its sorted slots followed by the parity of the sorting: equal for equal
/// orientation.
using OrientedSimplex = std::vector<int>;
OrientedSimplex Orient(const std::vector<int>& slots);

/// The exact pulling triangulation of a case, an interval's or a contour's, in an order of the
/// slots.
std::multiset<OrientedSimplex> PullExactly(const interlume::Polytope& cell, bool isInterval,
  std::uint32_t key, const std::vector<int>& slotRanks);

}

#endif
