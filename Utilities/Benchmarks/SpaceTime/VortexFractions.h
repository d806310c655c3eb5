// SPDX-License-Identifier: BSD-3-Clause
#ifndef VortexFractions_h
#define VortexFractions_h

#include "Benchmarks/SpaceTime/Interval4dCases.h"

namespace interval4d
{
/**
 * The region f >= c of the field VORTEX of vtkAnalyticFieldSource at times 0 and 1, sampled on
 * points^3 points. c is chosen so that a given fraction of the points is inside at time 0. The
 * fraction changes the size of the output but not the grid.
 */
class VortexFractions
{
public:
  explicit VortexFractions(int points);

  /// Sets c so that \a fraction of the points is inside. Returns false and changes nothing if no
  /// point would be inside.
  bool SetFraction(double fraction);
  const Case& Get() const { return this->What; }

private:
  Case What;
  /// Field values at time 0, in descending order.
  std::vector<double> Values;
};
}

#endif
