// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceSpaceTime_h
#define ReferenceSpaceTime_h

#include "Support/TimeVarying/ReferenceTimeSteps.h" // for the steps

#include <array>  // for points
#include <vector> // for values

/**
 * Measures of regions of space and time, in long double.
 */
namespace reference
{

using SpaceTimePoint = std::array<long double, 4>; ///< (x,y,z,t)

/// The signed hypervolume of a 4-simplex: det(p1-p0, p2-p0, p3-p0, p4-p0) / 24.
long double SimplexHypervolume(const std::array<SpaceTimePoint, 5>& points);

/**
 * The share of a simplex of any dimension where a linear function is at most \a bound; \a values
 * are those at its vertices. By the recurrence of Varsi ("The multidimensional content of the
 * frustum of the simplex", Pacific J. Math. 46, 1973), all of whose terms are positive.
 */
long double ShareBelow(const std::vector<long double>& values, long double bound);

/**
 * The hypervolume where lower <= array <= upper between the first and the last step, slab by slab,
 * each cell cut into tetrahedra and each tetrahedron times a slab into four 4-simplices. Exact for
 * functions linear in space and time when the domain's faces stay in planes that move linearly; on
 * tetrahedra that do not move, for functions linear in space and time in each.
 */
long double HypervolumeBetween(
  const TimeSteps& steps, const char* array, double lower, double upper);

/// The hypervolume of everything between the first and the last step, under the same conditions.
long double DomainHypervolume(const TimeSteps& steps);

/**
 * How long lower <= array <= upper at a point between the first and last of some steps of a grid of
 * tetrahedra that does not move, for functions linear in space and time in each; 0 outside the
 * grid.
 */
long double DurationAt(const TimeSteps& steps, const char* array, double lower, double upper,
  const std::array<double, 3>& point);

}

#endif
