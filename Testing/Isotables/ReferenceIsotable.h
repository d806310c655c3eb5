// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceIsotable_h
#define ReferenceIsotable_h

#include "Hulls/Polytope.h"

#include <cstdint>
#include <set>
#include <vector>

namespace reference
{

/// A simplex as its sorted slots followed by the parity of the permutation that sorts them. Two
/// simplices with equal orientation compare equal.
using OrientedSimplex = std::vector<int>;
OrientedSimplex Orient(const std::vector<int>& slots);

/// Returns the exact pulling triangulation of an interval or contour case for the given slot order.
std::multiset<OrientedSimplex> PullExactly(const interlume::Polytope& cell, bool isInterval,
  std::uint32_t key, const std::vector<int>& slotRanks);

}

#endif
