// SPDX-License-Identifier: BSD-3-Clause
#ifndef VortexShares_h
#define VortexShares_h

#include "Benchmarks/SpaceTime/Interval4dCases.h"

namespace interval4d
{
/**
 * f >= c of the field VORTEX at times 0 and 1 on points^3 points, where c is chosen so that a share
 * of the points is inside at time 0: the size of the output is changed while the grid stays.
 */
class VortexShares
{
public:
  explicit VortexShares(int points);

  /// Chooses c. Returns false, and changes nothing, where not one point would be inside.
  bool SetShare(double share);
  const Case& Get() const { return this->What; }

private:
  Case What;
  /// The values of the first step, the largest first.
  std::vector<double> Values;
};
}

#endif
