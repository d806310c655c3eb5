// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_BreakdownVortex_h
#define interlume_BreakdownVortex_h

namespace interlume
{

/**
 * @class   BreakdownVortex
 * @brief   a leading-edge vortex that swells along a delta wing and breaks down into a spiral, at
 * one time
 *
 * The formula is in vtkDeltaWingSource.
 */
class BreakdownVortex
{
public:
  /// Makes a vortex. \a side is 1 or -1, the sign of y, \a slope the half span per unit of length
  /// along the wing, \a breakdown the x of the breakdown, \a phase the spiral's phase at the
  /// breakdown, in radians.
  BreakdownVortex(double side, double slope, double breakdown, double phase)
    : Side(side)
    , Slope(slope)
    , Breakdown(breakdown)
    , Phase(phase)
  {
  }

  double operator()(const double x[3]) const;

private:
  double Side;
  double Slope;
  double Breakdown;
  double Phase;
};

}

#endif
