// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSpaceTime_h
#define ReferenceSpaceTime_h

#include "Support/TimeVarying/ReferenceTimeSteps.h" // for the steps

#include <array>  // for points
#include <vector> // for values

/**
 * Hypervolumes and durations of regions in space-time, in long double.
 */
namespace reference
{

using SpaceTimePoint = std::array<long double, 4>; ///< (x,y,z,t)

/// Returns the signed hypervolume of a 4-simplex, det(p1-p0, p2-p0, p3-p0, p4-p0) / 24.
long double SimplexHypervolume(const std::array<SpaceTimePoint, 5>& points);

/**
 * Returns the fraction of a simplex of any dimension where a linear function is at most \a bound.
 * \a values are the values at its vertices. Uses the recurrence of Varsi ("The multidimensional
 * content of the frustum of the simplex", Pacific J. Math. 46, 1973), whose terms are all positive.
 */
long double FractionBelow(const std::vector<long double>& values, long double bound);

/**
 * Returns the hypervolume of the region where lower <= array <= upper between the first and the
 * last step. Each cell is split into tetrahedra, and the prism that a tetrahedron forms between two
 * steps is split into four 4-simplices. The result is exact for functions that are linear in space
 * and time if boundary faces stay in planes that move linearly. On static tetrahedra, it is exact
 * for functions that are linear in each tetrahedron between two steps.
 */
long double HypervolumeBetween(
  const TimeSteps& steps, const char* array, double lower, double upper);

/// Returns the hypervolume of the domain between the first and the last step. The result is
/// exact under the same conditions as for HypervolumeBetween().
long double DomainHypervolume(const TimeSteps& steps);

/**
 * Returns the time during which lower <= array <= upper at a point. The grid must consist of static
 * tetrahedra, and the function must be linear in space and time in each tetrahedron between two
 * steps. Returns 0 outside the grid.
 */
long double DurationAt(const TimeSteps& steps, const char* array, double lower, double upper,
  const std::array<double, 3>& point);

}

#endif
