// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceIsotable_h
#define ReferenceIsotable_h

#include "Hulls/Polytope.h"

#include <cstdint>
#include <set>
#include <vector>

namespace reference
{

/// The sorted slots of a simplex, followed by the parity of the permutation that sorts them. Two
/// simplices with the same slots and the same orientation compare equal.
using OrientedSimplex = std::vector<int>;
OrientedSimplex Orient(const std::vector<int>& slots);

/// Returns the pulling triangulation of an interval or contour case, computed from the case's
/// convex hull. \a slotRanks defines the order of the slots.
std::multiset<OrientedSimplex> PullExactly(const interlume::Polytope& cell, bool isInterval,
  std::uint32_t key, const std::vector<int>& slotRanks);

}

#endif
